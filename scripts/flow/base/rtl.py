# SPDX-License-Identifier: Apache-2.0
"""Where the VHDL of each configuration stands, generated_rtl/FAMILY/NAME/, and what its entities are called."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, cast

from .errors import FlowError
from .tools import ROOT

GENERATED_RTL = ROOT / "generated_rtl"
HAND_WRITTEN = ROOT / "hls" / "rtl"
MEMORY_CELL = HAND_WRITTEN / "line_memory.vhd"  # of all cores


class Port(NamedTuple):
    """Of a core, but for its clock and reset."""

    name: str
    direction: str
    lane_bits: int | None  # of a row, P rows side by side; None: one bit for all
    meaning: str = ""
    bits: int | None = None  # of all rows together, whatever the lanes


DISPARITY = 0  # lane_bits of the port that is as wide as the configuration says
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


class Setting(NamedTuple):
    """That a port of the core brings with each start of frame (hls/support/settings.hpp)."""

    name: str
    bits: int
    largest: int  # it is 0 ... largest; 0: the core has nothing that it sets
    start: int  # what it is after a reset


def settings_of(parameters: Mapping[str, Any]) -> tuple[Setting, ...]:
    """Of a configuration, in the order of their ports; none where they are constants."""
    return tuple(Setting(**setting) for setting in cast(list[dict[str, Any]], parameters.get("settings", [])))


def ports_with(settings: Sequence[Setting]) -> tuple[Port, ...]:
    """All of a core with these settings."""
    first_output = next(place for place, port in enumerate(PORTS) if port.direction == "out")
    taken = [
        Port(setting.name, "in", None, f"0 ... {setting.largest}, taken over with start_of_frame", setting.bits)
        for setting in settings
    ]
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


def core_entity(config: str) -> str:
    return f"stereo_core_{config}"


def ip_entity(config: str) -> str:
    """The core between AXI4-Streams."""
    return f"stereo_ip_{config}"


def port_type(port: Port, pixels: int, disparity_bits: int) -> str:
    """In VHDL."""
    if port.bits is not None:
        return f"std_logic_vector({port.bits - 1} downto 0)"
    if port.lane_bits is None:
        return "std_logic"
    return f"std_logic_vector({(port.lane_bits or disparity_bits) * pixels - 1} downto 0)"


def known_configurations() -> list[str]:
    """The folders with a manifest."""
    return sorted(path.parent.name for path in GENERATED_RTL.glob("*/*/manifest.json"))


def folder(config: str) -> Path:
    """generated_rtl/FAMILY/NAME of a configuration whose VHDL was made."""
    found = [path.parent for path in GENERATED_RTL.glob(f"*/{config}/manifest.json")]
    if len(found) != 1:
        raise FlowError(f"no generated VHDL for '{config}'; run scripts/synthesize.py --config {config}")
    return found[0]
