# SPDX-License-Identifier: Apache-2.0
"""A full disk, an interruption, and what stood in the folder before: no half of a result, no file of a name that nobody
gave."""

import resource
import signal
import subprocess
import time

import pytest

from stereo_hls_program import PROGRAM, changed, fail, succeed, write_image


def folder(path, frames):
    path.mkdir()
    for number in range(frames):
        write_image(path / f"{number:04}.pgm", seed=f"{path.name} {number}")
    return path


def small_files(most_bytes):
    """As on a disk that is full after so many."""

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, resource.RLIM_INFINITY))

    return limit


COMMANDS = {
    "match": ["match", "--config", "tiny", "--left", "l.pgm", "--right", "r.pgm", "--out", "made/out"],
    "evaluate": ["evaluate", "--config", "tiny", "--left", "l.pgm", "--right", "r.pgm", "--truth-right", "r.pgm"]
    + ["--border", "0", "--json", "made/e.json"],
    "vectors": ["vectors", "--config", "tiny", "--left", "l.pgm", "--right", "r.pgm", "--out", "made/v"],
    "trace": ["trace", "--config", "tiny", "--out", "made/t"],
    "scene": ["scene", "--config", "tiny", "--seed", "1", "--out", "made/s"],
    "moving scene": ["scene", "--config", "tiny", "--seed", "1", "--frames", "3", "--out", "made/s"],
    "video to a folder": ["video", "--config", "tiny", "--left", "l", "--right", "r", "--out", "made/out"],
    "video": ["video", "--config", "tiny", "--left", "l", "--right", "r", "--out", "made/out.avi"],
}


@pytest.fixture
def inputs(tmp_path):
    for name in ("l", "r"):
        write_image(tmp_path / f"{name}.pgm", seed=name)
        folder(tmp_path / name, 4)
    return tmp_path


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("most_bytes", [0, 100, 5_000])
def test_a_full_disk(inputs, command, most_bytes):
    """A failure in one sentence; what was made is gone again. Where all fits, all is there."""
    before = sorted(inputs.rglob("*"))
    words = [PROGRAM, *COMMANDS[command]]
    full = subprocess.run(words, cwd=inputs, capture_output=True, text=True, preexec_fn=small_files(most_bytes))
    if full.returncode == 0:
        largest = max(path.stat().st_size for path in inputs.rglob("made/**/*"))
        assert largest <= most_bytes
        return
    assert full.returncode == 2 and full.stderr.count("\n") == 1 and "cannot be written" in full.stderr, full.stderr
    assert sorted(inputs.rglob("*")) == before
    assert subprocess.run(words, cwd=inputs, capture_output=True).returncode == 0, "with room it works"
    assert max(path.stat().st_size for path in inputs.rglob("made/**/*")) > most_bytes


@pytest.mark.parametrize("most_bytes", range(4_000, 20_000, 2_500))
def test_a_video_that_is_cut_anywhere(inputs, most_bytes):
    """The writer of videos itself says nothing of a full disk."""
    words = [PROGRAM, *COMMANDS["video"]]
    succeeded = (
        subprocess.run(words, cwd=inputs, capture_output=True, preexec_fn=small_files(most_bytes)).returncode == 0
    )
    path = inputs / "made" / "out.avi"
    assert succeeded == path.exists()
    (inputs / "made" / "out.avi").unlink(missing_ok=True)
    assert subprocess.run(words, cwd=inputs, capture_output=True).returncode == 0
    assert succeeded == (path.stat().st_size <= most_bytes)


@pytest.fixture(scope="module")
def long_cameras(tmp_path_factory):
    path = tmp_path_factory.mktemp("long")
    return ["--left", folder(path / "l", 1500), "--right", folder(path / "r", 1500)]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("out", ["out", "out.avi"])
def test_an_interruption(tmp_path, long_cameras, number, out):
    """While a long video is written."""
    words = [PROGRAM, "video", "--config", "tiny", *long_cameras, "--out", tmp_path / out]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    while not list(tmp_path.glob(".out*")) + list(tmp_path.glob("out/.frame*")):
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.002)
    process.send_signal(number)
    assert process.wait(timeout=30) == -number
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_ignored_signals_stay_ignored(tmp_path, long_cameras):
    """As under nohup."""
    words = [PROGRAM, "video", "--config", "tiny", *long_cameras, "--out", tmp_path / "out.avi"]
    process = subprocess.Popen(
        words, stdout=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)
    )
    while not list(tmp_path.glob(".out*")):
        assert process.poll() is None
        time.sleep(0.002)
    process.send_signal(signal.SIGHUP)
    assert process.wait(timeout=60) == 0 and (tmp_path / "out.avi").exists()


def test_the_validity_of_an_earlier_run_does_not_stay(tmp_path, match):
    def files():
        return {p.name for p in (tmp_path / "out").iterdir()}

    succeed(*match)
    without = files()
    succeed(*changed(match, "--config", "tiny_lr"))
    assert files() == without | {"valid.png"}
    valid = tmp_path / "out" / "valid.png"
    succeed(*changed(changed(match, "--left", valid), "--right", valid))
    assert files() == without | {"valid.png"}, "it was read"
    succeed(*match)
    assert files() == without


def test_a_file_in_the_way_that_is_no_result_stays(tmp_path, match):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "valid.png").write_text("the user's own")
    succeed(*match)
    assert (tmp_path / "out" / "valid.png").read_text() == "the user's own"


def test_file_that_cannot_be_replaced(tmp_path, match):
    (tmp_path / "out" / "disparity_color.png").mkdir(parents=True)
    fail(tmp_path, *match, says=["--out", "disparity_color.png"])
