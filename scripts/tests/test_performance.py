# SPDX-License-Identifier: Apache-2.0
"""docs/performance.md follows from the committed files, and its tables say what the files say."""

import json
import shutil

import pytest

from flow.base import rtl
from flow.base.errors import FlowError
from flow.implementation import record as implementation
from flow.pages import performance
from flow.synthesis import manifest
from flow_commands import call, refused

AREA = {"ffs": 1500, "memory_bits": 1088, "block_rams": 2, "memory_in_flip_flops": False, "cells": {}}
ECP5 = {
    **AREA,
    "luts": 1000,
    "fmax_mhz": {"median": 192.0, "best": 200.25, "by_seed": {}},
    "critical_path": {"from": "raster_place_group", "to": "slice0cost_pair_0", "block": "slice0cost"},
}


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """A copy of tiny's folder alone, for performance.py to read."""
    shutil.copytree(rtl.folder("tiny"), tmp_path / "block_matching" / "tiny")
    (tmp_path / "block_matching" / "tiny" / "implementation.json").unlink(missing_ok=True)
    monkeypatch.setattr(rtl, "GENERATED_RTL", tmp_path)
    return tmp_path / "block_matching"


def record(folders, targets):
    entry = manifest.read(folders / "tiny")
    for target, result in targets.items():
        implementation.merge(folders / "tiny", entry, target, result)


def row(text, *words):
    return next(line for line in text.splitlines() if all(word in line for word in words))


def test_committed_page_is_up_to_date():
    process = call("performance.py", "--check")
    assert process.returncode == 0, process.stderr


def test_page_without_results(folders):
    page = performance.page()
    assert "| 384 |" in row(page, "`tiny`", "32x12")
    assert "| - | - | - |" in row(page, "`tiny`", "xc7")


def test_page_with_results(folders):
    record(folders, {"ecp5": ECP5, "cyclonev": {**AREA, "aluts": 1389}})
    page = performance.page()
    assert "1,389 ALUT | 1,500 | 2" in row(page, "`tiny`", "cyclonev")
    # 192 MHz / 384 clocks a frame = 500,000 frames a second of 3,072 evaluations
    assert "| 192.0 | 200.2 | 500,000 | 1,536 | 1,536 |" in row(page, "`tiny`", "raster_place_group")


def test_published_numbers(folders):
    page = performance.page()
    assert "| 153,120 | 50.2 | 425 | 3,264 | 15,616 | 884,736 |" in row(page, "Ambrosch")
    assert "79,056" in row(page, "Vitis") and "15,925" in row(page, "SGM")
    assert "not done yet" in row(page, "trellis") and "| 200 |" in row(page, "DeepSea")
    assert "1300x640, D not stated" in row(page, "Kim")


def test_no_frame_rate_that_the_paper_prints_is_missing():
    printed = {"the same in software": 1.24, "Lee et al.": 122, "Kim et al.": 30, "PARTS": 42, "DeepSea": 200}
    printed |= {"Masrani et al.": 30, "Miyajima et al.": 18.9, "Yi et al.": 30, "Han and Hwang": 60}
    shown = {(system.name, system.frames_per_second) for system in performance.SYSTEMS}
    assert shown >= set(printed.items()) | {("Niitsuma et al.", 30), ("Niitsuma et al.", 840)}


def test_stale_results_are_refused(folders):
    record(folders, {"ecp5": ECP5})
    path = folders / "tiny" / "implementation.json"
    result = json.loads(path.read_text())
    result["design"] = {"structure": "0"}
    path.write_text(json.dumps(result))
    with pytest.raises(FlowError, match="of other VHDL"):
        performance.page()


def test_bad_options():
    refused(call("performance.py", "--config", "nonsense"), 2, "unknown configuration 'nonsense'")
    refused(call("performance.py", "--check", "--config", "tiny"), 2, "not allowed with")


@pytest.mark.parametrize(
    "options,words",
    [
        (["--rows", "1"], ["--rows must be 2 or more"]),
        (["--header", "nonsense.hpp"], ["no hls/nonsense.hpp"]),
        (["--config", "nonsense"], ["no generated VHDL for 'nonsense'"]),
    ],
)
def test_dev_loop_refuses(options, words):
    refused(call("dev_loop.py", *options), 2, *words)
