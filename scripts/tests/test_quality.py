# SPDX-License-Identifier: Apache-2.0
"""docs/quality.md: the measure is OpenCV's, ours is as good as StereoBM, and the page says what was measured."""

import copy

import pytest

from flow.base.errors import FlowError
from flow.pages import quality
from flow_commands import call, refused

PAIR = quality.default_pair()
BLOCK_MATCHER, OTHER_REFERENCE = quality.OURS[0][0], quality.OURS[1][0]
PHASE = next(title for title, config, _ in quality.OURS if config == "parts_320")
SEMI_GLOBAL = next(title for title, config, _ in quality.OURS if config == "sgm_450")


@pytest.fixture(scope="module")
def teddy():
    """What the methods found on the real pair."""
    missing = quality.missing_files(PAIR)
    if missing:
        pytest.skip(
            f"SKIP: the stereo pair teddy is missing ({missing[0]}); "
            "set STEREO_DATA to the folder that holds teddy/left.png"
        )
    return quality.measure(quality.pair_images(PAIR), quality.PAIR_DISPARITIES)


@pytest.mark.slow
def test_stereo_bm_is_measured_as_opencv_measures_it(teddy):
    bm = dict(teddy)[quality.BM]
    assert (bm["parameters"]["disparities"], bm["parameters"]["block_px"]) == (48, 15)
    for mask, stored in quality.OPENCV_STORED.items():
        assert quality.bad_1(bm, mask) == pytest.approx(stored, abs=quality.OPENCV_TOLERANCE), mask


@pytest.mark.slow
def test_the_best_of_ours_are_as_good_as_those_of_opencv(teddy):
    title, best = quality.best_of_family(teddy, "block_matching")
    assert quality.bad_1(best) <= quality.bad_1(dict(teddy)[quality.BM]), title
    title, best = quality.best_of_family(teddy, "semi_global")
    for mode in ("StereoSGBM", "StereoSGBM, 3WAY", "StereoSGBM, HH4", "StereoSGBM, HH"):
        assert quality.bad_1(best) <= quality.bad_1(dict(teddy)[mode]), f"{title}, {mode}"


@pytest.mark.slow
def test_the_committed_page_shows_what_is_measured(teddy):
    text = quality.PAGE.read_text()
    for part in (quality.regions_table([teddy]), quality.measures_table(teddy), quality.verdict(teddy)):
        assert part in text, "run scripts/quality.py"
    assert "Do not edit" in text and "scripts/quality.py" in text


@pytest.fixture
def two():
    def method(kind, bad, reference="left"):
        both = {"invalid_bad": bad, "valid_only": None}
        mask = {
            "pixels": 10,
            "density": 0.5,
            "avg_px": None,
            "rms_px": 2.0,
            **dict.fromkeys(("bad_0_5", "bad_1", "bad_2", "bad_4", "d1"), both),
        }
        return {"kind": kind, "reference": reference, "masks": {name: copy.deepcopy(mask) for name in quality.MASKS}}

    return [
        (quality.BM, method("opencv", 0.2)),
        (BLOCK_MATCHER, method("core", 0.3)),
        (OTHER_REFERENCE, method("core", 0.1, "right")),
        ("StereoSGBM", method("opencv", 0.15)),
        (SEMI_GLOBAL, method("core", 0.12)),
    ]


def test_the_verdict_can_be_no(two):
    assert f'"{BLOCK_MATCHER}", beside StereoBM with its stored parameters: not fewer bad pixels' in quality.verdict(
        two
    )
    assert "beside the best mode of OpenCV, StereoSGBM: fewer bad pixels: 12.00 % against 15.00 %" in quality.verdict(
        two
    )
    two[1][1]["masks"]["non_occluded"]["bad_1"]["invalid_bad"] = 0.19
    two[4][1]["masks"]["non_occluded"]["bad_1"]["invalid_bad"] = 0.16
    assert "parameters: fewer bad pixels: 19.00 % against 20.00 %" in quality.verdict(two)
    assert "StereoSGBM: not fewer bad pixels: 16.00 % against 15.00 %" in quality.verdict(two)


def test_where_phase_correlation_wins_is_counted(two):
    def with_phase(bad):
        entry = (PHASE, copy.deepcopy(two[1][1]))
        entry[1]["masks"]["non_occluded"]["bad_1"]["invalid_bad"] = bad
        return [*two, entry]

    # Block matching has 0.3, OpenCV 0.15, semi-global 0.12.
    assert "pixels in 1, fewer than the\nbest block matching in 2, fewer than semi-global matching in 1." in (
        quality.phase_wins([with_phase(0.05), with_phase(0.2), with_phase(0.4)])
    )


def test_tables_take_means_and_know_what_is_unknown(two):
    other = copy.deepcopy(two)
    other[1][1]["masks"]["all"]["bad_1"]["invalid_bad"] = 0.4
    lines = quality.regions_table([two, other]).splitlines()
    assert lines[3] == f"| {BLOCK_MATCHER} | left | 30.00 | 30.00 | 35.00 | 30.00 | 30.00 | 50.00 |"
    ours = quality.measures_table(two).splitlines()[3]
    assert ours == f"| {BLOCK_MATCHER} | 30.00 | 30.00 | 30.00 | 30.00 | 30.00 | - | - | - | - | - | - | 2.00 |"


@pytest.mark.slow
def test_without_the_pair_only_the_scenes(tmp_path):
    before = quality.PAGE.read_bytes()
    quality.SCENES_PAGE.unlink(missing_ok=True)
    process = call("quality.py", "--pair", tmp_path)
    assert process.returncode == 0, process.stderr
    said, wrote = process.stdout.splitlines()
    assert "not complete" in said and str(tmp_path / "left.png") in said and "only the scenes" in said
    assert wrote == "wrote build/quality_scenes.md" and quality.PAGE.read_bytes() == before
    text = quality.SCENES_PAGE.read_text()
    assert "| StereoSGBM | left |" in text and "## Teddy" not in text


def test_the_page_of_one_scene(monkeypatch):
    """With few rows and cameras."""
    ours = [row for row in quality.OURS if row[0] in quality.CAMERA_ROWS]
    for name, some in (("SCENE_SEEDS", (1,)), ("OURS", ours), ("CAMERAS", quality.CAMERAS[:2])):
        monkeypatch.setattr(quality, name, some)
    text = quality.scenes_page()
    assert all(f"| {row} | " in text for row in ("StereoSGBM", *quality.CAMERA_ROWS)) and "## Teddy" not in text


def test_without_the_pair_nothing_is_checked(tmp_path):
    refused(call("quality.py", "--pair", tmp_path, "--check"), 2, "nothing was checked")


def test_results_of_another_format_are_refused(tmp_path, monkeypatch):
    program = tmp_path / "stereo_hls"
    program.write_text('#!/bin/sh\nfor last; do :; done\necho \'{"format": "stereo-hls evaluation 2"}\' > "$last"\n')
    program.chmod(0o755)
    monkeypatch.setenv("STEREO_HLS", str(program))
    with pytest.raises(FlowError, match="evaluation 2"):
        quality.measure([], 48)
