# SPDX-License-Identifier: Apache-2.0
"""Runs under cocotb that the verification and the mutation run share: a shell whose generics are not those of its core,
and the way of settings."""

from __future__ import annotations

from typing import NamedTuple

from ..base.configurations import configuration
from .cocotb_runs import Selection

GAPS = ("full_speed", "gaps_of_all_lengths", "mixture")
SETTINGS = Selection("tiny_size_all", "test_settings")  # it has each setting of block matching


class OtherGenerics(NamedTuple):
    longest_gap: Selection
    longer_flush: Selection
    short_latency: Selection
    long_latency: Selection
    disabled: Selection


def other_generics(config: str) -> OtherGenerics:
    """Of the shell of a configuration."""
    row = configuration(config)
    latency, least = row["latency_clocks"], max(row["flush_groups"], row["gap_groups"])

    def with_latency(clocks: int, what: str) -> Selection:
        return Selection(config, "test_generics", ("wrong_latency",), {"latency_clocks": clocks}, what)

    def with_gap(generics: dict[str, int | str], what: str) -> Selection:
        return Selection(config, "test_stereo_ip", GAPS, generics, what)

    return OtherGenerics(
        with_gap({"gap_groups": least + 1}, "gap of the whole flush"),
        with_gap({"gap_groups": least + 8, "flush_groups": least + 28}, "gap within a longer flush"),
        with_latency(latency - 1, "latency too short"),
        with_latency(latency + 1, "latency too long"),
        Selection(config, "test_generics", ("starts_disabled",), {"enabled_at_reset": "false"}, "disabled at reset"),
    )
