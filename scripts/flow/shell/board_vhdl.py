# SPDX-License-Identifier: Apache-2.0
"""The VHDL of the boards' design: examples/boards, around the core of any configuration that a serial line can feed."""

from __future__ import annotations

from pathlib import Path

from ..base import committed, rtl
from ..base.errors import FlowError
from ..base.files import write
from ..base.tools import ROOT
from ..synthesis import manifest
from . import design, template

FOLDER = ROOT / "examples" / "boards"
TOP = "board_top"
CORE_FILE = "board_core.vhd"  # written for each configuration; that of CONFIG is committed
CONFIG = "tiny"
# In compile order, behind the core's own file.
BY_HAND = tuple(
    FOLDER / f"{name}.vhd"
    for name in (
        "uart_receiver",
        "uart_transmitter",
        "serial_source",
        "serial_sink",
        "pattern_source",
        "map_check",
        TOP,
    )
)
COMMITTED = (FOLDER / CORE_FILE, *BY_HAND)  # with the core of CONFIG
BENCH = FOLDER / "tb_board_top.vhd"
# What the line's bytes and the noise of the self test are made for.
WANTED = {"pixels_per_clock": 1, "pixel_bits": 8, "disparity_bits": 8, "min_disparity": 0}


def sizes(config: str) -> dict[str, int]:
    """{constant of the package: value}"""
    entry = manifest.read(committed.folder(config))
    parameters = entry["parameters"]
    if rtl.is_stage(parameters):
        raise FlowError(f"'{config}' is a stage in front of a core; it gives no disparities")
    for name, wanted in WANTED.items():
        if parameters.get(name, wanted) != wanted:
            raise FlowError(f"'{config}' has {name} {parameters.get(name)}; the serial line takes cores with {wanted}")
    return {name: design.generics(entry)[name] for name in ("width_px", "height_px", "output_width_px")}


def core_text(config: str) -> str:
    """board_core.vhd: stereo_ip_CONFIG without its registers, and its sizes."""
    constants = sizes(config)
    ports = template.ports(design.generics(manifest.read(committed.folder(config))))
    kept = [port for port in ports if not port.name.startswith("s_axil_") and port.name != "irq"]
    inside = {port.name: port.name for port in kept}
    for port in ports:
        if port not in kept:
            zeros = "'0'" if port.kind == "std_logic" else "(others => '0')"
            inside[port.name] = "open" if port.direction == "out" else zeros
    return "\n".join(
        [
            "-- SPDX-License-Identifier: Apache-2.0",
            f"-- {rtl.ip_entity(config)} for board_top. Do not edit; made by",
            f"--   scripts/build_example.py --config {config} --core FILE",
            "package board_sizes is",
            *(f"  constant {name} : positive := {value};" for name, value in constants.items()),
            "end package;",
            "",
            "library ieee;",
            "use ieee.std_logic_1164.all;",
            "",
            "entity board_core is",
            "  port (",
            ";\n".join(f"    {port.name} : {port.direction} {port.kind}" for port in kept),
            "  );",
            "end entity;",
            "",
            "architecture rtl of board_core is",
            "begin",
            template.instance("stereo", rtl.ip_entity(config), {}, inside),
            "end architecture;",
            "",
        ]
    )


def files(config: str, work: Path) -> list[Path]:
    """All in compile order; the core's own file is written into the folder `work`."""
    core = work / CORE_FILE
    write(core, core_text(config))  # whole: tests side by side share a folder
    return [*design.vhdl_files(config), core, *BY_HAND]
