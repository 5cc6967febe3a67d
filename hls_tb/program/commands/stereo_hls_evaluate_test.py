# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls evaluate: figures of maps made by hand, files it reads, and input that it refuses."""

import json
import random
import struct
import zlib

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, fail, gray_as_colour, gray_image, run, succeed, write_image

MEASURES = {"pixels", "density", "avg_px", "rms_px", "d1", "bad_0_5", "bad_1", "bad_2", "bad_4"}


def pfm(path, value, width=WIDTH, height=HEIGHT, order="<"):
    rows = [[value(x, y) for x in range(width)] for y in reversed(range(height))]
    header = f"Pf\n{width} {height}\n{'-1.0' if order == '<' else '1.0'}\n".encode()
    path.write_bytes(header + b"".join(struct.pack(f"{order}{width}f", *row) for row in rows))
    return path


def png16(path, value, width=WIDTH, height=HEIGHT):
    """A grey PNG file of 16 bits, as KITTI's."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + struct.pack(f">{width}H", *(value(x, y) for x in range(width))) for y in range(height))
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )
    return path


def npy(path, value, width=WIDTH, height=HEIGHT):
    """As numpy.save writes an array of float32."""
    header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({height}, {width}), }}".ljust(117) + "\n"
    values = (value(x, y) for y in range(height) for x in range(width))
    body = struct.pack(f"<{width * height}f", *values)
    path.write_bytes(b"\x93NUMPY\1\0" + struct.pack("<H", len(header)) + header.encode() + body)
    return path


def float_tiff(path, value, width=WIDTH, height=HEIGHT):
    """A grey TIFF of 32-bit floats in one strip."""
    pixels = struct.pack(f"<{width * height}f", *(value(x, y) for y in range(height) for x in range(width)))
    long, short, start = 4, 3, 8
    tags = [
        (256, long, width),
        (257, long, height),
        (258, short, 32),
        (259, short, 1),
        (262, short, 1),
        (273, long, start),
        (277, short, 1),
        (278, long, height),
        (279, long, len(pixels)),
        (339, short, 3),
    ]
    entries = b"".join(struct.pack("<HHII", tag, kind, 1, number) for tag, kind, number in tags)
    directory = struct.pack("<H", len(tags)) + entries + struct.pack("<I", 0)
    path.write_bytes(b"II*\0" + struct.pack("<I", start + len(pixels)) + pixels + directory)
    return path


@pytest.fixture
def evaluate(pair, tmp_path):
    return ["evaluate", *pair, "--border", 0, "--json", tmp_path / "e.json"]


def results(tmp_path, *arguments):
    """The printed text and the methods of the JSON."""
    out = succeed(*arguments)
    found = json.loads((tmp_path / "e.json").read_text())
    assert found["format"] == "stereo-hls evaluation 1"
    return out, found["methods"]


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


@pytest.mark.parametrize("kind", ["pfm", "pgm", "ppm", "png16", "npy", "tiff"])
def test_every_kind_of_truth_says_the_same(tmp_path, evaluate, kind):
    value = lambda x, y: 0 if (x + y) % 5 == 0 else 2 + (x + 3 * y) % 9 / 4  # noqa: E731, 0: unknown
    truth, found = tmp_path / f"truth.{kind}", pfm(tmp_path / "found.pfm", lambda x, y: 3)
    if kind == "pfm":
        pfm(truth, lambda x, y: value(x, y) or float("inf"))
    elif kind in ("npy", "tiff"):
        {"npy": npy, "tiff": float_tiff}[kind](truth, lambda x, y: value(x, y) or float("nan"))
    elif kind in ("pgm", "ppm"):
        write = {"pgm": gray_image, "ppm": gray_as_colour}[kind]
        write(truth, lambda x, y: round(4 * value(x, y)))
    else:
        truth = png16(tmp_path / "truth.png", lambda x, y: round(256 * value(x, y)))
    scale = ["--truth-scale", 4] if kind in ("pgm", "ppm") else []
    _, [method] = results(
        tmp_path, *evaluate, "--truth-left", truth, *scale, "--disparity", found, "--reference", "left"
    )
    errors = [abs(3 - value(x, y)) for x in range(WIDTH) for y in range(HEIGHT) if value(x, y) != 0]
    mask = method["masks"]["all"]
    assert mask["pixels"] == len(errors) and mask["avg_px"] == pytest.approx(sum(errors) / len(errors), abs=1e-6)


KINDS = {"pfm": pfm, "npy": npy, "tiff": float_tiff, "png": png16, "pgm": gray_image}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [2, 16, 0.5, 100])
def test_a_given_scale_is_used_whatever_the_file(tmp_path, evaluate, kind, scale):
    """Of the truth and of a result; the JSON has the scale that was used."""
    stored = KINDS[kind](tmp_path / f"s.{kind}", lambda x, y: 40)
    plain = pfm(tmp_path / "p.pfm", lambda x, y: 40 / scale + 0.25)
    words = ["--disparity", stored, "--reference", "left", "--disparity-scale", scale]
    _, [method] = results(tmp_path, *evaluate, "--truth-left", plain, *words)
    assert method["parameters"] == {"scale": scale}
    assert method["masks"]["all"]["avg_px"] == pytest.approx(0.25, abs=1e-4)
    words = ["--truth-scale", scale, "--disparity", plain, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, "--truth-left", stored, *words)
    assert method["parameters"] == {"scale": 1}
    assert method["masks"]["all"]["avg_px"] == pytest.approx(0.25, abs=1e-4)


@pytest.mark.parametrize("kind, scale", [("png", 256), ("pgm", 1), ("pfm", 1), ("npy", 1), ("tiff", 1)])
def test_the_scale_that_was_used_is_recorded(tmp_path, evaluate, kind, scale):
    stored = KINDS[kind](tmp_path / f"s.{kind}", lambda x, y: 5 * scale)
    truth = pfm(tmp_path / "p.pfm", lambda x, y: 5)
    words = ["--truth-left", truth, "--disparity", stored, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, *words)
    assert method["parameters"] == {"scale": scale} and method["masks"]["all"]["avg_px"] == 0


@pytest.mark.parametrize("kind", ["pfm", "npy", "tiff"])
@pytest.mark.parametrize("mark", [float("nan"), float("inf"), float("-inf"), -1, -9999, 1e9])
def test_values_that_stand_for_unknown(tmp_path, evaluate, kind, mark):
    truth = KINDS[kind](tmp_path / f"t.{kind}", lambda x, y: mark if x < 3 else 5)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 5)
    words = ["--truth-left", truth, "--disparity", found, "--reference", "left"]
    said = ["--unknown", mark] if abs(mark) < float("inf") else []
    out, [method] = results(tmp_path, *evaluate, *words, *said)
    assert method["masks"]["all"]["pixels"] == (WIDTH - 3) * HEIGHT and method["masks"]["all"]["avg_px"] == 0
    assert "unknown" not in out
    if mark == 1e9:
        fail(tmp_path, *evaluate, *words, says=["0,", "is not a disparity", "--unknown"])
    elif said:
        out, [method] = results(tmp_path, *evaluate, *words)
        assert method["masks"]["all"]["pixels"] == WIDTH * HEIGHT
        assert (f"{3 * HEIGHT} pixels are -1: are they unknown? Then give --unknown -1" in out) == (mark == -1)
    # A result's, too.
    words = ["--truth-left", found, "--disparity", truth, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, *words, *said)
    assert method["masks"]["all"]["density"] == pytest.approx((WIDTH - 3) / WIDTH)


def test_a_mask_says_which_truth_counts(tmp_path, evaluate):
    mask = gray_image(tmp_path / "m.pgm", lambda x, y: 0 if x < 4 else 128 + x)
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 0 if x % 2 == 0 else 9)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 0 if x % 2 == 0 else 9)
    for side in ("left", "right"):
        words = [f"--truth-{side}", truth, "--disparity", found, "--reference", side]
        _, [method] = results(tmp_path, *evaluate, *words)
        assert method["masks"]["all"]["pixels"] == WIDTH // 2 * HEIGHT, "0: unknown"
        _, [method] = results(tmp_path, *evaluate, *words, f"--visible-{side}", mask)
        assert method["masks"]["all"]["pixels"] == (WIDTH - 4) * HEIGHT, "0 is a disparity, too"
        assert method["masks"]["all"]["avg_px"] == 0
        other = {"left": "right", "right": "left"}[side]
        fail(tmp_path, *evaluate, *words, f"--visible-{other}", mask, says=[f"needs --truth-{other}"])
        wide = write_image(tmp_path / "w.pgm", WIDTH + 1)
        fail(tmp_path, *evaluate, *words, f"--visible-{side}", wide, says=[f"--visible-{side}", "33x12", "32x12"])


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


def shifted_pair(tmp_path, shift=3, width=WIDTH, height=HEIGHT):
    """Images shifted by `shift`, and the truth of both."""
    ground = [random.Random(y).randbytes(width + shift) for y in range(height)]
    size = {"width": width, "height": height}
    left = gray_image(tmp_path / "ls.pgm", lambda x, y: ground[y][x], **size)
    right = gray_image(tmp_path / "rs.pgm", lambda x, y: ground[y][x + shift], **size)
    truth = pfm(tmp_path / "shift.pfm", lambda x, y: shift, **size)
    images = ["--left", left, "--right", right, "--truth-left", truth, "--truth-right", truth]
    return ["evaluate", *images, "--json", tmp_path / "e.json"]


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


def test_truth_that_cannot_fit_is_remarked(tmp_path, evaluate):
    far = pfm(tmp_path / "far.pfm", lambda x, y: 90.5)
    out, [method] = results(tmp_path, *evaluate, "--truth-right", far, "--config", "tiny")
    assert method["remarks"] == [
        "tiny searches disparities of 0 ... 7 px, but 100 % of the ground truth, 90.5 ... 90.5 px, lies outside; "
        "check the scale of the truth"
    ]
    assert method["remarks"][0] in out
    near = pfm(tmp_path / "near.pfm", lambda x, y: 7)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 3)
    words = ["--truth-left", near, "--reference", "left", "--disparity"]
    _, [method] = results(tmp_path, *evaluate, *words, found)
    assert method["remarks"] == [
        f"100 % of the disparities that {found} found are off by more than 1 px; "
        "check that the truth and its scale belong to these images"
    ]
    _, [method] = results(tmp_path, *evaluate, *words, near)
    assert method["remarks"] == []


def test_the_table_comes_without_json(tmp_path, pair):
    arguments = shifted_pair(tmp_path)[:-2]
    before = sorted(tmp_path.rglob("*"))
    out = succeed(*arguments, "--border", 0, "--config", "tiny")
    assert "non_occluded" in out and "bad 0.5" in out and sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["--config", "tiny"], ["--truth-left"]),
        (["--truth-left", "T"], ["--config", "--opencv"]),
        (["--truth-left", "T", "--config", "nope"], ["nope", "tiny"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "window=3"], ["--set window=3", "known are", "window_px"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "window_px"], ["--set window_px", "NAME=VALUE"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "median=yes"], ["--set median=yes", "false or true"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "disparities=40"], ["--config tiny", "32x12", "40"]),
        (["--truth-left", "T", "--opencv", "bm", "--set", "window_px=3"], ["--set", "--config"]),
        (["--truth-left", "T", "--opencv", "gc"], ["--opencv", "gc"]),
        (["--truth-left", "T", "--opencv", "bm", "--opencv-disparities", "17"], ["17", "multiple of 16"]),
        (["--truth-left", "T", "--opencv", "bm", "--opencv-block", "13"], ["13", "32x12", "5 to 11"]),
        (["--truth-left", "T", "--opencv", "sgbm", "--opencv-block", "4"], ["--opencv-block 4", "odd"]),
        (["--truth-left", "T", "--disparity", "T"], ["--disparity", "--reference"]),
        (["--truth-left", "T", "--disparity", "T", "--reference", "both"], ["--reference", "both"]),
        (["--truth-left", "T", "--truth-scale", "0", "--config", "tiny"], ["--truth-scale"]),
        (["--truth-left", "T", "--truth-scale", "nan", "--config", "tiny"], ["--truth-scale", "not a number above 0"]),
        (["--truth-left", "GREY", "--truth-scale", "1e-300", "--config", "tiny"], ["--truth-left", "so small a scale"]),
        (["--truth-left", "T", "--border", "-1", "--config", "tiny"], ["--border"]),
        (["--truth-left", "no.pfm", "--config", "tiny"], ["no.pfm", "no such file"]),
        (["--truth-left", "WIDE", "--config", "tiny"], ["--truth-left", "33x12", "32x12"]),
        (["--truth-left", "T", "--disparity", "WIDE", "--reference", "left"], ["--disparity", "33x12"]),
        (["--truth-left", "COLOUR", "--config", "tiny"], ["--truth-left", "colour"]),
    ],
)
def test_wrong_usage(tmp_path, evaluate, arguments, says):
    files = {
        "T": pfm(tmp_path / "t.pfm", lambda x, y: 3),
        "WIDE": pfm(tmp_path / "w.pfm", lambda x, y: 3, width=WIDTH + 1),
        "GREY": write_image(tmp_path / "g.pgm"),
        "COLOUR": write_image(tmp_path / "c.ppm", channels=3),
    }
    fail(tmp_path, *evaluate, *[files.get(word, word) for word in arguments], says=says)


@pytest.mark.parametrize(
    "content, says",
    [
        (b"", "truncated"),
        (b"Pf\n32 12\n-1\n", "0 bytes of pixels"),
        (b"Pf\n60000 60000\n-1\nxxxx", "14400000000"),
        (b"Pf\n0 12\n-1\n", "width of 0"),
        (b"PF\n32 12\n-1\n", "colour"),
        (b"Pf\n32 12\n-1\n" + struct.pack("<f", float("nan")) * 384, "none of its pixels has a true disparity"),
        (b"Pf\n32 12\n-1\n" + struct.pack("<f", 1e30) * 384, "is not a disparity"),
    ],
)
def test_hostile_pfm(tmp_path, evaluate, content, says):
    (tmp_path / "h.pfm").write_bytes(content)
    fail(
        tmp_path,
        *evaluate,
        "--truth-left",
        tmp_path / "h.pfm",
        "--config",
        "tiny",
        says=["--truth-left", "h.pfm", says],
    )


@pytest.mark.parametrize("content", [b"P5\n60000 60000\n255\n", b"P5\n-3 4\n255\n", b"\x89PNG\r\n\x1a\n", b"GIF89a"])
def test_hostile_images(tmp_path, evaluate, content):
    (tmp_path / "h.png").write_bytes(content)
    fail(
        tmp_path,
        *evaluate,
        "--truth-left",
        tmp_path / "h.png",
        "--config",
        "tiny",
        says=["--truth-left", "h.png", "not an image"],
    )


def test_json_that_cannot_be_written(tmp_path, evaluate):
    truth = pfm(tmp_path / "t.pfm", lambda x, y: 3)
    (tmp_path / "file").write_text("")
    arguments = [*evaluate[:-2], "--truth-right", truth, "--config", "tiny", "--json"]
    fail(tmp_path, *arguments, tmp_path / "file" / "e.json", says=["--json", "file"])
    (tmp_path / "folder").mkdir()
    fail(tmp_path, *arguments, tmp_path / "folder", says=["folder", "--json"])
