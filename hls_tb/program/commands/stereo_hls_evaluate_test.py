# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls evaluate: figures of maps made by hand, of configurations and of OpenCV's matchers."""

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, fail, run, succeed
from truth_files import pfm, results, shifted_pair

MEASURES = {"pixels", "density", "avg_px", "rms_px", "d1", "bad_0_5", "bad_1", "bad_2", "bad_4"}


def test_a_map_of_known_errors(tmp_path, evaluate, pair):
    """Truth 5 px; column 0 unknown, column 1 invalid, columns 2, 3, 4 off by 0.75, 1.5 and 6 px."""
    truth = pfm(tmp_path / "truth.pfm", lambda x, y: float("inf") if x == 0 else 5)
    errors = {2: 0.75, 3: 1.5, 4: -6}
    found = pfm(tmp_path / "found.pfm", lambda x, y: float("inf") if x == 1 else 5 + errors.get(x, 0), order=">")
    out, [method] = results(tmp_path, *evaluate, "--truth-right", truth, "--disparity", found, "--reference", "right")
    known, valid = WIDTH - 1, WIDTH - 2
    assert method["name"] == str(found) and method["kind"] == "file" and method["reference"] == "right"
    assert method["milliseconds"] is None
    assert method["masks"].keys() == {"all"}, "the other masks need the left image's truth"
    mask = method["masks"]["all"]
    assert mask.keys() == MEASURES
    assert mask["pixels"] == known * HEIGHT
    assert mask["density"] == pytest.approx(valid / known)
    assert mask["avg_px"] == pytest.approx((0.75 + 1.5 + 6) / valid)
    assert mask["rms_px"] == pytest.approx(((0.75**2 + 1.5**2 + 36) / valid) ** 0.5)
    for name, bad in (("bad_0_5", 3), ("bad_1", 2), ("bad_2", 1), ("bad_4", 1), ("d1", 1)):
        assert mask[name]["invalid_bad"] == pytest.approx((bad + 1) / known), name
        assert mask[name]["valid_only"] == pytest.approx(bad / valid), name
    assert f"{100 * 3 / known:.2f}" in out, "bad 1 with invalid pixels as bad"


def test_configurations_against_the_truth_of_their_reference(tmp_path):
    evaluate = [*shifted_pair(tmp_path), "--border", 0, "--config", "tiny"]
    _, [right] = results(tmp_path, *evaluate)
    assert right["name"] == "tiny" and right["kind"] == "core" and right["milliseconds"] >= 0
    assert right["reference"] == right["parameters"]["reference"] == "right"
    columns = WIDTH - DISPARITIES
    assert right["masks"]["all"]["density"] == pytest.approx(columns / WIDTH), "the last columns lie outside the map"
    assert right["masks"]["all"]["bad_0_5"] == {"invalid_bad": pytest.approx(DISPARITIES / WIDTH), "valid_only": 0}
    assert right["masks"]["non_occluded"]["pixels"] == (WIDTH - 3) * HEIGHT
    assert right["masks"]["non_occluded"]["density"] == pytest.approx(columns / (WIDTH - 3))
    assert "discontinuity" not in right["masks"], "it has no pixels"
    _, [left, plain] = results(
        tmp_path, *evaluate, "--set", "reference=left", "--set", "min_disparity=1", "--config", "study"
    )
    assert left["reference"] == plain["reference"] == "left"
    assert left["parameters"]["min_disparity"] == plain["parameters"]["min_disparity"] == 1
    assert left["masks"]["all"]["bad_0_5"]["valid_only"] == 0
    assert (plain["name"], plain["parameters"]["window_px"]) == ("study", 5)


def test_a_reference_without_truth_has_no_masks(tmp_path):
    arguments = shifted_pair(tmp_path)
    position = arguments.index("--truth-right")
    del arguments[position : position + 2]
    out, [method] = results(tmp_path, *arguments, "--config", "tiny", "--border", 0)
    assert method["masks"] == {} and "no true disparities of its right image" in out


def test_opencv_finds_the_shift(tmp_path):
    modes = {"bm": "StereoBM", "sgbm": "StereoSGBM"}
    modes |= {f"sgbm_{mode}": f"StereoSGBM, {mode.upper()}" for mode in ("3way", "hh4", "hh")}
    options = [*(word for mode in modes for word in ("--opencv", mode)), "--opencv-disparities", 16]
    pair = shifted_pair(tmp_path, width=120, height=60)
    out, methods = results(tmp_path, *pair, *options, "--opencv-block", 7)
    assert [(m["name"], m["kind"], m["reference"]) for m in methods] == [
        (name, "opencv", "left") for name in modes.values()
    ]
    assert [m["parameters"].get("mode", "bm") for m in methods] == list(modes)
    for method in methods:
        assert method["parameters"]["disparities"] == 16 and method["parameters"]["block_px"] == 7
        mask = method["masks"]["non_occluded"]
        assert mask["bad_1"]["valid_only"] < 0.01 and 0.8 < mask["density"] < 1
        assert mask["pixels"] == (120 - 20) * (60 - 20), "a border of 10 by default"
        searchable = method["masks"]["searchable"]
        assert searchable["pixels"] == (120 - 10 - 16) * (60 - 20), "the first 16 columns cannot be searched"
        assert searchable["density"] >= mask["density"]
    assert "StereoSGBM" in out and "a border of 10 px" in out


def test_opencv_follows_the_disparities_that_are_set(tmp_path):
    pair = [*shifted_pair(tmp_path, width=120, height=60), "--config", "tiny", "--opencv", "bm", "--opencv", "sgbm"]
    for disparities, theirs in ((32, 32), (33, 48), (1, 16)):
        if disparities > 1:
            out, methods = results(tmp_path, *pair, "--set", f"disparities={disparities}")
            assert methods[0]["parameters"]["disparities"] == disparities
            assert [m["parameters"]["disparities"] for m in methods[1:]] == [theirs, theirs]
            assert f"OpenCV's matchers search {theirs} disparities (--set disparities={disparities})" in out
    out, methods = results(tmp_path, *pair, "--set", "disparities=32", "--opencv-disparities", 16)
    assert [m["parameters"]["disparities"] for m in methods] == [32, 16, 16] and "look for" not in out
    assert [m["parameters"]["disparities"] for m in results(tmp_path, *pair)[1]] == [DISPARITIES, 48, 48]


def test_the_clocked_core_is_measured_as_the_fast_model_is(tmp_path):
    pair = [*shifted_pair(tmp_path), "--border", 0, "--config", "tiny"]
    _, [fast] = results(tmp_path, *pair)
    _, [clocked] = results(tmp_path, *pair, "--engine", "clocked")
    assert fast.pop("engine") == "fast" and clocked.pop("engine") == "clocked"
    assert fast.pop("milliseconds") != clocked.pop("milliseconds")
    assert fast == clocked
    truth = ["--truth-left", tmp_path / "shift.pfm"]
    clocked = [*pair[:5], *truth, "--config", "tiny", "--engine", "clocked"]
    fail(tmp_path, *clocked, "--set", "window_px=5", says=["--set window_px=5", "built in"])
    fail(tmp_path, *clocked[:-4], "--opencv", "bm", *clocked[-2:], says=["--engine clocked", "--config"])
    wide = [*shifted_pair(tmp_path, width=WIDTH + 2), "--config", "tiny", "--engine", "clocked"]
    fail(tmp_path, *wide, says=["34x12", "32x12"])
    process = run(*pair[:5], *truth, "--config", "opencv_bm_missing", "--engine", "clocked")
    assert process.returncode == 2 and "opencv_bm_missing" in process.stderr


def test_speckles_and_confidence_of_configurations(tmp_path):
    pair = [*shifted_pair(tmp_path, width=60, height=30), "--border", 0, "--config", "tiny", "--opencv", "bm"]
    _, [plain, bm] = results(tmp_path, *pair, "--opencv-block", 7)
    for words in (["--speckle-window", 100000], ["--least-confidence", 255]):
        _, [core, bm_again] = results(tmp_path, *pair, "--opencv-block", 7, *words)
        assert core["masks"]["all"]["density"] < plain["masks"]["all"]["density"]
        assert core["postprocessing"] != plain["postprocessing"]
        assert bm_again["masks"] == bm["masks"] and "postprocessing" not in bm
    assert core["masks"]["all"]["bad_1"]["valid_only"] == 0
    fail(tmp_path, *pair[:-4], "--opencv", "bm", "--speckle-window", 9, says=["--speckle-window", "--config"])


def test_the_table_comes_without_json(tmp_path, pair):
    arguments = shifted_pair(tmp_path)[:-2]
    before = sorted(tmp_path.rglob("*"))
    out = succeed(*arguments, "--border", 0, "--config", "tiny")
    assert "non_occluded" in out and "bad 0.5" in out and sorted(tmp_path.rglob("*")) == before
