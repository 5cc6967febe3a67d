# SPDX-License-Identifier: Apache-2.0
"""The entity and the ports of each kind of design: a matching core of any family, or a stage in front of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, cast

from .tools import ROOT

HAND_WRITTEN = ROOT / "hls" / "rtl"
MEMORY_CELL = HAND_WRITTEN / "line_memory.vhd"  # of all cores


class Port(NamedTuple):
    """Of a core, but for its clock and reset."""

    name: str
    direction: str
    lane_bits: int | None  # of a row, P rows side by side; None: one bit for all
    meaning: str = ""
    bits: int | None = None  # of all rows together, whatever the lanes
    held: bool = False  # as in Setting

    @property
    def is_flag(self) -> bool:
        """One bit, and no word."""
        return self.lane_bits is None and self.bits is None


DISPARITY = 0  # lane_bits of the port that is as wide as the configuration says
PIXEL_BITS = 8  # where the configuration does not say
PORTS = (
    Port("left_pixel", "in", 8, "8 bits a row, the upper row in the lowest"),
    Port("right_pixel", "in", 8),
    Port("start_of_frame", "in", None, "with column 0 of the first rows"),
    Port("valid", "in", None, "0: bubble"),
    Port("disparity", "out", DISPARITY),
    Port("pixel_valid", "out", 1, "a bit a row: the disparity has passed every check"),
    Port("disparity_valid", "out", None),
    Port("disparity_start_of_frame", "out", None),
    Port("disparity_end_of_line", "out", None),
)
STAGE_PORTS = (
    Port("left_pixel", "in", 8, "as the cameras send them"),
    Port("right_pixel", "in", 8),
    Port("start_of_frame", "in", None, "with column 0 of the first row"),
    Port("valid", "in", None, "0: bubble"),
    Port("node_valid", "in", None, "a node of a table: docs/rectification.md"),
    Port("node_right", "in", None, "of the right camera's table"),
    Port("node_column", "in", 16, "of the node, below table_columns"),
    Port("node_row", "in", 16, "below table_rows"),
    Port("node_x", "in", 16, "offset to the right in two's complement"),
    Port("node_y", "in", 16, "offset down"),
    Port("rectified_left", "out", 8),
    Port("rectified_right", "out", 8),
    Port("rectified_start_of_frame", "out", None),
    Port("rectified_valid", "out", None),
)


class Setting(NamedTuple):
    """That a port of the core brings with each start of frame (hls/support/settings.hpp)."""

    name: str
    bits: int
    largest: int  # it is least ... largest; 0: the core has nothing that it sets
    start: int  # what it is after a reset
    least: int = 0
    step: int = 1  # it is a multiple of it
    held: bool = False  # it may change only while the core is reset; else it counts with each start of frame

    def text(self) -> str:
        """For the port in the VHDL."""
        taken = "changes in a reset only" if self.held else "taken over with start_of_frame"
        return f"{self.least} ... {self.largest}, {taken}"


def settings_of(parameters: Mapping[str, Any]) -> tuple[Setting, ...]:
    """Of a configuration, in the order of their ports; none where they are constants."""
    return tuple(Setting(**setting) for setting in cast(list[dict[str, Any]], parameters.get("settings", [])))


def pixel_bits_of(parameters: Mapping[str, Any]) -> int:
    """Of a grey value."""
    return cast(int, parameters.get("pixel_bits", PIXEL_BITS))


def ports_of(parameters: Mapping[str, Any]) -> tuple[Port, ...]:
    """All of a matching core."""
    return _with_pixels(ports_with(settings_of(parameters)), pixel_bits_of(parameters))


def _with_pixels(ports: Sequence[Port], bits: int) -> tuple[Port, ...]:
    """The same with grey values of so many bits."""

    def wide(port: Port) -> Port:
        if port.name not in ("left_pixel", "right_pixel", "rectified_left", "rectified_right"):
            return port
        return port._replace(lane_bits=bits, meaning=port.meaning.replace(f"{PIXEL_BITS} bits", f"{bits} bits"))

    return tuple(map(wide, ports))


def ports_with(settings: Sequence[Setting]) -> tuple[Port, ...]:
    """All of a core of 8 bits with these settings."""
    first_output = next(place for place, port in enumerate(PORTS) if port.direction == "out")
    taken = [Port(setting.name, "in", None, setting.text(), setting.bits, setting.held) for setting in settings]
    return (*PORTS[:first_output], *taken, *PORTS[first_output:])


# What a user of the VHDL states of a core; the core refuses what it is not.
GENERICS = (
    "width_px",
    "height_px",
    "disparities",
    "pixels_per_clock",
    "disparity_bits",
    "output_width_px",
    "latency_clocks",
    "flush_groups",
    "gap_groups",
)


class Kind(NamedTuple):
    """A kind of design that goes through the flow."""

    top: str  # the C++ file that the synthesis tool takes, from the project's root
    macros: tuple[str, ...]  # which of its ports there are
    function: str  # in that file
    prefix: str  # of its entity's name
    title: str  # for the first line of its VHDL
    ports: tuple[Port, ...]
    generics: tuple[str, ...]  # what a user of the VHDL states of it
    valid: str  # the output that says whether the words of the others count
    word: tuple[str, ...]  # the outputs that are compared as one number, the highest first

    def entity(self, config: str) -> str:
        return self.prefix + config

    @property
    def held(self) -> tuple[str, ...]:
        """Inputs that change in a reset only."""
        return tuple(port.name for port in self.ports if port.held)

    @property
    def words(self) -> tuple[str, ...]:
        """Outputs that are more than a flag."""
        return tuple(port.name for port in self.ports if port.direction == "out" and not port.is_flag)


CORE = Kind(
    "hls/top/stereo_top.cpp",
    (),
    "stereo_core",
    "stereo_core_",
    "Stereo core",
    PORTS,
    GENERICS,
    "disparity_valid",
    ("disparity",),
)
# By the folder that stands where a matching core has its family.
STAGES = {
    "rectification": Kind(
        "hls/top/rectification_top.cpp",
        (),
        "rectification_core",
        "stereo_",
        "Stage in front of a stereo core",
        STAGE_PORTS,
        (
            "width_px",
            "height_px",
            "pixels_per_clock",
            "table_columns",
            "table_rows",
            "latency_clocks",
            "flush_groups",
        ),
        "rectified_valid",
        ("rectified_right", "rectified_left"),
    )
}


def is_stage(parameters: Mapping[str, Any]) -> bool:
    return parameters["family"] in STAGES


def kind_of(parameters: Mapping[str, Any]) -> Kind:
    """Of a configuration."""
    if is_stage(parameters):
        stage = STAGES[parameters["family"]]
        return stage._replace(ports=_with_pixels(stage.ports, pixel_bits_of(parameters)))
    kind = CORE._replace(ports=ports_of(parameters))
    settings = settings_of(parameters)
    if not settings:
        return kind
    sized = any(setting.held for setting in settings)
    return kind._replace(macros=("STEREO_SETTINGS", *(["STEREO_SIZE"] if sized else [])))


def core_entity(config: str) -> str:
    return CORE.entity(config)


def ip_entity(config: str) -> str:
    """The core between AXI4-Streams."""
    return f"stereo_ip_{config}"


def port_type(port: Port, pixels: int, disparity_bits: int) -> str:
    """In VHDL."""
    if port.is_flag:
        return "std_logic"
    return f"std_logic_vector({port_bits(port, pixels, disparity_bits) - 1} downto 0)"


def port_bits(port: Port, pixels: int, disparity_bits: int) -> int:
    """How wide it is."""
    if port.bits is not None:
        return port.bits
    return 1 if port.lane_bits is None else (port.lane_bits or disparity_bits) * pixels
