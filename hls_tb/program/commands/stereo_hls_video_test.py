# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls video: folders and video files in and out, and input that it refuses."""

import re

import pytest

from stereo_hls_program import HEIGHT, WIDTH, changed, fail, png_size, succeed, write_image

FRAMES = 4


def folder(tmp_path, name, frames=FRAMES, width=WIDTH, height=HEIGHT, channels=1):
    path = tmp_path / name
    path.mkdir()
    for number in range(frames):
        write_image(
            path / f"{number:03}.{'pgm' if channels == 1 else 'ppm'}", width, height, channels, seed=f"{name} {number}"
        )
    return path


@pytest.fixture
def cameras(tmp_path):
    return ["--left", folder(tmp_path, "l"), "--right", folder(tmp_path, "r")]


@pytest.fixture
def video(tmp_path):
    return ["video", "--config", "tiny", "--out", tmp_path / "out"]


def names(path):
    return sorted(p.name for p in path.iterdir())


def test_folders_to_a_folder(tmp_path, video, cameras):
    (tmp_path / "l" / "notes.txt").write_text("no image")
    out = succeed(*video, *cameras)
    rates = re.search(
        rf"^{FRAMES} frames of {WIDTH}x{HEIGHT}: ([0-9.]+) frames a second in the matching alone \(threads: \d+\), "
        r"([0-9.]+) overall$",
        out,
        re.M,
    )
    assert rates and float(rates[1]) >= float(rates[2]) > 0
    assert names(tmp_path / "out") == [f"frame_{number:06}.png" for number in range(FRAMES)]
    assert {png_size(p) for p in (tmp_path / "out").iterdir()} == {(2 * WIDTH, HEIGHT)}
    assert len({p.read_bytes() for p in (tmp_path / "out").iterdir()}) == FRAMES
    for camera in ("l", "r"):
        (tmp_path / "alone" / camera).mkdir(parents=True)
        (tmp_path / camera / "002.pgm").rename(tmp_path / "alone" / camera / "002.pgm")
    video[video.index("--out") + 1] = tmp_path / "one"
    succeed(*video, "--left", tmp_path / "alone" / "l", "--right", tmp_path / "alone" / "r")
    assert names(tmp_path / "one") == ["frame_000000.png"]
    assert (tmp_path / "one" / "frame_000000.png").read_bytes() == (tmp_path / "out" / "frame_000002.png").read_bytes()


def test_missing_frames_move_none(tmp_path, video, cameras):
    """Different ones of each camera: the others are paired as before."""
    succeed(*video, *cameras)
    all_frames = [(tmp_path / "out" / name).read_bytes() for name in names(tmp_path / "out")]
    (tmp_path / "l" / "001.pgm").unlink()
    (tmp_path / "r" / "002.pgm").unlink()
    out = succeed(*video, *cameras)
    assert "warning: 1 frame of --left without a partner in --right, left out: 002.pgm\n" in out
    assert "warning: 1 frame of --right without a partner in --left, left out: 001.pgm\n" in out
    assert [p.read_bytes() for p in sorted((tmp_path / "out").iterdir())] == [all_frames[0], all_frames[3]]


def test_frames_are_paired_by_their_numbers(tmp_path, video):
    """1 ... 12 and 001 ... 012, in the order of numbers; hidden files are no frames."""
    cameras = ["--left", folder(tmp_path, "l", 12), "--right", folder(tmp_path, "r", 12)]
    succeed(*video, *cameras)
    wanted = [(tmp_path / "out" / name).read_bytes() for name in names(tmp_path / "out")]
    for number in range(12):
        (tmp_path / "l" / f"{number:03}.pgm").rename(tmp_path / "l" / f"{number}.pgm")
    write_image(tmp_path / "l" / "._0.pgm")
    (tmp_path / "r" / ".hidden.pgm").write_bytes(b"no image")
    assert "warning" not in succeed(*video, *cameras)
    assert [(tmp_path / "out" / name).read_bytes() for name in names(tmp_path / "out")] == wanted
    both = tmp_path / "both"
    both.mkdir()
    for number in range(12):
        write_image(both / f"{number}.pgm", 2 * WIDTH, seed=number)
    succeed(*video, "--side-by-side", both)
    unpadded = [(tmp_path / "out" / name).read_bytes() for name in names(tmp_path / "out")]
    for number in range(12):
        (both / f"{number}.pgm").rename(both / f"{number:02}.pgm")
    succeed(*video, "--side-by-side", both)
    assert [(tmp_path / "out" / name).read_bytes() for name in names(tmp_path / "out")] == unpadded


def test_folders_with_nothing_in_common(tmp_path, video, cameras):
    for number in range(FRAMES):
        (tmp_path / "r" / f"{number:03}.pgm").rename(tmp_path / "r" / f"{number + 90}.pgm")
    fail(tmp_path, *video, *cameras, says=["--left", "--right", "no frame of one", "000.pgm and 90.pgm"])


def test_speckles_and_confidence(tmp_path, video, cameras):
    def frames(*words):
        succeed(*video, *cameras, *words)
        return [p.read_bytes() for p in sorted((tmp_path / "out").iterdir())]

    plain = frames()
    assert frames("--speckle-window", 1, "--speckle-range", 256) == plain, "no pixel is alone"
    for words in (["--speckle-window", 400], ["--least-confidence", 255]):
        assert not set(frames(*words)) & set(plain)


def test_endings_in_capitals(tmp_path, video, cameras):
    for camera in ("l", "r"):
        for path in list((tmp_path / camera).iterdir()):
            path.rename(path.with_suffix(".PGM"))
    succeed(*video, *cameras)
    assert len(names(tmp_path / "out")) == FRAMES
    video[video.index("--out") + 1] = tmp_path / "OUT.AVI"
    succeed(*video, *cameras)
    assert avi_frames(tmp_path / "OUT.AVI")[0] == FRAMES


@pytest.mark.parametrize("name", ["out.mp4", "out.MKV", "out.mov"])
def test_videos_of_other_kinds_are_not_written(tmp_path, video, cameras, name):
    video[video.index("--out") + 1] = tmp_path / name
    fail(tmp_path, *video, *cameras, says=["--out", name, ".avi"])


def test_frames_of_a_longer_result_do_not_stay(tmp_path, video, cameras):
    succeed(*video, *cameras)
    (tmp_path / "out" / "notes.txt").write_text("not ours")
    fewer = ["--left", folder(tmp_path, "lf", 2), "--right", folder(tmp_path, "rf", 2)]
    succeed(*video, *fewer)
    assert names(tmp_path / "out") == ["frame_000000.png", "frame_000001.png", "notes.txt"]


def avi_frames(path):
    """Frames that the video says it has, and those it holds."""
    data = path.read_bytes()
    assert data[:4] == b"RIFF" and data[8:12] == b"AVI " and b"MJPG" in data[:300]
    header = data.index(b"avih") + 8
    said, width, height = (int.from_bytes(data[header + at : header + at + 4], "little") for at in (16, 32, 36))
    return said, data.count(b"\xff\xd8\xff"), (width, height)


def test_videos_in_and_out(tmp_path, video, cameras):
    """Folders become a video; two of them, as the cameras' videos, another one."""
    size = {"width": 96, "height": 64, "channels": 3}
    pair = ["--left", folder(tmp_path, "lc", **size), "--right", folder(tmp_path, "rc", **size)]
    video[video.index("--out") + 1] = tmp_path / "deep" / "first.avi"
    out = succeed(*video, *pair)
    assert f"{FRAMES} frames of 96x64" in out and str(tmp_path / "deep" / "first.avi") in out
    assert avi_frames(tmp_path / "deep" / "first.avi") == (FRAMES, FRAMES, (192, 64))
    first = tmp_path / "deep" / "first.avi"
    video[video.index("--out") + 1] = tmp_path / "second.avi"
    assert f"{FRAMES} frames of 192x64" in succeed(*video, "--left", first, "--right", first, "--frames-per-second", 10)
    assert avi_frames(tmp_path / "second.avi") == (FRAMES, FRAMES, (384, 64))
    video[video.index("--out") + 1] = tmp_path / "third"
    assert f"{FRAMES} frames of 96x64" in succeed(*video, "--side-by-side", first)
    assert names(tmp_path / "deep") == ["first.avi"] and len(names(tmp_path / "third")) == FRAMES


def test_a_video_that_is_cut_off(tmp_path, video, cameras):
    """OpenCV reads what is there."""
    out = video.index("--out") + 1
    video[out] = tmp_path / "whole.avi"
    succeed(*video, *cameras)
    data = (tmp_path / "whole.avi").read_bytes()
    cut = tmp_path / "cut.avi"
    cut.write_bytes(data[: data.index(b"\xff\xd8\xff", data.index(b"\xff\xd8\xff") + 3)])
    video[out] = tmp_path / "maps"
    said = succeed(*video, "--left", cut, "--right", cut)
    assert f"warning: --left {cut}: only 1 of {FRAMES} frames can be read\n" in said
    assert "warning" not in succeed(*video, "--left", tmp_path / "whole.avi", "--right", tmp_path / "whole.avi")


def test_side_by_side_is_the_same_as_two_folders(tmp_path, video, cameras):
    both = tmp_path / "both"
    both.mkdir()
    for left, right in zip(sorted((tmp_path / "l").iterdir()), sorted((tmp_path / "r").iterdir())):
        halves = [p.read_bytes()[-WIDTH * HEIGHT :] for p in (left, right)]
        rows = (half[y * WIDTH : (y + 1) * WIDTH] for y in range(HEIGHT) for half in halves)
        (both / left.name).write_bytes(f"P5\n{2 * WIDTH} {HEIGHT}\n255\n".encode() + b"".join(rows))
    succeed(*video, *cameras)
    expected = [p.read_bytes() for p in sorted((tmp_path / "out").iterdir())]
    video[video.index("--out") + 1] = tmp_path / "again"
    succeed(*video, "--side-by-side", both)
    assert [p.read_bytes() for p in sorted((tmp_path / "again").iterdir())] == expected


def test_options_change_the_result(tmp_path, video, cameras):
    succeed(*video, *cameras)
    plain = (tmp_path / "out" / "frame_000000.png").read_bytes()
    succeed(*video, *cameras, "--set", "reference=left", "--set", "median=true")
    assert (tmp_path / "out" / "frame_000000.png").read_bytes() != plain


def test_wrong_usage(tmp_path, video, cameras):
    fail(tmp_path, *video, says=["--left and --right", "--side-by-side"])
    fail(tmp_path, *video, *cameras[:2], says=["--left and --right"])
    fail(tmp_path, *video, *cameras, "--side-by-side", tmp_path / "l", says=["--side-by-side"])
    fail(tmp_path, *video, *cameras, "--set", "window=1", says=["--set window=1"])
    fail(tmp_path, *video, *cameras, "--set", f"disparities={WIDTH}", says=["--config tiny", "32x12"])
    fail(tmp_path, *video, *cameras, "--frames-per-second", "0", says=["--frames-per-second"])
    fail(tmp_path, *video[:2], "nope", *video[3:], *cameras, says=["nope", "tiny"])


def test_nothing_to_read(tmp_path, video, cameras):
    (tmp_path / "empty").mkdir()
    (tmp_path / "text.avi").write_text("no video")
    (tmp_path / "cut.avi").write_bytes(b"RIFF\x10\0\0\0AVI LIST")
    fail(tmp_path, *video, "--left", tmp_path / "empty", *cameras[2:], says=["--left", "empty", "no images"])
    fail(tmp_path, *video, *cameras[:3], tmp_path / "none", says=["--right", "none", "no such file or folder"])
    for name in ("text.avi", "cut.avi"):
        fail(tmp_path, *video, "--side-by-side", tmp_path / name, says=["--side-by-side", name, "not a video"])


def test_a_frame_that_cannot_be_read(tmp_path, video):
    """Of numbered images, which OpenCV takes as a video; its reader of other videos ends early instead."""
    first = write_image(tmp_path / "f_0.pgm", 2 * WIDTH)
    (tmp_path / "f_1.pgm").write_bytes(b"P5\n2000000 12\n255\n")
    fail(tmp_path, *video, "--side-by-side", first, says=["--side-by-side", "f_0.pgm: frame 2 cannot be read"])


@pytest.mark.parametrize("sink", ["out", "out.avi"])
def test_frames_that_do_not_fit(tmp_path, video, cameras, sink):
    """Nothing is left of a result that was begun."""
    video[video.index("--out") + 1] = tmp_path / "made" / "deep" / sink
    fewer = tmp_path / "fewer.avi"
    short = [folder(tmp_path, "s", FRAMES - 1, width=WIDTH // 2), folder(tmp_path, "t", FRAMES - 1, width=WIDTH // 2)]
    succeed(*changed(video, "--out", fewer), "--left", short[0], "--right", short[1], "--set", "disparities=4")
    fail(tmp_path, *video, *cameras[:3], fewer, says=["--right", f"after {FRAMES - 1} frames"])
    fail(tmp_path, *video, "--left", fewer, *cameras[2:], says=["--left", f"after {FRAMES - 1} frames"])
    fail(
        tmp_path,
        *video,
        *cameras[:3],
        folder(tmp_path, "wide", width=WIDTH + 1),
        says=["differ in size", "32x12", "33x12"],
    )
    fail(
        tmp_path,
        *video,
        "--side-by-side",
        folder(tmp_path, "odd", width=2 * WIDTH + 1),
        says=["--side-by-side", "65 pixels wide"],
    )
    write_image(tmp_path / "l" / "002.pgm", WIDTH, HEIGHT + 1)
    fail(tmp_path, *video, *cameras, says=["002.pgm", "32x13", "32x12"])
    (tmp_path / "l" / "002.pgm").write_bytes(b"P5")
    fail(tmp_path, *video, *cameras, says=["002.pgm", "not an image"])


def test_results_that_cannot_be_written(tmp_path, video, cameras):
    (tmp_path / "file").write_text("")
    (tmp_path / "folder.avi").mkdir()
    for path in (tmp_path / "file" / "x", tmp_path / "file" / "x.avi", tmp_path / "folder.avi"):
        video[video.index("--out") + 1] = path
        fail(tmp_path, *video, *cameras, says=["--out", path])
