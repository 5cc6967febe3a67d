# SPDX-License-Identifier: Apache-2.0
"""The tables of named configurations, as the C++ has them (hls/FAMILY/configurations.hpp): those of matching cores, and
those of stages in front of them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypedDict, cast

from .errors import EXIT_TOOL_FAILED, FlowError, alike
from .tools import find_stereo_hls, run


class Size(TypedDict):
    """What published systems say of themselves."""

    width_px: int
    height_px: int
    disparities: int


class Parameters(Size):
    """What is known of every configuration, whatever its family: hls/support/image.hpp, schedule.hpp. The options of
    its family stand beside these."""

    family: str
    pixels_per_clock: int
    output_width_px: int
    output_height_px: int
    disparity_bits: int
    latency_clocks: int
    groups_to_first_output: int
    flush_groups: int
    gap_groups: int


class Configuration(Parameters):
    """One row of the table, with what says nothing about the hardware or follows from what does."""

    use: str  # what it is there for
    description: str  # such as "320x240, 100 disparities, window 3x3"
    options: list[str]  # "name value" of the options that are not the family's defaults
    output_first_column: int  # of the reference image: where the map begins. Not of stages
    source_folder: str  # of the family's core, from the project's root


PLANNED = "planned"  # the use of a row whose VHDL is not made yet
_ABOUT = ("use", "description", "options", "source_folder", "output_first_column")


def parameters_of(row: Configuration) -> Parameters:
    """What decides the hardware."""
    kept = {key: value for key, value in row.items() if key not in _ABOUT}
    return cast(Parameters, kept)


def outputs_per_frame(parameters: Parameters) -> int:
    """Each of as many disparities as there are pixel pairs a clock."""
    return parameters["output_width_px"] * parameters["output_height_px"] // parameters["pixels_per_clock"]


def clocks_per_pixel(parameters: Mapping[str, Any]) -> int:
    """Least clocks from one group of pixel pairs to the next."""
    return cast(int, parameters.get("clocks_per_pixel", 1))


def option(parameters: Parameters, name: str) -> Any:
    """One of the family's options, which the types above do not know; None when the family has no such option."""
    return cast(dict[str, Any], parameters).get(name)


@cache
def _text(program: str, changed_ns: int, *words: str) -> str:
    """What the program says, asked once for each time that it was built."""
    return run([program, *words, "--json"])


def _listed(*words: str) -> dict[str, Any]:
    program = find_stereo_hls()
    try:
        table: dict[str, Any] = json.loads(_text(program, Path(program).stat().st_mtime_ns, *words))
    except ValueError:
        raise FlowError(f"{program} does not list {words[0]} as stereo_hls does", EXIT_TOOL_FAILED) from None
    return table


def configurations() -> dict[str, Configuration]:
    """Of matching cores."""
    return _listed("configurations")


def options() -> dict[str, dict[str, dict[str, Any]]]:
    """{family: {option: its default, limits or words, meaning}}, of stages, too."""
    return _listed("options")


def matching_options(config: str, settings: Mapping[str, str] | None = None) -> dict[str, Any]:
    """The options of a configuration's algorithm, some of them set. A FlowError says why that cannot be."""
    words = [word for name, value in (settings or {}).items() for word in ("--set", f"{name}={value}")]
    text = run([find_stereo_hls(), "options", "--config", config, *words, "--json"], passes_errors=True)
    found: dict[str, Any] = json.loads(text)
    return found


def designs() -> dict[str, Configuration]:
    """Of matching cores and of stages, which have no disparities: all that VHDL is made of."""
    return configurations() | _listed("configurations", "--stages")


def configuration(name: str, table: dict[str, Configuration] | None = None) -> Configuration:
    """One row of the table, which is asked for where it is not given."""
    table = configurations() if table is None else table
    if name not in table:
        known = alike(name, table) or f"known are: {', '.join(sorted(table))}"
        raise FlowError(f"unknown configuration '{name}'; {known}")
    return table[name]
