# SPDX-License-Identifier: Apache-2.0
"""What commands do with files that are there already: inputs and files of the user stay, those of an earlier run go."""

import json
import os

import pytest

import plane_scene
from stereo_hls_program import changed, fail, run, succeed, write_image

ALL = ["--write", "pfm", "--write", "kitti"]


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def own(folder, *names):
    """Files of the user's."""
    folder.mkdir(exist_ok=True)
    for name in names:
        (folder / name).write_text("the user's own")


def are_kept(folder, *names):
    return all((folder / name).read_text() == "the user's own" for name in names)


def test_files_of_the_user_stay_however_often_match_runs(tmp_path, match):
    names = ["valid.png", "filled.png", "confidence.png", "disparity.pfm", "notes.txt"]
    own(tmp_path / "out", *names)
    for _ in range(3):
        succeed(*match)
        assert are_kept(tmp_path / "out", *names)


def test_files_of_an_earlier_match_go_with_it(tmp_path, match):
    succeed(*match)
    plain = contents(tmp_path / "out").keys()
    own(tmp_path / "out", "filled.png")
    succeed(*changed(match, "--config", "tiny_lr"), *ALL)
    facts = json.loads((tmp_path / "out" / "match.json").read_text())
    assert {*facts["files"], "match.json", "filled.png"} == contents(tmp_path / "out").keys()
    # Not even where somebody has taken a part of the result away.
    (tmp_path / "out" / "overview.png").unlink()
    succeed(*match)
    assert contents(tmp_path / "out").keys() == plain | {"filled.png"} and are_kept(tmp_path / "out", "filled.png")


@pytest.mark.parametrize("listed", ["../kept.txt", "/etc/hostname", "sub/kept.txt", "", ".", 7, None])
def test_a_list_of_somebody_else_leads_nowhere(tmp_path, match, listed):
    own(tmp_path, "kept.txt")
    own(tmp_path / "out")
    own(tmp_path / "out" / "sub", "kept.txt")
    (tmp_path / "out" / "match.json").write_text(json.dumps({"files": [listed]}))
    succeed(*match)
    assert are_kept(tmp_path, "kept.txt") and are_kept(tmp_path / "out" / "sub", "kept.txt")


def test_validity_of_another_run_is_not_taken(tmp_path, match, pair):
    """The map of `match` as it is in a folder of its own, though a valid.png stands beside it."""
    succeed(*match)
    truth = write_image(tmp_path / "truth.pgm", maximum=7)
    words = [
        "evaluate",
        *pair,
        "--truth-right",
        truth,
        "--border",
        0,
        "--disparity",
        tmp_path / "out" / "disparity.png",
    ]
    alone = succeed(*words)
    mask = tmp_path / "mask"
    succeed(*changed(changed(match, "--config", "tiny_lr"), "--out", mask))
    (tmp_path / "out" / "valid.png").write_bytes((mask / "valid.png").read_bytes())
    assert succeed(*words) == alone


def test_no_command_replaces_an_input(tmp_path, match, pair):
    out = tmp_path / "out"
    succeed(*match)
    before = contents(out)
    map_words = ["--left", out / "disparity.png", "--right", out / "disparity.png"]
    fail(tmp_path, *match[: match.index("--left")], *map_words, says=["out/disparity.png: is an input"])
    left = pair[1]
    assert left.name == "l.pgm"
    truth = write_image(tmp_path / "truth.pgm", maximum=7)
    evaluate = ["evaluate", *pair, "--truth-right", truth, "--config", "tiny", "--border", 0]
    for file in (left, truth):
        fail(tmp_path, *evaluate, "--json", file, says=[f"{file.name}: is an input", "--json"])
    assert contents(out) == before


@pytest.mark.parametrize("link", [False, True])
def test_depth_and_rectify_into_the_folder_of_the_images(tmp_path, link):
    """Not even by another name of the folder."""
    folder = tmp_path / "cameras"
    folder.mkdir()
    left, right = (write_image(folder / f"{side}.png.pgm", 160, 120) for side in ("left", "right"))
    left, right = left.rename(folder / "left.png"), right.rename(folder / "right.png")
    file = plane_scene.calibration(folder / "c.yml")
    out = folder
    if link:
        out = tmp_path / "link"
        out.symlink_to(folder)
    images = ["--left", left, "--right", right]
    before = contents(folder)
    for command in (["depth", "--config", "study"], ["rectify"]):
        fail(tmp_path, *command, "--calibration", file, *images, "--out", out, says=["left.png: is an input", "--out"])
    # Without images of its own among the results, the calibration must stay, too.
    named = file.rename(folder / "depth.json")
    rectified = ["depth", "--config", "study", "--rectified", "--calibration", named, *images, "--out", out]
    fail(tmp_path, *rectified, says=["depth.json: is an input"])
    assert contents(folder) == {**{k: v for k, v in before.items() if k != "c.yml"}, "depth.json": before["c.yml"]}


def test_images_of_the_user_stay_where_rectify_writes_tables_only(tmp_path):
    own(tmp_path / "out", "left.png", "right.png")
    file = plane_scene.calibration(tmp_path / "c.yml")
    for _ in range(2):
        succeed("rectify", "--calibration", file, "--width", 160, "--height", 120, "--out", tmp_path / "out")
        assert are_kept(tmp_path / "out", "left.png", "right.png")


def test_frames_of_the_user_stay(tmp_path):
    """Behind those of the result; a video goes into no folder and no file that it is made of."""
    for side in ("l", "r"):
        (tmp_path / side).mkdir()
        for number in range(2):
            write_image(tmp_path / side / f"{number}.pgm", seed=number)
    words = ["video", "--config", "tiny", "--left", tmp_path / "l", "--right", tmp_path / "r", "--out"]
    names = ["frame_000002.png", "frame_000003.png"]
    own(tmp_path / "out", *names)
    for _ in range(2):
        said = succeed(*words, tmp_path / "out")
        assert "out also holds 2 frames that no run has written, from frame_000002.png on; they stay\n" in said
        assert are_kept(tmp_path / "out", *names)
    fail(tmp_path, *words, tmp_path / "l", says=["--out", "is an input"])
    film = tmp_path / "film.avi"
    succeed(*words, film)
    again = ["video", "--config", "tiny", "--side-by-side", film, "--out", film]
    fail(tmp_path, *again, says=["film.avi: is an input"])


def test_what_is_no_regular_file_is_not_replaced(tmp_path, match, pair):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "there").write_text("the user's own")
    (tmp_path / "link").symlink_to("there")
    truth = write_image(tmp_path / "truth.pgm", maximum=7)
    evaluate = ["evaluate", *pair, "--truth-right", truth, "--config", "tiny", "--border", 0, "--json"]
    for name in ("pipe", "link"):
        fail(tmp_path, *evaluate, tmp_path / name, says=[f"{name}: is no regular file", "--json"])
    assert (tmp_path / "link").is_symlink() and (tmp_path / "pipe").is_fifo() and are_kept(tmp_path, "there")
    assert run(*evaluate, tmp_path / "new.json").returncode == 0
