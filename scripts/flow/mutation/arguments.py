# SPDX-License-Identifier: Apache-2.0
"""Why some faults change nothing, where the prover finds no invariant: the two versions differ in many registers, for
ever, in a way that no output depends on. Each argument names the test of what it rests on. A fault counts as argued
only if, besides, streams of other seeds show nothing of it."""

from __future__ import annotations

import re
from typing import NamedTuple

from .mutants import Mutant


class Argument(NamedTuple):
    statement: str  # pattern of the line that has the fault
    change: str  # pattern of what changed
    reason: str
    test: str  # of what it rests on, in scripts/tests/test_mutation_arguments.py


ARGUMENTS = (
    Argument(
        r"rows_(search|reference)_\d+ <= 0;",
        r"0 -> 1$|assignment dropped",
        "the grey value of rows outside the image adds the same cost at all disparities",
        "test_rows_outside_may_have_any_grey_value",
    ),
    Argument(
        r"\w+_features_valid <= false;",
        r"false -> true$|assignment dropped",
        "a record in the clock of a reset belongs to no frame, and moves reading and writing alike",
        "test_a_record_in_the_clock_of_a_reset_changes_nothing",
    ),
)


def of(mutant: Mutant) -> Argument | None:
    _, statement, change = mutant.key.split(" | ")[:3]
    for argument in ARGUMENTS:
        if re.fullmatch(argument.statement, statement) and re.search(argument.change, change):
            return argument
    return None
