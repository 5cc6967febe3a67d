# SPDX-License-Identifier: Apache-2.0
"""The parameter study on pairs with truth of one image, with several scales, with a wrong one, and broken off."""

import json
import subprocess

import pytest

from flow.base.configurations import configurations, option
from flow.base.errors import FlowError
from flow.base.tools import find_stereo_hls
from flow.quality import explore, given_truth, hardware_cost
from flow_commands import call, refused
from test_explore import stand_in

NARROW = ["--window", 3, "--cost", "sad", "--range", 16, "--jobs", 1]
SWEEP = [*NARROW, "--switch", "--config", "sgm_450"]


class Truth:
    def __init__(self, left, right):
        self.truth_left, self.truth_right = left, right


BOTH, LEFT, RIGHT = Truth("l", "r"), Truth("l", None), Truth(None, "r")


@pytest.mark.parametrize(
    "pairs,known",
    [([BOTH], ("left", "right")), ([BOTH, LEFT], ("left",)), ([RIGHT, BOTH], ("right",)), ([LEFT], ("left",))],
)
def test_sides_that_every_pair_knows(pairs, known):
    assert given_truth.known_sides(pairs) == known


def test_the_mask_follows_from_the_sides():
    assert given_truth.mask(None, ("left", "right")) == "non_occluded"
    assert given_truth.mask("textureless", ("left", "right")) == "textureless"
    assert given_truth.mask(None, ("left",)) == given_truth.mask("all", ("left",)) == "all"
    with pytest.raises(FlowError, match="--mask searchable: needs the truth of both images"):
        given_truth.mask("searchable", ("left",))
    with pytest.raises(FlowError, match="left image of every pair, or those of the right"):
        given_truth.known_sides([LEFT, RIGHT])


def test_choices_turn_to_the_image_with_truth():
    sweep = explore.Sweep([5], ["sad"], [16], [])
    for known, settings in ((("left",), "reference=left"), (("right",), None), (("left", "right"), None)):
        [choice] = explore.choices(sweep, hardware_cost.Study(), known)[0]
        assert next((word for word in choice.settings if word.startswith("reference")), None) == settings
    with pytest.raises(FlowError, match="--switch left"):
        explore.choices(explore.Sweep([5], ["sad"], [16], ["left"]), hardware_cost.Study(), ("left",))
    names = ["sgm_450", "tiny_dynamic", "tiny_trellis"]
    assert explore.named_choices(names, [16], ("left",))[1] == ["tiny_dynamic"]
    assert explore.named_choices(names, [16], ("right",))[1] == ["tiny_trellis"]
    assert explore.named_choices(names, [16], ("left", "right"))[1] == []


def test_references_without_an_option_are_those_of_the_program(tmp_path):
    """One configuration of each family without the option; the program says in match.json what its reference is."""
    table = configurations()
    for family in sorted({row["family"] for row in table.values()}):
        name = next(
            name for name, row in sorted(table.items(), key=lambda item: item[1]["width_px"]) if row["family"] == family
        )
        scene = tmp_path / name
        program = find_stereo_hls()
        subprocess.run(
            [program, "scene", "--config", name, "--seed", "1", "--out", scene], check=True, capture_output=True
        )
        images = ["--left", scene / "left.png", "--right", scene / "right.png"]
        subprocess.run([program, "match", "--config", name, *images, "--out", scene], check=True, capture_output=True)
        side = json.loads((scene / "match.json").read_text())["reference"]
        other = {"left": "right", "right": "left"}[side]
        assert given_truth.reference_setting(table[name], (side,)) == {}, name
        turned = {"reference": other} if option(table[name], "reference") else None
        assert given_truth.reference_setting(table[name], (other,)) == turned, name


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    """A folder with a pair: `left.png`, and its truth as `disparity_left.png`."""
    folder = tmp_path_factory.mktemp("truth") / "pair"
    words = "scene --width 120 --height 80 --disparities 16 --seed 3 --out".split()
    subprocess.run([find_stereo_hls(), *words, folder], check=True, capture_output=True)
    return folder


def pair(scene, left="disparity_left.png", right="disparity_right.png"):
    truths = [scene / name if name != "-" else name for name in (left, right)]
    return ["--pair", scene / "left.png", scene / "right.png", *truths]


def content(out):
    return json.loads((out / "explore.json").read_text())


def test_a_pair_like_kittis(scene, tmp_path):
    process = call(
        "explore.py",
        *pair(scene, right="-"),
        *NARROW,
        "--switch",
        "--config",
        "sgm_450",
        "tiny_dynamic",
        "--out",
        tmp_path,
    )
    assert process.returncode == 0, process.stderr
    assert "Only the left images have truth" in process.stdout and "tiny_dynamic is left out" in process.stdout
    found = content(tmp_path)
    assert found["mask"] == "all" and len(found["choices"]) == 2
    for row in found["choices"]:
        assert 0 <= row["bad_1_invalid_bad_percent"] < 50
        assert "--truth-right" not in row["commands"][0]
        turned = "--set reference=left" in row["commands"][0]
        assert turned == (row["title"] != "sgm_450"), "whose reference is the left image anyway"


def test_what_cannot_be_is_refused_before_anything_runs(scene, tmp_path):
    """The program that stands in would fail at the first evaluation."""
    nothing = stand_in(tmp_path, "print('stereo_hls: it ran', file=sys.stderr); sys.exit(2)")
    one = pair(scene, right="-")
    out = ["--out", tmp_path / "out"]
    for words, says in (
        ([*one, *SWEEP, "--mask", "non_occluded"], "--mask non_occluded: needs the truth of both images"),
        ([*one, *NARROW, "--switch", "left"], "--switch left"),
        ([*one, *pair(scene, left="-"), *SWEEP], "left image of every pair, or those of the right"),
        ([*pair(scene, "-", "-"), *SWEEP], "left image of every pair, or those of the right"),
        ([*one, *SWEEP, "--truth-scale", 1, 2], "one for each of the 1 pairs"),
        ([*one, *SWEEP, "--truth-scale", 0], "--truth-scale must be above 0"),
        ([*one, *SWEEP, "--truth-scale", "nan"], "--truth-scale must be above 0"),
    ):
        refused(call("explore.py", *words, *out, environment=nothing), 2, says)


def test_each_pair_has_its_scale(scene, tmp_path):
    """1 is said, too: files of 16 bits have 256 where nobody says otherwise."""
    words = [*pair(scene), "--truth-scale", 1, *pair(scene), "--truth-scale", 4, *SWEEP, "--out", tmp_path]
    process = call("explore.py", *words)
    assert process.returncode == 0, process.stderr
    for row in content(tmp_path)["choices"]:
        assert "--truth-scale 1 " in row["commands"][0] and "--truth-scale 4 " in row["commands"][1]
    assert "of the disparities that" in process.stdout and "2 of 2 choices say so" in process.stdout, "4 is wrong"


def test_a_scale_that_puts_the_truth_outside_of_the_range_is_remarked(scene, tmp_path):
    process = call("explore.py", *pair(scene), "--truth-scale", 0.1, *SWEEP, "--out", tmp_path)
    assert process.returncode == 0, process.stderr
    assert "searches disparities of 0 ... 15 px, but 100 % of the ground truth" in process.stdout
    good = call("explore.py", *pair(scene), *SWEEP, "--out", tmp_path)
    assert good.returncode == 0 and "check the scale" not in good.stdout


def test_what_was_evaluated_is_kept(scene, tmp_path):
    """Breaks off at the second evaluation; goes on from the first; then needs no evaluation at all."""
    program = find_stereo_hls()
    breaks = stand_in(
        tmp_path,
        f"""
if "sgm_450" in sys.argv:
    sys.exit(2) if print("stereo_hls: no more", file=sys.stderr) is None and {{fails}} else None
with open({str(tmp_path / "calls")!r}, "a") as file:
    file.write("call\\n")
os.execv({program!r}, ["stereo_hls", *sys.argv[1:]])
""",
    )
    text = (tmp_path / "stereo_hls").read_text()
    fails = tmp_path / "fails"
    fails.write_text("")
    (tmp_path / "stereo_hls").write_text(text.replace("{fails}", f"pathlib.Path({str(fails)!r}).exists()"))
    words = [*pair(scene), *SWEEP, "--out", tmp_path / "out"]
    first = call("explore.py", *words, environment=breaks)
    assert first.returncode == 2 and "1 of 2 evaluations are in" in first.stdout
    assert not (tmp_path / "out" / "explore.json").exists()
    with (tmp_path / "out" / "evaluations.jsonl").open("a") as file:
        file.write('{"key": "broken o')
    fails.unlink()
    for calls, before in ((2, 1), (2, 2)):
        again = call("explore.py", *words, environment=breaks)
        assert again.returncode == 0, again.stderr
        assert f"{before} of 2 evaluations are in" in again.stdout
        assert (tmp_path / "calls").read_text().count("call") == calls
    (scene / "disparity_left.png").write_bytes((scene / "disparity_left.png").read_bytes() + b"\0")
    changed = call("explore.py", *words, environment=breaks)
    assert changed.returncode == 0 and "from before" not in changed.stdout, "other files, other evaluations"
