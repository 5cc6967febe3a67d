# SPDX-License-Identifier: Apache-2.0
"""Why some faults change nothing, where the prover finds no invariant: the two versions differ in many registers, for
ever, in a way that no output depends on. Each argument names the test of what it rests on. A fault counts as argued
only if, besides, streams of other seeds show nothing of it."""

from __future__ import annotations

import re
from typing import NamedTuple

from ..base import rtl
from .mutants import Mutant


class Argument(NamedTuple):
    statement: str  # pattern of the line that has the fault
    change: str  # pattern of what changed
    reason: str
    test: str  # of what it rests on, in scripts/tests/test_mutation_arguments.py
    core: str = ""  # the one of which it holds, where its sizes count


ARGUMENTS = (
    Argument(
        r"rows_(search|reference)_\d+ <= 0;",
        r"0 -> 1$|assignment dropped",
        "the grey value of rows outside the image adds the same cost at all disparities",
        "test_rows_outside_may_have_any_grey_value",
    ),
    Argument(
        r"(\w+_features|transform_filtering_\d+)_valid <= false;",
        r"false -> true$|assignment dropped",
        "a record in the clock of a reset belongs to no frame, and moves reading and writing alike",
        "test_a_record_in_the_clock_of_a_reset_changes_nothing",
    ),
    Argument(
        r"transform_filtering_\d+_start_of_frame <= false;",
        r"false -> true$|assignment dropped",
        "a start of frame counts with a valid record only, and in the clock of a reset none is valid",
        "test_a_start_in_the_clock_of_a_reset_does_not_count",
    ),
    Argument(
        r"(entry_next_tag|delay_tag|rows_\w*tag|slice0_tag_\d+|slice0(shift|cost\w*|window)_tag)_valid <= false;",
        r"false -> true$|assignment dropped",
        "a column in the clock of a reset is none of a map, and such columns come between rows, too",
        "test_a_column_in_the_clock_of_a_reset_changes_nothing",
    ),
    Argument(
        r"slice0window_centre_map_column_0 <= false;",
        r"false -> true$|assignment dropped",
        "a row that has begun before the first start of frame counts as none",
        "test_a_row_that_begins_with_a_reset_counts_as_none",
    ),
    Argument(
        r"raster_place_column <= 0;",
        r"0 -> 1$|assignment dropped",
        "before a start of frame no record belongs to a row, and the start begins with column 0",
        "test_records_before_a_start_may_have_any_column",
    ),
    Argument(
        r"delay_row_inside_1 <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;",
        r"and -> or",
        "a window of three rows whose middle row is outside the image belongs to no row of the map",
        "test_rows_beside_the_map_may_have_any_cost",
        "tiny_sgm",
    ),
    Argument(
        r"\w*order_falls <= false;",
        r"false -> true$|assignment dropped",
        "rows are turned round upward and downward in turn, whichever comes first",
        "test_the_first_row_may_be_turned_downward",
    ),
    Argument(
        r"(\w*turn_write_place|transform_write_column) <= 0;",
        r"0 -> 1$|assignment dropped",
        "what a column writes before the first one of a row is written again before it is read",
        "test_the_first_place_that_is_written_may_be_any",
    ),
    Argument(
        r"forward_path_11_value := .*;",
        r"256 -> 512$",
        "the last state falls from itself, which costs as much as to stay and the drop besides",
        "test_the_last_state_never_falls",
        "tiny_trellis",
    ),
    Argument(
        r"forward_occluding_\d+ <= 128;",
        r"assignment dropped",
        "29 columns cost less than half the range of the numbers: what a row leaves loses against the next one",
        "test_what_a_row_leaves_loses_against_the_next_one",
        "tiny_trellis",
    ),
    Argument(
        r"forward_far_\d+_any := \(not entry_tag_valid\) or \(not forward_next_first\);",
        r"column 28: not -> ",
        "the column before the first one of a row is none of the map: nobody reads how its disparities fall",
        "test_the_column_before_a_row_may_fall_anyhow",
    ),
    Argument(
        r"transform_\w+_column_(outer|upper) <= \(?(510|765|1020|1530) - .*",
        r"(510|765|1020|1530) -> ",
        "the sums over columns have weights whose sum is 0: what all rows have in common falls out",
        "test_a_constant_of_all_rows_falls_out",
        "tiny_phase",
    ),
    Argument(
        r"delay_row_inside_[0134] <= .*;",
        r"and -> or",
        "the first and the last rows of an image have no code, so they cost as little as rows outside",
        "test_rows_beside_the_image_have_no_code",
        "tiny_phase",
    ),
    Argument(
        r"if raster_place_group_all then",
        r"raster_place_group_all\) \| 2$",
        "starts of frame leave the transform at least four rows apart, and a next frame waits for two rows",
        "test_no_start_of_frame_comes_while_a_next_frame_waits",
        "tiny_phase",
    ),
    Argument(
        r"raster_place_next_frame_choice_2 := .*;",
        r"and -> or",
        "starts of frame leave the transform at least four rows apart, and a next frame waits for two rows",
        "test_no_start_of_frame_comes_while_a_next_frame_waits",
        "tiny_phase",
    ),
    Argument(
        r"slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;"
        r"|if \(\(slice0winner2_best_index_0_1 / 4\) = 1\) and .*|slice1winner1_best_below_0_0 <= 0;",
        r"assignment dropped|column 50: and -> or",
        "the first and the last disparity have the same neighbour on both sides, and no fraction, whatever it costs",
        "test_the_first_and_the_last_disparity_may_have_any_neighbour",
        "tiny_phase",
    ),
)


def of(mutant: Mutant) -> Argument | None:
    file, statement, change = mutant.key.split(" | ", 2)
    for argument in ARGUMENTS:
        is_of_core = not argument.core or file == f"{rtl.core_entity(argument.core)}.vhd"
        if is_of_core and re.fullmatch(argument.statement, statement) and re.search(argument.change, change):
            return argument
    return None
