# SPDX-License-Identifier: Apache-2.0
"""Lists of pairs, the error in colour, and what the rows of docs/quality.md find on roads, in a room and in a yard."""

import json

import pytest

from flow.base.errors import FlowError
from flow.base.tools import find_stereo_hls, run
from flow.pages import quality_pairs
from flow.quality import error_picture
from flow.quality.pairs import Pair, read_pairs
from flow_commands import call, refused

# Percent of wrong pixels of `sgm_450` that no later choice of parameters may exceed (dense D1, border 0, full width).
LARGEST_D1 = {"kitti15_a": 7.6, "kitti12_a": 5.0, "eth3d_a": 2.4, "teddy": 11.4}
ENTRY = {
    "name": "mine",
    "title": "My pair",
    "left": "left.png",
    "right": "right.png",
    "truth_left": "disparity_left.png",
    "truth_scale": 1,
    "disparities": 32,
}


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    """A folder with a generated pair and a list that names it."""
    folder = tmp_path_factory.mktemp("scene")
    size = ("--width", 160, "--height", 60, "--disparities", 32, "--seed", 1)
    run([find_stereo_hls(), "scene", *size, "--out", folder])
    (folder / "pairs.json").write_text(json.dumps([ENTRY]))
    return folder


@pytest.mark.parametrize("name", LARGEST_D1)
def test_semi_global_matching_holds_indoors_and_outdoors(name):
    (pair,) = (pair for pair in quality_pairs.own_pairs() if pair.name == name)
    if pair.missing:
        pytest.skip(
            f"SKIP: the pair {name} is missing ({pair.missing[0]}); set STEREO_DATA to the folder that holds it"
        )
    assert 100 * quality_pairs.dense_d1(quality_pairs.measure(pair)[quality_pairs.ROWS[0].title]) <= LARGEST_D1[name]


def test_a_list_of_other_pairs_is_measured_where_it_lies(scene):
    done = call("quality.py", "--pairs", scene / "pairs.json")
    assert done.returncode == 0, done.stderr
    for part in ("### My pair", "| D1, dense | My pair |", "| StereoSGBM |", f"| {quality_pairs.ROWS[0].title} |"):
        assert part in done.stdout


def test_pictures_show_the_error_of_each_pair(scene, tmp_path):
    done = call("quality.py", "--pairs", scene / "pairs.json", "--pictures", tmp_path / "pictures")
    assert done.returncode == 0, done.stderr
    names = {path.name for path in (tmp_path / "pictures").iterdir()}
    assert names == {"mine_sgm_450.png", "mine_census_450.png"}


def test_errors_have_the_colour_of_their_size():
    numpy = pytest.importorskip("numpy")
    pytest.importorskip("matplotlib")
    truth = numpy.array([[10.0, 10.0, 10.0, numpy.inf, 10.0]])
    found = numpy.array([[10.2, 12.5, 30.0, 10.0, numpy.inf]])
    colors = [tuple(round(255 * value) for value in color) for color in error_picture.error_colors(found, truth)[0]]
    assert colors == [(0x31, 0x36, 0x95), (0xFE, 0xE0, 0x90), (0xA5, 0x00, 0x26), (191, 191, 191), (0, 0, 0)]


def test_truth_is_read_in_pixels_with_its_first_row_on_top(tmp_path):
    numpy = pytest.importorskip("numpy")
    rows = numpy.array([[1.0, 2.0], [3.0, numpy.inf]], dtype="<f4")
    (tmp_path / "truth.pfm").write_bytes(b"Pf\n2 2\n-1.0\n" + rows[::-1].tobytes())
    files = (tmp_path / "left.png", tmp_path / "right.png", tmp_path / "truth.pfm")
    pair = Pair("a", "A", *files, 2.0, 16)
    assert numpy.array_equal(error_picture.read_truth(pair), rows / 2)


@pytest.mark.parametrize("name", ["truth.pfm", "truth.npy", "truth.png"])
def test_a_truth_that_cannot_be_drawn_is_named(name, tmp_path):
    pytest.importorskip("numpy")
    pytest.importorskip("PIL")
    (tmp_path / name).write_bytes(b"PF\n2 2\n-1.0\n")
    pair = Pair("a", "A", tmp_path / "left.png", tmp_path / "right.png", tmp_path / name, 1.0, 16)
    with pytest.raises(FlowError, match=f"{name} cannot be drawn"):
        error_picture.read_truth(pair)


BROKEN = {
    "no list": ({}, "must be a list of pairs"),
    "an empty list": ([], "must be a list of pairs"),
    "an entry too few": ([{**ENTRY, "extra": 1}], "has the entries name, title"),
    "no text": ([{**ENTRY, "left": 3}], "left of a pair must be a text"),
    "a scale of 0": ([{**ENTRY, "truth_scale": 0}], "truth_scale of mine must be a number above 0"),
    "no range": ([{**ENTRY, "disparities": 1}], "disparities of mine must be 2 ... 256"),
    "a name that leads away": ([{**ENTRY, "name": "../mine"}], "must be that of a file"),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_list_that_cannot_be_used_is_refused(case, tmp_path):
    content, sentence = BROKEN[case]
    path = tmp_path / "pairs.json"
    path.write_text(json.dumps(content))
    with pytest.raises(FlowError, match=sentence):
        read_pairs(path)


def test_a_pair_that_is_not_there_is_named(tmp_path):
    (tmp_path / "pairs.json").write_text(json.dumps([ENTRY]))
    refused(call("quality.py", "--pairs", tmp_path / "pairs.json"), 2, f"{tmp_path / 'left.png'} is missing")
