# SPDX-License-Identifier: Apache-2.0
"""The program stereo_hls as its users meet it, whatever the command: messages, exit codes, what a failure leaves."""

import os
import shutil
import subprocess

import pytest

from stereo_hls_program import PROGRAM, changed, fail, succeed


def test_version():
    assert succeed("--version").strip().count(".") == 2


def test_help_names_the_exit_codes():
    assert "Exit codes: 0 success; 1 internal failure; 2 wrong usage or input" in succeed("--help")


def test_a_start_loads_no_readers_of_images():
    """The libraries behind them take ten times as long to load as all others together."""
    process = subprocess.run(
        [PROGRAM], capture_output=True, text=True, env={**os.environ, "LD_TRACE_LOADED_OBJECTS": "1"}
    )
    assert "libopencv_core" in process.stdout
    assert "imgcodecs" not in process.stdout and "videoio" not in process.stdout


def test_a_program_without_its_modules(tmp_path):
    shutil.copy(PROGRAM, tmp_path / "stereo_hls")
    words = [tmp_path / "stereo_hls", "scene", "--config", "tiny", "--seed", "1", "--out", tmp_path / "out"]
    process = subprocess.run(words, capture_output=True, text=True)
    assert process.returncode == 3 and process.stderr.count("\n") == 1
    assert f"{tmp_path}/stereo_hls_images.so cannot be loaded; it belongs beside the program" in process.stderr
    assert not (tmp_path / "out").exists()


def test_unknown_configuration_lists_the_known(tmp_path, match):
    fail(tmp_path, *changed(match, "--config", "nope"), says=["nope", "ambrosch2007", "tiny"])
    fail(tmp_path, "scene", "--out", tmp_path / "s", "--seed", 1, "--config", "nope", says=["nope", "tiny"])


def test_folder_that_cannot_be_created(tmp_path, match):
    (tmp_path / "file").write_text("")
    fail(tmp_path, *changed(match, "--out", tmp_path / "file" / "out"), says=["--out", tmp_path / "file"])
    fail(tmp_path, *changed(match, "--out", tmp_path / "file"), says=["--out", tmp_path / "file"])


def test_names_that_the_system_refuses(tmp_path, match):
    """As in folders without rights, the look at the file itself fails."""
    name = tmp_path / ("x" * 300)
    fail(tmp_path, *changed(match, "--left", name), says=[name, "File name too long"])
    fail(tmp_path, *changed(match, "--out", name), says=["--out", name, "File name too long"])


def fail_to_print(folder, *arguments):
    """Nothing is written either."""
    before = sorted(folder.rglob("*"))
    with open("/dev/full", "w") as full:
        process = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, cwd=folder)
    assert process.returncode == 1
    assert process.stderr == "stereo_hls: internal failure: the result cannot be written to standard output\n"
    assert sorted(folder.rglob("*")) == before


@pytest.mark.parametrize(
    "command",
    [
        ["configurations"],
        ["configurations", "--json"],
        ["scene", "--seed", "1", "--out", "deep/scene"],
        ["--help"],
        ["match", "--help"],
        ["--version"],
    ],
)
def test_a_result_that_does_not_reach_stdout_is_a_failure(tmp_path, command):
    fail_to_print(tmp_path, *command)


def test_results_of_a_pair_that_do_not_reach_stdout_are_a_failure(tmp_path, match, pair):
    fail_to_print(tmp_path, *match)
    truth = ["--truth-right", pair[1], "--border", "0"]
    fail_to_print(tmp_path, "evaluate", *pair, *truth, "--config", "tiny", "--json", "deep/e.json")


@pytest.mark.parametrize("out", ["deep/out", "deep/out.avi"])
def test_a_video_whose_summary_does_not_reach_stdout_is_a_failure(tmp_path, pair, out):
    for camera in ("l", "r"):
        (tmp_path / "cameras" / camera).mkdir(parents=True)
        (tmp_path / f"{camera}.pgm").rename(tmp_path / "cameras" / camera / "0.pgm")
    fail_to_print(tmp_path, "video", "--config", "tiny", "--left", "cameras/l", "--right", "cameras/r", "--out", out)


def test_a_failure_leaves_no_folder_behind(tmp_path, match):
    """Not those above the one that cannot be made either; folders that were there stay."""
    (tmp_path / "there").mkdir()
    fail(
        tmp_path,
        *changed(match, "--out", tmp_path / "there" / "made" / ("x" * 300)),
        says=["--out", "File name too long"],
    )
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    fail(tmp_path, *changed(match, "--out", tmp_path / "link"), says=["--out", tmp_path / "link"])


@pytest.mark.parametrize(
    "arguments, says",
    [
        ([], "subcommand"),
        (["match", "--left", "x"], "--config"),
        (["configurations", "--frobnicate"], "--frobnicate"),
        (["scene", "--out", "o", "--seed", "one"], "--seed"),
        (["scene", "--out", "o", "--seed", "-1"], "--seed"),
        (["scene", "--out", "o", "--seed", "1", "--config", "tiny", "--width", "9"], "--width"),
        (["scene", "--out", "o", "--seed", "1", "--width", "9"], "disparity range"),
        (["scene", "--out", "o", "--seed", "1", "--width", "9", "--frames", "2"], "disparity range"),
        (["scene", "--out", "o", "--seed", "1", "--frames", "0"], "--frames"),
        (["frobnicate"], "frobnicate: unknown command"),
        (["--frobnicate"], "--frobnicate: unknown command"),
    ],
)
def test_wrong_usage(tmp_path, arguments, says):
    fail(tmp_path, *arguments, says=[says])


@pytest.mark.parametrize("option, value", [("--engine", "slow"), ("--fit", "stretch"), ("--fit", "1")])
def test_words_that_are_no_choice(tmp_path, match, option, value):
    fail(tmp_path, *match, option, value, says=[option, value])


def test_an_empty_value_is_refused():
    words = [PROGRAM, "scene", "--config", "tiny", "--seed", "1", "--out="]
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 2 and "--out" in result.stderr, result.stderr


def test_a_pipe_as_image_is_refused(tmp_path):
    os.mkfifo(tmp_path / "left.png")
    words = [PROGRAM, "match", "--config", "tiny", "--left", tmp_path / "left.png", "--right", tmp_path / "left.png"]
    result = subprocess.run([*words, "--out", tmp_path / "out"], capture_output=True, text=True, timeout=20)
    assert result.returncode == 2 and "left.png: is a pipe or a device" in result.stderr
