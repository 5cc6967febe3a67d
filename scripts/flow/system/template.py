# SPDX-License-Identifier: Apache-2.0
"""Writes examples/camera_system/camera_system_NAME.vhd: the joiner, a rectification, a matching core and the depths, in
the shell that every matching core has. The shell takes the three for one core: a pair in gives a depth, later by the
clocks of all, and as many more groups bring out the last rows."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple, cast

from ..base import committed, rtl
from ..base.configurations import Parameters, clocks_per_pixel, configuration, option
from ..base.errors import FlowError
from ..base.tools import ROOT
from ..shell import design, registers
from ..shell.template import core_id, instance, lane_bits, pace_generics, pixel_generics
from ..synthesis import manifest
from . import beside
from .beside import DEPTH_BITS, Beside, vector

FOLDER = ROOT / "examples" / "camera_system"
PARTS = ("camera_tables", "camera_depth")
IMAGE = "camera_image"  # where the left image stands beside the depths
DEPTH_CLOCKS = 2  # of camera_depth, and of camera_image
NODE_BITS = 16  # of a node's place and offsets
CORE = "core"  # the matching core's instance


class System(NamedTuple):
    name: str
    rectification: str
    matching: str
    skew_lines: int = 8  # that either camera may be ahead
    target: str = "ecp5"  # of implement.py: what it is placed and routed on
    left_image: bool = False  # beside the depths
    few_pins: bool = False  # of the target: registers that three pins feed and read stand around it

    @property
    def entity(self) -> str:
        return f"camera_system_{self.name}"

    @property
    def path(self) -> Path:
        return FOLDER / f"{self.entity}.vhd"


class Depths(NamedTuple):
    """The table of camera_depth."""

    subpixel: bool  # an entry for each sixteenth of a pixel
    place_bits: int

    @property
    def entries(self) -> int:
        return 1 << self.place_bits


def depths_of(parameters: Parameters) -> Depths:
    """What the disparities of a matching core need."""
    subpixel = bool(option(parameters, "subpixel"))
    largest = option(parameters, "min_disparity") + parameters["disparities"] - 1
    # Subpixel adds half a pixel at most.
    return Depths(subpixel, (16 * largest + 15 if subpixel else largest).bit_length())


SYSTEMS = {
    system.name: system
    for system in (
        System("tiny", "rectify_tiny", "tiny"),
        System("tiny_checked", "rectify_tiny", "tiny_all"),
        System("tiny_12bit", "rectify_tiny_12bit", "tiny_12bit_all"),
        System("vga", "rectify_vga", "vga_64"),
        System("tiny_sgm_f8", "rectify_tiny_40", "tiny_sgm_f8_all", skew_lines=4),
        System("vga_sgm_f8", "rectify_vga", "sgm_640_64_f8", target="ecp5_45f_grade6"),
        System("tiny_dense", "rectify_tiny", "tiny_dense", left_image=True),
        System("tiny_sgm_f4_dense", "rectify_tiny_40", "tiny_sgm_f4_dense", skew_lines=4, left_image=True),
        System(
            "vga_sgm_f8_dense",
            "rectify_vga",
            "sgm_640_64_f8_dense",
            skew_lines=4,
            target="ecp5_45f_grade6",
            left_image=True,
            few_pins=True,
        ),
    )
}


def _map(beat_bits: int) -> tuple[tuple[str, str, str], ...]:
    """The stream of depths."""
    return (
        ("m_axis_tvalid", "out", "std_logic"),
        ("m_axis_tready", "in", "std_logic"),
        ("m_axis_tdata", "out", vector(beat_bits)),
        ("m_axis_tuser", "out", vector(2)),
        ("m_axis_tlast", "out", "std_logic"),
    )


def _cameras(pixel_bits: int) -> tuple[tuple[str, str, str], ...]:
    """The streams of both."""
    return tuple(
        (f"s_{side}_axis_{name}", direction, kind)
        for side in ("left", "right")
        for name, direction, kind in (
            ("tvalid", "in", "std_logic"),
            ("tready", "out", "std_logic"),
            ("tdata", "in", vector(lane_bits(pixel_bits))),
            ("tuser", "in", vector(1)),
            ("tlast", "in", "std_logic"),
        )
    )


def _lite(prefix: str, address_bits: int, whole: bool) -> tuple[tuple[str, str, str], ...]:
    """An AXI4-Lite port; `whole`: with protection and strobes."""
    word, address = "std_logic_vector(31 downto 0)", f"std_logic_vector({address_bits - 1} downto 0)"
    response = "std_logic_vector(1 downto 0)"
    ports = [
        ("awaddr", "in", address),
        ("awprot", "in", "std_logic_vector(2 downto 0)"),
        ("awvalid", "in", "std_logic"),
        ("awready", "out", "std_logic"),
        ("wdata", "in", word),
        ("wstrb", "in", "std_logic_vector(3 downto 0)"),
        ("wvalid", "in", "std_logic"),
        ("wready", "out", "std_logic"),
        ("bresp", "out", response),
        ("bvalid", "out", "std_logic"),
        ("bready", "in", "std_logic"),
        ("araddr", "in", address),
        ("arprot", "in", "std_logic_vector(2 downto 0)"),
        ("arvalid", "in", "std_logic"),
        ("arready", "out", "std_logic"),
        ("rdata", "out", word),
        ("rresp", "out", response),
        ("rvalid", "out", "std_logic"),
        ("rready", "in", "std_logic"),
    ]
    kept = [port for port in ports if whole or port[0] not in ("awprot", "wstrb", "arprot")]
    return tuple((f"{prefix}_{name}", direction, kind) for name, direction, kind in kept)


_SHELL_LITE, _TABLES_LITE = _lite("s_axil", registers.address_bits(), True), _lite("s_tables_axil", 5, False)


def _signals(pixel_bits: int, disparity_bits: int) -> dict[str, str]:
    """{names: type}"""
    pair, node = 2 * lane_bits(pixel_bits), "node_column, node_row, node_x, node_y"
    words = {f"pair_tdata, {node}": pair} if pair == NODE_BITS else {"pair_tdata": pair, node: NODE_BITS}
    return {
        "reset, core_reset, pair_tvalid, pair_tready, pair_tlast": "std_logic",
        **{names: vector(bits) for names, bits in words.items()},
        "skew_lines, write_disparity, write_mm, depth_mm": vector(DEPTH_BITS),
        "pair_tuser, pixel_valid, depth_known": vector(1),
        "faults": vector(3),
        "left_pixel, right_pixel, rectified_left, rectified_right": vector(pixel_bits),
        "start_of_frame, valid, node_valid, node_right, rectified_start_of_frame, rectified_valid": "std_logic",
        "disparity_valid, disparity_start_of_frame, disparity_end_of_line": "std_logic",
        "depth_valid, depth_start_of_frame, depth_end_of_line": "std_logic",
        "disparity": vector(disparity_bits),
    }


def _check(system: System, stage: dict[str, int], core: dict[str, int], lowest: int) -> None:
    for key in ("width_px", "height_px", "pixels_per_clock", "pixel_bits"):
        if stage[key] != core[key]:
            raise FlowError(
                f"{system.rectification} and {system.matching} differ in {key}: {stage[key]} and {core[key]}"
            )
    if lowest < 0:
        raise FlowError(f"{system.matching} has disparities below 0, which camera_system does not take")


def gap_groups(stage_flush_groups: int, core_gap_groups: int) -> int:
    """Between two frames. The rectification takes the next frame at once, or when all rows of the last one are out: it
    gives a pair for each pair, so a shorter gap would stand among the last rows. Both are whole rows."""
    return max(stage_flush_groups, core_gap_groups) if core_gap_groups else 0


def queue_lines(system: System, parameters: Parameters) -> int:
    """Lines that the joiner's queue of a camera holds: those by which it may be ahead, and where a pair takes several
    clocks two more. One comes faster than it is matched; and a frame that lacks a line may be known by the start of
    the next one only, which then waits while the line is made up."""
    return system.skew_lines + (2 if clocks_per_pixel(parameters) > 1 else 0)


def beside_of(system: System) -> Beside:
    """What stands beside its depths."""
    return beside.of(manifest.read(committed.folder(system.matching))["parameters"], system.left_image)


def text(system: System) -> str:
    """The VHDL of a system."""
    entry, before = (manifest.read(committed.folder(name)) for name in (system.matching, system.rectification))
    core, parameters = design.generics(entry), cast(dict[str, int], before["parameters"])
    stage = {name: parameters[name] for name in rtl.STAGES["rectification"].generics}
    stage_bits, pixel_bits = (rtl.pixel_bits_of(manifest_of["parameters"]) for manifest_of in (before, entry))
    lowest = option(entry["parameters"], "min_disparity")
    _check(system, stage | {"pixel_bits": stage_bits}, core | {"pixel_bits": pixel_bits}, lowest)
    table, more = depths_of(entry["parameters"]), beside_of(system)
    is_more = more.word_bits > DEPTH_BITS
    signals, cameras = _signals(pixel_bits, core["disparity_bits"]), _cameras(pixel_bits)
    stream = _map(more.beat_bits)
    shell: dict[str, int | str] = {
        **core,
        "disparity_bits": more.word_bits,
        "latency_clocks": core["latency_clocks"] + stage["latency_clocks"] + DEPTH_CLOCKS,
        "flush_groups": core["flush_groups"] + stage["flush_groups"],
        "gap_groups": gap_groups(stage["flush_groups"], core["gap_groups"]),
        "core_id": f'x"{core_id(entry)}"',
        "enabled_at_reset": "enabled_at_reset",
        **pixel_generics(pixel_bits),
        **pace_generics(entry["parameters"]),
    }
    outside = [
        ("aclk", "in", "std_logic"),
        ("aresetn", "in", "std_logic"),
        *cameras,
        *stream,
        *_SHELL_LITE,
        *_TABLES_LITE,
    ]
    same = {name: name for name, _, _ in outside}
    pairs = {f"s_axis_{name}": f"pair_{name}" for name in ("tvalid", "tready", "tdata", "tuser", "tlast")}
    clocked = {"aclk": "aclk", "aresetn": "aresetn"}
    to_shell = clocked | pairs | {name: name for name, _, _ in (*stream, *_SHELL_LITE)}
    to_shell |= {f"core_{name}": name for name in ("left_pixel", "right_pixel", "start_of_frame", "valid")}
    to_shell |= {
        "core_reset": "core_reset",
        "core_disparity": "word" if is_more else "depth_mm",
        "core_pixel_valid": "measured" if more.filled else "depth_known",
        "core_disparity_valid": "depth_valid",
        "core_disparity_start_of_frame": "depth_start_of_frame",
        "core_disparity_end_of_line": "depth_end_of_line",
    }
    to_shell |= {"m_axis_tdata": "word_tdata"} if is_more else {}
    joined: dict[str, int] = {name: core[name] for name in ("width_px", "height_px")}
    joined |= {"depth": queue_lines(system, entry["parameters"]) * core["width_px"], **pixel_generics(pixel_bits)}
    joiner = clocked | {name: same[name] for name, _, _ in cameras}
    joiner |= {f"m_axis_{name}": f"pair_{name}" for name in ("tvalid", "tready", "tdata", "tuser", "tlast")}
    joiner |= {"skew_lines": "skew_lines", "faults": "faults"}
    nodes = {name: name for name in ("node_valid", "node_right", "node_column", "node_row", "node_x", "node_y")}
    tables = clocked | {f"s_axil_{name.removeprefix('s_tables_axil_')}": name for name, _, _ in _TABLES_LITE}
    tables |= {"skew_lines": "skew_lines", "faults": "faults", **nodes}
    tables |= {"depth_disparity": "write_disparity", "depth_mm": "write_mm"}
    results = ("disparity", "pixel_valid", "disparity_valid", "disparity_start_of_frame", "disparity_end_of_line")
    matching = {
        "clock": "aclk",
        "reset": "core_reset",
        "left_pixel": "rectified_left",
        "right_pixel": "rectified_right",
    }
    matching |= {"start_of_frame": "rectified_start_of_frame", "valid": "rectified_valid"} | {
        name: name for name in results
    }
    rectification = {"clock": "aclk", "reset": "reset"}
    rectification |= {name: name for name in ("left_pixel", "right_pixel", "start_of_frame", "valid")} | nodes
    rectification |= {port.name: port.name for port in rtl.STAGE_PORTS if port.direction == "out"}
    depth = {"clock": "aclk", "reset": "core_reset", "write_disparity": "write_disparity", "write_mm": "write_mm"}
    depth |= {name: name for name in results} | ({"pixel_valid": "has_depth"} if more.filled else {})
    depth |= {"depth_mm": "depth_mm", "depth_known": "depth_known"}
    depth |= {name: name for name in ("depth_valid", "depth_start_of_frame", "depth_end_of_line")}
    sizes: dict[str, int | str] = {name: parameters[name] for name in ("table_columns", "table_rows")}
    sizes |= {"depth_entries": table.entries, "subpixel": str(table.subpixel).lower()}
    depth_sizes = {"place_bits": table.place_bits, "disparity_bits": core["disparity_bits"]}
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- Two cameras to depths: {system.rectification}, {system.matching}. Do not edit; made by",
        f"--   scripts/camera_system.py --system {system.name} --write",
        "-- examples/camera_system/README.md says what the ports are.",
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        f"entity {system.entity} is",
        "  generic (enabled_at_reset : boolean := true);  -- false: waits for a processor",
        "  port (",
        ";\n".join(f"    {name} : {direction} {kind}" for name, direction, kind in outside),
        "  );",
        "end entity;",
        "",
        f"architecture rtl of {system.entity} is",
        *(f"  signal {names} : {kind};" for names, kind in (signals | beside.signals(more)).items()),
        "begin",
        "  -- A soft reset leaves the tables as they are.",
        "  process (aclk)",
        "  begin",
        "    if rising_edge(aclk) then",
        "      reset <= not aresetn;",
        "    end if;",
        "  end process;",
        "",
        instance("joiner", "stereo_joiner", joined, joiner),
        "",
        instance("shell", "stereo_shell", shell, to_shell),
        "",
        instance("tables", "camera_tables", sizes, tables),
        "",
        instance("rectification", committed.entity(system.rectification), stage, rectification),
        "",
        instance(CORE, rtl.core_entity(system.matching), core, matching),
        "",
        instance("depth", "camera_depth", depth_sizes, depth),
        *(["", beside.image(configuration(system.matching))] if system.left_image else []),
        *(["", *beside.statements(more)] if is_more else []),
        "end architecture;",
        "",
    ]
    return "\n".join(lines)


def vhdl_files(system: System) -> list[Path]:
    """All of a system in compile order."""
    return [
        *manifest.core_files(system.rectification),
        *manifest.core_files(system.matching)[1:],  # the memory cell stands there
        *own_files(system),
    ]


def own_files(system: System) -> list[Path]:
    """Without the generated cores."""
    parts = [FOLDER / f"{name}.vhd" for name in (*PARTS, *([IMAGE] if system.left_image else []))]
    return [*design.shell_files(), *design.joiner_files(), *parts, system.path]
