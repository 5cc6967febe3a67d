# SPDX-License-Identifier: Apache-2.0
"""What the truth of a study's pairs allows: which image can be the reference, and which pixels can count. KITTI has
truth of the left image only."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from ..base.configurations import Configuration, option
from ..base.errors import FlowError

SIDES = ("left", "right")
ONE_SIDED_MASK = "all"  # the other regions need the truth of both images
# Of families that have no option for it.
_FIXED_REFERENCE = {"trellis": "left", "dynamic_range": "right", "absolute_difference": "left"}


class WithTruth(Protocol):
    @property
    def truth_left(self) -> object: ...

    @property
    def truth_right(self) -> object: ...


def known_sides(pairs: Iterable[WithTruth]) -> tuple[str, ...]:
    """The images whose truth every pair has."""
    truths = [(pair.truth_left, pair.truth_right) for pair in pairs]
    known = tuple(side for side, column in zip(SIDES, zip(*truths)) if all(column))
    if not known:
        raise FlowError(
            "give the true disparities of the left image of every pair, or those of the right image of every pair"
        )
    return known


def mask(asked: str | None, known: tuple[str, ...]) -> str:
    """The region that counts: the one asked for, else the best one that the truth has."""
    if len(known) == len(SIDES):
        return asked or "non_occluded"
    if asked not in (None, ONE_SIDED_MASK):
        raise FlowError(
            f"--mask {asked}: needs the truth of both images of every pair; leave --mask out to count every pixel "
            f"of the {known[0]} images that has truth"
        )
    return ONE_SIDED_MASK


def reference_setting(row: Configuration, known: tuple[str, ...]) -> dict[str, object] | None:
    """What makes an image with truth the reference: nothing where it is so already; None where it cannot be."""
    own = option(row, "reference")
    if len(known) == len(SIDES) or (own or _FIXED_REFERENCE.get(row["family"])) in known:
        return {}
    return {"reference": known[0]} if own else None
