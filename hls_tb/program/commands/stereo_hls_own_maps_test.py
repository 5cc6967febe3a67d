# SPDX-License-Identifier: Apache-2.0
"""Maps that match has written, evaluated without options."""

import json
import struct

import pytest

from stereo_hls_program import DISPARITIES, fail, succeed
from truth_files import results, shifted_pair


def own_maps(tmp_path, config, settings, write=("pfm", "kitti")):
    """What match writes of a shifted pair, and the arguments to evaluate it."""
    pair = shifted_pair(tmp_path, width=60, height=30)
    images = pair[1:5]
    written = [word for kind in write for word in ("--write", kind)]
    out = succeed("match", "--config", config, *settings, *images, *written, "--out", tmp_path / "out")
    names = {"disparity.png", "disparity_color.png", "overview.png", "match.json"}
    names |= {{"pfm": "disparity.pfm", "kitti": "disparity_kitti.png"}[kind] for kind in write}
    assert {p.name for p in (tmp_path / "out").iterdir()} - {"valid.png"} == names
    return out, [*pair, "--border", 0]


@pytest.mark.parametrize(
    "config, settings",
    [
        ("tiny", []),
        ("tiny", ["subpixel=true", "reference=left", "left_right_threshold=1"]),
        ("study", ["min_disparity=2", "subpixel=true"]),
        ("study", ["min_disparity=-3", "reference=right"]),
        ("tiny_sgm", ["subpixel=true", "full_width=true", "left_right_threshold=0"]),
    ],
)
def test_what_match_writes_is_read_back_without_options(tmp_path, config, settings):
    """The measures of the configuration itself, from each of its files."""
    settings = [word for setting in settings for word in ("--set", setting)]
    _, pair = own_maps(tmp_path, config, settings)
    files = [tmp_path / "out" / name for name in ("disparity.png", "disparity.pfm", "disparity_kitti.png")]
    words = [word for file in files for word in ("--disparity", file)]
    _, [core, *maps] = results(tmp_path, *pair, "--config", config, *settings, *words)
    facts = json.loads((tmp_path / "out" / "match.json").read_text())
    assert [m["parameters"]["scale"] for m in maps] == [facts["disparity_steps_per_px"], 1, 256]
    assert core["masks"]["all"]["density"] > 0.3
    for method in maps:
        assert method["reference"] == core["reference"] and "searchable" not in method["masks"]
        for mask, measures in method["masks"].items():
            if method["name"].endswith("kitti.png") and ("min_disparity=-3" in settings or "tiny" in config):
                continue  # 0 is 1/256 there, what is below 0 is lost
            assert measures == core["masks"][mask], (method["name"], mask)


def test_kitti_has_1_for_0_and_0_for_none(tmp_path):
    """The truth is 0 ... 3: pixels of 0 stay known."""
    pair = shifted_pair(tmp_path, shift=0, width=60, height=30)
    succeed("match", "--config", "tiny", *pair[1:5], "--write", "kitti", "--out", tmp_path / "out")
    words = ["--disparity", tmp_path / "out" / "disparity_kitti.png", "--border", 0]
    _, [method] = results(tmp_path, *pair, *words)
    assert method["masks"]["all"]["density"] == pytest.approx((60 - DISPARITIES) / 60)
    assert method["masks"]["all"]["avg_px"] == pytest.approx(1 / 256)


def test_disparities_that_kitti_cannot_hold_are_said(tmp_path):
    """Below 0, as of exchanged images. The PFM has them."""
    pair = shifted_pair(tmp_path, width=60, height=30)
    exchanged = ["--left", pair[4], "--right", pair[2], "--config", "study", "--set", "min_disparity=-8"]
    words = ["--write", "kitti", "--write", "pfm", "--out", tmp_path / "out"]
    out = succeed("match", *exchanged, *words)
    held = [
        float(v) for (v,) in struct.iter_unpack("<f", (tmp_path / "out" / "disparity.pfm").read_bytes()[-4 * 1800 :])
    ]
    negative = sum(v < 0 for v in held)
    assert negative > 500 and f"disparity_kitti.png leaves {negative} disparities out" in out


def test_own_maps_that_do_not_fit_their_json(tmp_path):
    _, pair = own_maps(tmp_path, "tiny", [], write=("pfm",))
    own = tmp_path / "out" / "disparity.png"
    fail(tmp_path, *pair, "--disparity", own, "--reference", "left", says=["--reference left", "says right"])
    _, [method] = results(tmp_path, *pair, "--disparity", own, "--reference", "right", "--disparity-scale", 2)
    assert method["parameters"] == {"scale": 2} and method["masks"]["all"]["avg_px"] == pytest.approx(1.5)
    own.write_bytes((tmp_path / "ls.pgm").read_bytes())
    fail(tmp_path, *pair, "--disparity", own, says=["disparity.png", "match.json"])
    (tmp_path / "out" / "match.json").write_text('{"format": "stereo-hls match 1"}')
    fail(tmp_path, *pair, "--disparity", own, says=["disparity.png", "--reference"])
    fail(tmp_path, *pair, "--disparity", tmp_path / "shift.pfm", says=["shift.pfm", "--reference"])


def test_maps_that_only_some_runs_write(tmp_path):
    pair = own_maps(tmp_path, "tiny", [])[1]
    own_maps(tmp_path, "tiny", [], write=("pfm",))
    own_maps(tmp_path, "tiny", [], write=())
    match = ["match", "--config", "tiny", *pair[1:5], "--out", tmp_path / "out"]
    fail(tmp_path, *match, "--write", "exr", says=["--write", "exr"])
