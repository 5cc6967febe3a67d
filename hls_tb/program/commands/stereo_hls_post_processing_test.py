# SPDX-License-Identifier: Apache-2.0
"""Post-processing by the configuration's own options: its files, and what the commands make of its confidence."""

import json

import pytest

from stereo_hls_program import fail, succeed

STAGES = ("left_right_threshold=1", "support_threshold=3", "confidence=true", "fill_holes=true")


@pytest.fixture
def match(tmp_path):
    """The words of a match of a generated scene with all stages."""
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny_sgm")
    words = ["match", "--config", "tiny_sgm", "--out", tmp_path / "out"]
    words += [word for stage in STAGES for word in ("--set", stage)]
    return [*words, "--left", tmp_path / "s" / "left.png", "--right", tmp_path / "s" / "right.png"]


def facts(tmp_path):
    return json.loads((tmp_path / "out" / "match.json").read_text())


def test_match_writes_confidence_and_what_was_filled(tmp_path, match):
    out = succeed(*match)
    found = facts(tmp_path)
    assert 0 < found["filled"] < 1 and found["density"] + found["filled"] == pytest.approx(1)
    assert f"filled pixels: {100 * found['filled']:.2f} %" in out
    assert {"valid.png", "confidence.png", "filled.png"} <= {path.name for path in (tmp_path / "out").iterdir()}
    plain = [word for word in match if word not in STAGES]
    succeed(*[word for at, word in enumerate(plain) if word != "--set"])
    left = {path.name for path in (tmp_path / "out").iterdir()}
    assert not left & {"confidence.png", "filled.png"}, "those of the run before are gone"


def test_only_what_is_measured(tmp_path, match):
    succeed(*match, "--measured-only")
    assert facts(tmp_path)["filled"] == 0
    assert facts(tmp_path)["postprocessing"]["measured_only"] is True


def test_the_surest_are_taken_by_the_own_confidence(tmp_path, match):
    succeed(*match)
    all_measured = facts(tmp_path)["density"]
    succeed(*match, "--surest", 40)
    some = facts(tmp_path)
    assert 0.4 <= some["density"] < all_measured and some["filled"] == 0
    succeed(*match, "--least-confidence", 255)
    assert facts(tmp_path)["density"] < some["density"]


def test_maps_with_filled_pixels_are_read_again(tmp_path, match):
    succeed(*match)
    words = ["evaluate", *match[-4:], "--border", 0, "--truth-right", tmp_path / "s" / "disparity_right.png"]
    words += ["--disparity", tmp_path / "out" / "disparity.png", "--json", tmp_path / "evaluation.json"]
    succeed(*words, *match[1:3], *match[5:-4])
    own, read = json.loads((tmp_path / "evaluation.json").read_text())["methods"]
    assert own["masks"] == {name: read["masks"].get(name, mask) for name, mask in own["masks"].items()}
    map_share = facts(tmp_path)["output_width_px"] / facts(tmp_path)["width_px"]
    assert own["masks"]["all"]["density"] == pytest.approx(map_share), "each pixel of the map has a value"


@pytest.mark.parametrize(
    ("stage", "says"),
    [
        ("support_threshold=0", "confidence needs a support threshold of 1 or more"),
        ("support_threshold=36", "must be 0 ... 35"),
        ("border_cost=3", "border_cost needs a map of full width"),
    ],
)
def test_stages_that_do_not_fit(tmp_path, match, stage, says):
    name = stage.partition("=")[0]
    words = [stage if str(word).startswith(name) else word for word in match]
    fail(tmp_path, *words, *([] if stage in words else ["--set", stage]), says=[says])


def test_percent_beyond_its_limits(tmp_path, match):
    fail(tmp_path, *match, "--surest", 0, says=["--surest"])
