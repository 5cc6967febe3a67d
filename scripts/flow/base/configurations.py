# SPDX-License-Identifier: Apache-2.0
"""The table of named configurations, as the C++ has it (hls/configurations.hpp)."""

import json
from typing import TypedDict

from .errors import EXIT_TOOL_FAILED, FlowError
from .tools import find_stereo_hls, run


class Size(TypedDict):
    """What published systems say of themselves."""

    width_px: int
    height_px: int
    disparities: int


class Parameters(Size):
    """One row of the table: hls/stereo_config.hpp defines what each means."""

    # What is computed.
    min_disparity: int
    window_px: int
    reference: str
    cost: str
    census_width_px: int
    census_height_px: int
    prefilter: str
    prefilter_cap: int
    ties: str
    left_right_threshold: int
    uniqueness_percent: int
    texture_threshold: int
    subpixel: bool
    median: bool
    # How the core is built.
    pixels_per_clock: int
    aggregation: str
    cost_clocks: int
    winner_group: int
    slice_disparities: int
    # What follows from both.
    output_width_px: int
    output_height_px: int
    disparity_bits: int
    latency_clocks: int
    groups_to_first_output: int
    flush_groups: int
    gap_groups: int


def configurations() -> dict[str, Parameters]:
    program = find_stereo_hls()
    try:
        table: dict[str, Parameters] = json.loads(run([program, "configurations", "--json"]))
    except ValueError:
        raise FlowError(f"{program} does not list configurations as stereo_hls does", EXIT_TOOL_FAILED) from None
    return table


def configuration(name: str, table: dict[str, Parameters] | None = None) -> Parameters:
    """One row of the table, which is asked for where it is not given."""
    table = configurations() if table is None else table
    if name not in table:
        raise FlowError(f"unknown configuration '{name}'; known are: {', '.join(sorted(table))}")
    return table[name]
