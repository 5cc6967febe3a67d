# SPDX-License-Identifier: Apache-2.0
"""docs/features.md follows from the committed files, and its tables say what the files say."""

import shutil

import pytest

from flow.base import committed, files
from flow.base.configurations import configurations, designs
from flow.implementation import record
from flow.pages import features
from flow.synthesis import manifest
from flow_commands import call

AREA = {
    "luts": 5000,
    "synthesis": "synth_ecp5",
    "tools": {"yosys": "Yosys 0.70"},
    "ffs": 4000,
    "memory_bits": 1088,
    "block_rams": 2,
    "memory_in_flip_flops": False,
    "cells": {},
    "fmax_mhz": {"median": 150.0, "best": 150.0, "by_seed": {}},
    "critical_path": {"from": "a", "to": "b", "block": "a"},
}


def rows(text):
    return [line for line in text.splitlines() if line.startswith("| ")]


def test_committed_page_is_up_to_date():
    process = call("features.py", "--check")
    assert process.returncode == 0, process.stderr


def test_every_study_configuration_stands_on_the_page():
    shown = {name for _, members in features.OPTIONS for name, _ in members} | set(features.DEPTHS)
    assert shown == {name for name, row in configurations().items() if row["use"] == "study"}


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """The manifests of two configurations, with results of our making."""
    tiny, family = manifest.read(committed.folder("tiny")), tmp_path / "block_matching"
    for name, luts in (("study", 5000), ("study_lr", 6500)):
        (family / name).mkdir(parents=True)
        entry = tiny | {"configuration": name}
        manifest.write(family / name, entry)
        files.write(family / name / record.FILE, record.merged(family / name, entry, "ecp5", {**AREA, "luts": luts}))
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path)
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    monkeypatch.setattr(
        features,
        "OPTIONS",
        [("plain", [("study", "nothing")]), ("checks", [("study_lr", "left/right"), ("study_none", "not measured")])],
    )
    return family


def test_options_stand_beside_the_plain_core(folders):
    text = features.options_table()
    plain, check, unknown = rows(text)[1:]
    assert "| nothing | 384 |" in plain and "| 5,000 | - | 4,000 |" in plain
    assert "| 6,500 | +1,500 |" in check and "| 150.0 | `study_lr` |" in check
    assert unknown.count("| - ") >= 8


def test_the_page_of_a_missing_result_is_refused(folders):
    shutil.rmtree(folders / "study_lr")
    assert "| `study` |" in features.options_table()


def test_deeper_pixels_stand_beside_those_of_8_bits(monkeypatch):
    monkeypatch.setattr(features, "DEEPER", [("tiny", "tiny_10bit"), ("tiny", "tiny_of_no_folder")])
    [line] = rows(features.pixel_bits_table())[1:]
    narrow, deep = (manifest.read(committed.folder(name))["tool_report"] for name in ("tiny", "tiny_10bit"))
    for kind in ("register_bits", "memory_bits"):
        share = f"{100 * (deep[kind] / narrow[kind] - 1):+.1f} %"
        assert f"| {deep[kind]:,} | {narrow[kind]:,} | {share} |" in line
    assert line.startswith("| block_matching | 10 |") and line.endswith("| `tiny_10bit` | `tiny` |")


def test_pairs_of_pixels_differ_in_their_bits_alone():
    for names in features.DEEPER:
        rows_of = [designs()[name] for name in names]
        differ = {key for key in rows_of[0] if rows_of[0][key] != rows_of[1][key]}
        assert "pixel_bits" in differ and differ <= {"pixel_bits", "options", "description", "use"}, names
