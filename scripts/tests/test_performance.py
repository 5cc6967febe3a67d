# SPDX-License-Identifier: Apache-2.0
"""docs/performance.md follows from the committed files, and its tables say what the files say."""

import json
import re
import shutil

import pytest

from flow.base import committed, files
from flow.base.errors import FlowError
from flow.implementation import record as implementation
from flow.implementation.results import Configuration
from flow.pages import camera, clock_logic, performance
from flow.quality import recovery
from flow.shell import design
from flow.synthesis import manifest
from flow_commands import call, refused

AREA = {"ffs": 1500, "memory_bits": 1088, "block_rams": 2, "memory_in_flip_flops": False, "cells": {}}
AREA |= {"synthesis": "synth_ecp5", "tools": {"yosys": "Yosys 0.70"}}
ECP5 = {
    **AREA,
    "luts": 1000,
    "lut_sites": 1234,
    "fmax_mhz": {"median": 192.0, "best": 200.25, "by_seed": {"1": 192.0}},
    "critical_path": {"from": "raster_place_group", "to": "slice0cost_pair_0", "block": "slice0cost"},
}


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """A copy of tiny's folder alone, for performance.py to read."""
    shutil.copytree(committed.folder("tiny"), tmp_path / "block_matching" / "tiny")
    (tmp_path / "block_matching" / "tiny" / "implementation.json").unlink(missing_ok=True)
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path)
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    return tmp_path / "block_matching"


def merge(folder, *result):
    files.write(folder / implementation.FILE, implementation.merged(folder, *result))


def record(folders, targets):
    entry = manifest.read(folders / "tiny")
    for target, result in targets.items():
        merge(folders / "tiny", entry, target, result)


def row(text, *words):
    return next(line for line in text.splitlines() if all(word in line for word in words))


def test_committed_page_is_up_to_date():
    process = call("performance.py", "--check")
    assert process.returncode == 0, process.stderr


def test_page_without_results(folders):
    page = performance.page()
    assert "| 384 |" in row(page, "`tiny`", "32x12")
    assert "| - | - | - | - |" in row(page, "`tiny`", "xc7")


def test_page_with_results(folders):
    record(folders, {"ecp5": ECP5, "cyclonev": {**AREA, "aluts": 1389}})
    page = performance.page()
    assert "1,389 ALUT | - | 1,500 | 2" in row(page, "`tiny`", "cyclonev")
    # 192 MHz / 384 clocks a frame = 500,000 frames a second of 3,072 evaluations
    # of 24 columns with an output of 32
    assert "| 192.0 | one seed | 200.2 | 500,000 | 1,536 | 1,152 | 1,536 |" in row(page, "`tiny`", "raster_place_group")
    assert "1,000 LUT4 | 1,234 | 1,500 | 2" in row(page, "`tiny`", "1,000 LUT4")
    assert "Not measured yet." in page


def test_devices_of_other_families(folders):
    """By device, the routed ones with a clock, and those where it does not fit with what it needs."""
    too_few = {key: value for key, value in ECP5.items() if key not in ("lut_sites", "fmax_mhz", "critical_path")}
    too_few["does_not_fit"] = {"ICESTORM_RAM": {"used": 33, "available": 30}}
    record(folders, {"ecp5": ECP5, "ccgm1a1": {**ECP5, "router": "router2"}, "up5k": too_few})
    lines = performance.device_table().splitlines()[2:]
    assert [line.split("|")[1].strip() for line in lines] == ["iCE40 UP5K", "CCGM1A1"]
    assert "| - | does not fit: 33 of 30 block RAMs | - | 1,000 LUT4 | - | 1,500 | 2 | - |" in lines[0]
    assert "| 192.0 | one seed, router2 | 500,000 | 1,000 half CPE | 1,234 | 1,500 | 2 |" in lines[1]
    assert lines[1] in performance.page()
    assert "CCGM1A1" not in performance.speed_table([Configuration("tiny")])


def test_no_device_of_another_family(folders):
    record(folders, {"ecp5": ECP5})
    assert performance.device_table() == "Not measured yet."


def test_only_several_seeds_have_a_median(folders):
    several = {**ECP5, "fmax_mhz": {"median": 192.0, "best": 200.25, "by_seed": {"1": 180.0, "2": 192.0, "3": 200.25}}}
    record(folders, {"ecp5": ECP5, "ecp5_grade6": several})
    page = performance.page()
    assert "one seed" in row(page, "85F, grade 8", "`tiny`")
    assert "median of 3" in row(page, "85F, grade 6", "`tiny`")
    assert "25F" not in "".join(line for line in page.splitlines() if line.startswith("| `tiny`"))


def test_shell_beside_the_core(folders):
    entry = manifest.read(folders / "tiny")
    record(folders, {"ecp5": ECP5})
    shell = {**ECP5, "luts": 1500, "fmax_mhz": {"median": 188.16, "best": 188.16, "by_seed": {"1": 188.16}}}
    merge(folders / "tiny", entry, "ecp5", shell, design.digests())
    assert "| 188.2 | one seed | 98 % | 500,000 | 490,000 | 1,000 | 1,500 |" in performance.page()
    merge(folders / "tiny", entry, "ecp5", shell, {"hls/rtl/stereo_axis.vhd": "of an older shell"})
    assert "98 %" not in performance.page()


def test_one_number_and_its_picture(folders):
    record(folders, {"ecp5": ECP5})
    routed = performance.routed_configurations()
    assert "| `tiny` | 192.0 | one seed | 1,000 | 1,234 | 1,536,000 | 1,152,000 |" in performance.one_number_table(
        routed
    )
    points = clock_logic.points(routed)
    assert points == [("tiny", "block_matching", "tiny", 1000, 192.0)]
    first, second = clock_logic.picture(points), clock_logic.picture(points)
    assert first == second and ">tiny</text>" in first and "<dc:date>" not in first
    moved = [points[0]._replace(mhz=100.0), points[0]]
    assert clock_logic.picture(moved) != first


@pytest.mark.parametrize("command", ["performance.py", "recovery.py"])
def test_a_picture_is_up_to_date_by_its_data(tmp_path, command):
    """Other versions of matplotlib draw other curves, and none is wrong for that."""
    module = {"performance.py": clock_logic, "recovery.py": recovery}[command]
    committed, other = module.PICTURE.read_text(), tmp_path / "other.svg"
    moved = re.sub(r"(?m)^L (\d)", r"L 1\1", committed, count=1)
    changed = re.sub(r"(<!-- drawn from: .*?\d)", r"\g<1>1", committed)
    assert moved != committed and changed != committed
    other.write_text(moved)
    assert files.update({other: committed}, True, command) == 0
    other.write_text(changed)
    with pytest.raises(FlowError, match="other.svg; run"):
        files.update({other: committed}, True, command)
    other.write_text(moved)
    assert files.update({other: committed}, False, command) == 0 and other.read_text() == committed


def test_the_picture_of_a_table_shows_what_the_table_says():
    """docs/images/recovery.svg and docs/dynamic_range.md."""
    data = json.loads(re.search(r"<!-- drawn from: (.*) -->", recovery.PICTURE.read_text())[1])
    text = recovery.PAGE.read_text()
    rows = {name: re.search(rf"^\| {name} \| (.*) \|$", text, re.MULTILINE)[1] for name in recovery.METHODS}
    assert data == {name: [float(value) for value in row.split(" | ")] for name, row in rows.items()}


def test_published_numbers(folders):
    page = performance.page()
    assert "| 153,120 | 50.2 | 425 | 3,264 | 15,616 | 884,736 |" in row(page, "Ambrosch")
    assert "| 6,065 |" in row(page, "450x375x60") and "10.1155/2014/945926" in row(page, "RTSVP")
    assert "79,056" in row(page, "Vitis") and "25,568" in row(page, "SGM")
    assert "`masrani_640`" in row(page, "Masrani") and "| 200 |" in row(page, "DeepSea")
    assert "not done yet" not in page
    assert "| 42 |" in row(page, "PARTS") and "`parts_320`" in row(page, "PARTS")
    assert "1300x640, D not stated" in row(page, "Kim") and "`trellis_1300`" in row(page, "Kim")


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


def test_a_camera_clock(folders):
    """tiny: 32x12 pairs, 384 clocks a frame; 40 pairs, 16 clocks of the core and 5 of the shell before a disparity."""
    shown = row(camera.camera_table([Configuration("tiny")], 0.1), "`tiny`")
    numbers = [cell.strip() for cell in shown.split("|")[3:9]]
    assert numbers == ["260.4", "3.840", "1.9", "0.610", "0.530", "32"]


def test_command_prints_what_a_camera_clock_gives():
    process = call("performance.py", "--config", "tiny", "--mhz", "27")
    assert process.returncode == 0 and "70,312.5" in row(process.stdout, "`tiny`"), process.stderr


def test_refuses_a_clock_without_configuration():
    refused(call("performance.py", "--mhz", "27"), 2, "--mhz needs --config")
    refused(call("performance.py", "--config", "tiny", "--mhz", "-1"), 2, "'-1' is no number from 0.1 to 2000")


def test_a_page_without_its_marks_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(camera, "PAGE", tmp_path / "integration.md")
    camera.PAGE.write_text("no marks\n")
    with pytest.raises(FlowError, match="integration.md has no place for what belongs between"):
        camera.page()
