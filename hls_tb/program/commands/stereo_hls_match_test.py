# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls match: disparity maps, their facts, and input that it refuses."""

import json
import os
import random
import struct
from pathlib import Path

import pytest

from cover import fast, with_slow
from stereo_hls_program import (
    DISPARITIES,
    HEIGHT,
    PROGRAM,
    WIDTH,
    changed,
    fail,
    gray_as_colour,
    gray_image,
    png,
    png_depth,
    png_size,
    succeed,
    write_image,
)


@pytest.mark.parametrize("config", ["tiny", "tiny_p2", "tiny_p4"])
def test_match_engines_agree(tmp_path, match, config):
    match = changed(match, "--config", config)
    fast = succeed(*match, "--engine", "fast")
    clocked = succeed(*changed(match, "--out", tmp_path / "clocked"), "--engine", "clocked")
    assert "32x12" in fast and "fast model" in fast and " ms" in fast
    assert "clocked core" in clocked
    for name in ("disparity.png", "disparity_color.png"):
        assert png_size(tmp_path / "out" / name) == (WIDTH - DISPARITIES, HEIGHT)
    pictures = ["disparity.png", "disparity_color.png", "overview.png"]
    for name in pictures:
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "clocked" / name).read_bytes()
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted([*pictures, "match.json"])


def match_facts(tmp_path):
    return json.loads((tmp_path / "out" / "match.json").read_text())


def test_match_writes_its_facts(tmp_path, match, pair):
    succeed(*match)
    facts = match_facts(tmp_path)
    assert facts.pop("milliseconds") >= 0
    assert facts.pop("threads") == len(os.sched_getaffinity(0))
    assert facts == {
        "format": "stereo-hls match 1",
        "config": "tiny",
        "engine": "fast",
        "left": str(pair[1]),
        "right": str(pair[3]),
        "fit": "none",
        "width_px": WIDTH,
        "height_px": HEIGHT,
        "disparities": DISPARITIES,
        "window_px": 3,
        "min_disparity": 0,
        "pixel_bits": 8,
        "reference": "right",
        "cost": "sad",
        "census_width_px": 5,
        "census_height_px": 5,
        "census_pattern": "all",
        "prefilter": "none",
        "prefilter_cap": 31,
        "ties": "smallest",
        "left_right_threshold": -1,
        "uniqueness_percent": 0,
        "texture_threshold": 0,
        "subpixel": False,
        "median": False,
        "full_width": False,
        "support_threshold": 0,
        "confidence": False,
        "margin_shift": 0,
        "margin_weight": 2,
        "support_weight": 4,
        "fill_holes": False,
        "first_disparity": 0,
        "last_disparity": -1,
        "output_width_px": WIDTH - DISPARITIES,
        "output_height_px": HEIGHT,
        "output_first_column": 0,
        "disparity_steps_per_px": 1,
        "density": 1,
        "postprocessing": {"speckle_window_px": 0, "speckle_range_px": 1, "least_confidence": 0},
    }


def test_match_gives_the_same_with_any_number_of_threads(tmp_path, match):
    maps = []
    for threads in (1, 2, 7):
        text = succeed(*changed(match, "--out", tmp_path / "out"), "--threads", threads)
        assert f"threads: {threads}," in text
        assert match_facts(tmp_path)["threads"] == threads
        maps.append((tmp_path / "out" / "disparity.png").read_bytes())
    assert maps[0] == maps[1] == maps[2]


def test_match_takes_the_cores_that_it_may_use(tmp_path, match):
    allowed = os.sched_getaffinity(0)
    try:
        os.sched_setaffinity(0, {min(allowed)})  # the program inherits it
        succeed(*match)
    finally:
        os.sched_setaffinity(0, allowed)
    assert match_facts(tmp_path)["threads"] == 1


@pytest.mark.parametrize("threads", ["0", "-1", "1025", "two", ""])
def test_threads_are_a_small_number(tmp_path, match, threads):
    fail(tmp_path, *match, "--threads", threads, says=["--threads"])


def configurations():
    """The families of the tests and of the demo, and OpenCV's: the others are large, or only measure what an option
    costs. The fast set takes as few as have every option; mark.slow takes all the rest."""
    table = json.loads(succeed("configurations", "--json")) if PROGRAM else {}
    names = sorted(name for name in table if name.startswith(("tiny", "ambrosch2007", "opencv")))
    return with_slow(names, fast() & {*names})


# Options that reject pixels when they are above 0; of the families, each has some.
CHECKS = (
    "support_threshold",
    "uniqueness_percent",
    "uniqueness_distance",
    "texture_threshold",
    "least_difference",
    "mark_occluded",
)


@pytest.mark.parametrize("config", configurations())
def test_every_configuration_on_its_scene(tmp_path, config):
    """Both engines write the same; the files, their depth and the truth are those of the configuration's options."""
    scene = tmp_path / "s"
    succeed("scene", "--out", scene, "--seed", 1, "--config", config)
    match = ["match", "--config", config, "--left", scene / "left.png", "--right", scene / "right.png"]
    succeed(*match, "--out", tmp_path / "first")
    side = json.loads((tmp_path / "first" / "match.json").read_text())["reference"]
    truth = ["--truth", scene / f"disparity_{side}.png", "--visible", scene / f"visible_{side}.png"]
    facts = {}
    for engine in ("fast", "clocked"):
        succeed(*match, *truth, "--engine", engine, "--out", tmp_path / engine)
        facts[engine] = json.loads((tmp_path / engine / "match.json").read_text())
    pictures = sorted(p.name for p in (tmp_path / "fast").iterdir() if p.suffix == ".png")
    for name in pictures:
        assert (tmp_path / "fast" / name).read_bytes() == (tmp_path / "clocked" / name).read_bytes(), name
    for different in ("engine", "milliseconds"):
        assert facts["fast"].pop(different) != facts["clocked"].pop(different)
    assert facts["clocked"].pop("threads") == 1 and facts["fast"].pop("threads") >= 1
    assert facts["fast"] == facts["clocked"]

    found = facts["fast"]
    checks = any(found.get(name, -1) >= 0 for name in ("left_right_threshold", "border_cost"))
    checks = checks or any(found.get(name, 0) > 0 for name in CHECKS)
    assert ("valid.png" in pictures) == checks
    assert checks or found["density"] == 1
    assert png_depth(tmp_path / "fast" / "disparity.png") == (16 if found.get("subpixel") else 8)
    assert found["disparity_steps_per_px"] == (16 if found.get("subpixel") else 1)
    assert 0 < found["density"] <= 1
    score = found["truth"]
    assert 0 < score["compared_px"] + score["invalid_px"] <= found["output_width_px"] * found["output_height_px"]
    # Scenes have disparities from 0 on, and hardly a window in the narrowest maps.
    # A family without windows does not match at all.
    if found.get("min_disparity") == 0 and found["output_width_px"] >= 20 and found.get("window_px", 0) >= 3:
        # In an image of some ten pixels, smoothing carries what is wrong far, the filters of a phase reach over a third
        # of it, and a trellis sees nothing but one row.
        reaches_far = "p1" in found or "phase_scales" in found
        most_bad = 0.7 if "drop_cost" in found else 0.4 if reaches_far else 0.3
        assert score["bad_px"] < most_bad * score["compared_px"]


def test_overview_enlarges_small_images_only(tmp_path, match):
    succeed(*match)
    width, height = png_size(tmp_path / "out" / "overview.png")
    assert width > 3 * 7 * WIDTH and 7 * HEIGHT < height < 9 * HEIGHT + 40, "tiny is enlarged seven times"
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 300, 200))
    succeed(*match)
    width, height = png_size(tmp_path / "out" / "overview.png")
    assert 3 * 300 < width < 4 * 300 and 200 < height < 250


@pytest.mark.parametrize("width, height", [(DISPARITIES + 1, 1), (DISPARITIES + 1, 700), (1500, 1)])
def test_overview_of_odd_sizes(tmp_path, match, width, height):
    for option, name in (("--left", "odd_l.pgm"), ("--right", "odd_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, width, height))
    succeed(*match)
    size = png_size(tmp_path / "out" / "overview.png")
    assert size[0] > 3 * width and size[1] > height


def test_match_counts_bad_pixels(tmp_path, match):
    """A pair shifted by 3 has disparity 3 everywhere but where the shift leaves the image."""
    ground = [[random.Random(x * 100 + y).randrange(256) for x in range(WIDTH + 3)] for y in range(HEIGHT)]
    match = changed(match, "--left", gray_image(tmp_path / "l.pgm", lambda x, y: ground[y][x]))
    match = changed(match, "--right", gray_image(tmp_path / "r.pgm", lambda x, y: ground[y][x + 3]))
    # Row 2: off by one, which is allowed; row 3: off by two; row 4: off, but not visible.
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 3 + {2: 1, 3: 2, 4: 2}.get(y, 0))
    visible = gray_image(tmp_path / "v.pgm", lambda x, y: 0 if y == 4 else 255)
    out = succeed(*match, "--truth", truth, "--visible", visible)
    columns = WIDTH - DISPARITIES
    assert f"bad pixels (> 1 px): {columns} of {columns * (HEIGHT - 1)} visible ones (9.09 %)" in out
    assert match_facts(tmp_path)["truth"] == {
        "disparity": str(truth),
        "scale": 1,
        "visible": str(visible),
        "tolerance_px": 1,
        "compared_px": columns * (HEIGHT - 1),
        "bad_px": columns,
        "invalid_px": 0,
    }


@pytest.mark.parametrize("kind", ["scaled", "colour", "pfm"])
def test_truth_needs_no_visible_pixels(tmp_path, match, kind):
    """As for evaluate: any kind of file, and what is not known does not count."""
    ground = [[random.Random(x * 100 + y).randrange(256) for x in range(WIDTH + 3)] for y in range(HEIGHT)]
    match = changed(match, "--left", gray_image(tmp_path / "l.pgm", lambda x, y: ground[y][x]))
    match = changed(match, "--right", gray_image(tmp_path / "r.pgm", lambda x, y: ground[y][x + 3]))
    value = lambda x, y: 0 if y == 4 else 5 if y == 3 else 3  # noqa: E731, 0: unknown
    truth = tmp_path / f"truth.{kind}"
    if kind == "scaled":
        gray_image(truth, lambda x, y: 16 * value(x, y))
    elif kind == "colour":
        gray_as_colour(truth, lambda x, y: 16 * value(x, y))
    else:
        rows = [struct.pack(f"<{WIDTH}f", *(value(x, y) or float("inf") for x in range(WIDTH))) for y in range(HEIGHT)]
        truth.write_bytes(f"Pf\n{WIDTH} {HEIGHT}\n-1\n".encode() + b"".join(reversed(rows)))
    scale = [] if kind == "pfm" else ["--truth-scale", 16]
    out = succeed(*match, "--truth", truth, *scale)
    columns = WIDTH - DISPARITIES
    assert f"{columns} of {columns * (HEIGHT - 1)} with a true disparity (9.09 %)" in out
    facts = match_facts(tmp_path)["truth"]
    assert facts["visible"] is None and facts["scale"] == (1 if kind == "pfm" else 16)
    assert (facts["compared_px"], facts["bad_px"]) == (columns * (HEIGHT - 1), columns)


def test_truth_of_a_wrong_scale_is_remarked(tmp_path, match):
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 40)
    assert "searches disparities of 0 ... 7 px, but 100 %" in succeed(*match, "--truth", truth)
    assert "lies outside" not in succeed(*match, "--truth", truth, "--truth-scale", 10)


def test_set_changes_options_of_the_fast_model(tmp_path, match):
    out = succeed(*match, "--set", "window_px=5", "--set", "left_right_threshold=1")
    assert "window 5x5" in out and match_facts(tmp_path)["window_px"] == 5
    assert (tmp_path / "out" / "valid.png").exists()
    match = changed(match, "--out", tmp_path / "other")
    fail(tmp_path, *match, "--set", "window=5", says=["--set window=5", "window_px"])
    fail(tmp_path, *match, "--set", "disparities=40", says=["32x12", "wider than the disparity range 40"])
    fail(tmp_path, *match, "--engine", "clocked", "--set", "window_px=5", says=["--set window_px=5", "built in"])


def test_speckles_and_confidence(tmp_path, match):
    def files():
        return {p.name for p in (tmp_path / "out").iterdir()}

    succeed(*match)
    without, map_before = files(), (tmp_path / "out" / "disparity.png").read_bytes()
    out = succeed(*match, "--speckle-window", 400)
    assert "valid pixels: 0.00 %" in out, "no set has 400 of the map's 288 pixels"
    assert files() == without | {"valid.png"}
    assert (tmp_path / "out" / "disparity.png").read_bytes() == map_before, "only the validity changes"
    assert "valid pixels: 100.00 %" in succeed(*match, "--speckle-window", 1, "--speckle-range", 256)
    succeed(*match, "--confidence")
    assert files() == without | {"confidence.png"}
    assert png_size(tmp_path / "out" / "confidence.png") == (WIDTH - DISPARITIES, HEIGHT)
    succeed(*match, "--least-confidence", 128, "--speckle-window", 3, "--speckle-range", 2)
    assert files() == without | {"valid.png"}
    facts = match_facts(tmp_path)
    assert facts["postprocessing"] == {"speckle_window_px": 3, "speckle_range_px": 2, "least_confidence": 128}
    assert facts["density"] < 1, "random images"


def test_both_engines_give_one_confidence(tmp_path, match):
    words = ["--confidence", "--least-confidence", 1]
    succeed(*match, *words)
    succeed(*changed(match, "--out", tmp_path / "clocked"), *words, "--engine", "clocked")
    for name in ("confidence.png", "valid.png", "disparity.png"):
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "clocked" / name).read_bytes()


@pytest.mark.parametrize(
    "words",
    [
        ["--speckle-window", -1],
        ["--speckle-range", 1],
        ["--speckle-window", 9, "--speckle-range", 257],
        ["--least-confidence", 256],
        ["--least-confidence", "half"],
    ],
)
def test_postprocessing_out_of_range(tmp_path, match, words):
    fail(tmp_path, *match, *words, says=[words[-2] if len(words) > 2 else words[0]])


def test_match_on_the_generated_scene_is_mostly_right(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    for option, name in (("--left", "left.png"), ("--right", "right.png")):
        match = changed(match, option, tmp_path / "s" / name)
    succeed(
        *match, "--truth", tmp_path / "s" / "disparity_right.png", "--visible", tmp_path / "s" / "visible_right.png"
    )
    truth = match_facts(tmp_path)["truth"]
    assert 0 < truth["compared_px"] <= (WIDTH - DISPARITIES) * HEIGHT and truth["bad_px"] < 0.1 * truth["compared_px"]


def test_truth_that_does_not_fit(tmp_path, match):
    image = write_image(tmp_path / "t.pgm")
    other = write_image(tmp_path / "other.pgm", WIDTH - 1, HEIGHT)
    fail(tmp_path, *match, "--truth", other, says=["--truth", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth-scale", 2, says=["--truth"])
    fail(tmp_path, *match, "--truth", image, "--truth-scale", 0, says=["--truth-scale"])
    fail(tmp_path, *match, "--visible", image, says=["--truth"])
    fail(tmp_path, *match, "--truth", other, "--visible", image, says=["--truth", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", image, "--visible", other, says=["--visible", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", tmp_path / "no.png", "--visible", image, says=["no.png", "no such file"])


def test_match_fast_takes_any_size_and_says_so(tmp_path, match):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    assert "50x20, not the 32x12 of tiny" in succeed(*match)
    assert png_size(tmp_path / "out" / "disparity.png") == (50 - DISPARITIES, 20)


@pytest.mark.parametrize("fit, verb", [("crop", "cropped"), ("resize", "resized")])
def test_match_fits_images_and_says_so(tmp_path, match, fit, verb):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    out = succeed(*match, "--engine", "clocked", "--fit", fit)
    assert f"images {verb} from 50x20 to" in out
    assert png_size(tmp_path / "out" / "disparity.png") == (WIDTH - DISPARITIES, HEIGHT)
    fail(tmp_path, *match, "--engine", "clocked", says=["50x20", "32x12", "--fit crop"])


def test_colour_is_converted_and_said(tmp_path, match):
    color = write_image(tmp_path / "color.ppm", channels=3)
    assert f"{color}: colour image converted to grey" in succeed(*changed(match, "--left", color))


@pytest.mark.parametrize("channels, is_said", [(1, False), (2, True), (3, False), (4, True)])
def test_transparency_is_left_out_and_said(tmp_path, match, channels, is_said):
    """Of grey images too, whose second channel the reader drops."""
    values = random.Random(channels).randbytes(WIDTH * HEIGHT * channels)
    path = png(tmp_path / "t.png", channels, values)
    said = succeed(*changed(match, "--left", path))
    assert (f"{path}: its transparency is left out\n" in said) == is_said
    if channels == 2:
        succeed(*changed(changed(match, "--left", png(tmp_path / "g.png", 1, values[::2])), "--out", tmp_path / "grey"))
        assert (tmp_path / "out" / "disparity.png").read_bytes() == (tmp_path / "grey" / "disparity.png").read_bytes()


def test_missing_and_unreadable_files(tmp_path, match):
    fail(tmp_path, *changed(match, "--left", tmp_path / "none.png"), says=[tmp_path / "none.png", "no such file"])
    text = tmp_path / "text.png"
    text.write_text("not an image")
    fail(tmp_path, *changed(match, "--right", text), says=[text, "not an image"])
    fail(tmp_path, *changed(match, "--right", tmp_path), says=[tmp_path, "is a folder"])


def test_damaged_png(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    damaged = tmp_path / "damaged.png"
    damaged.write_bytes((tmp_path / "s" / "left.png").read_bytes()[:120])
    fail(tmp_path, *changed(match, "--left", damaged), says=[damaged, "not an image"])


def test_sizes_that_differ(tmp_path, match):
    other = write_image(tmp_path / "other.pgm", WIDTH, HEIGHT + 1)
    fail(tmp_path, *changed(match, "--right", other), says=["differ in size", other, "32x13", "32x12"])


def test_sixteen_bit_images(tmp_path, match):
    deep = write_image(tmp_path / "deep.pgm", maximum=65535)
    fail(tmp_path, *changed(match, "--left", deep), says=[deep, "16 bits", "8-bit"])
    pam = tmp_path / "two_channels.pam"
    pam.write_bytes(b"P7\nWIDTH 2\nHEIGHT 1\nDEPTH 2\nMAXVAL 255\nTUPLTYPE GRAYSCALE_ALPHA\nENDHDR\n\1\2\3\4")
    fail(tmp_path, *changed(match, "--left", pam), says=[pam, "2 channels", "grey"])


def test_width_not_above_the_disparity_range(tmp_path, match):
    for option, name in (("--left", "l8.pgm"), ("--right", "r8.pgm")):
        match = changed(match, option, write_image(tmp_path / name, DISPARITIES, HEIGHT))
    fail(tmp_path, *match, says=["--config tiny: the images are 8x12", "wider than the disparity range 8"])


def test_options_are_checked_before_the_images(tmp_path, match):
    """The sentence begins with the --set that it is about."""
    for settings, words in (
        (["last_disparity=3"], "first_disparity and last_disparity need a map of full width"),
        (["min_disparity=-2147483648"], "the smallest disparity is -2147483648 but must be"),
        (["window_px=5", "window_px=7"], "window_px is set twice"),
        (["uniqueness_percent=200"], "the uniqueness in percent is 200 but must be 0 ... 100"),
    ):
        options = [word for setting in settings for word in ("--set", setting)]
        fail(tmp_path, *match, *options, says=[f"stereo_hls: --set {settings[-1]}: {words}"])
    fail(
        tmp_path,
        *match,
        *("--set", "full_width=true", "--set", "window_px=33"),
        says=["wider than the window for a map of full width"],
    )


JPEG = Path(__file__).parents[2] / "fuzz" / "corpus" / "image" / "gray.jpg"


@pytest.mark.parametrize("command", ["match", "evaluate", "depth", "rectify", "video"])
def test_a_jpeg_that_is_broken_off(tmp_path, command):
    """OpenCV reads it, and grey stands for what is missing."""
    whole, cut = tmp_path / "a" / "0.jpg", tmp_path / "b" / "0.jpg"
    for path, count in ((whole, None), (cut, -40)):
        path.parent.mkdir()
        path.write_bytes(JPEG.read_bytes()[:count])
    (tmp_path / "c.yml").write_text(
        "%YAML:1.0\n---\n"
        + "".join(
            f"{name}: !!opencv-matrix\n   rows: {len(data) // columns}\n   cols: {columns}\n   dt: d\n   data: {data}\n"
            for name, data, columns in (
                *((name, [50.0, 0.0, 18.0, 0.0, 50.0, 6.0, 0.0, 0.0, 1.0], 3) for name in ("M1", "M2")),
                ("R", [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], 3),
                ("T", [-0.1, 0.0, 0.0], 1),
            )
        )
    )
    more = {
        "match": ["--config", "tiny", "--out", tmp_path / "out"],
        "evaluate": ["--config", "tiny", "--truth-left", whole],
        "depth": ["--config", "tiny", "--calibration", tmp_path / "c.yml", "--out", tmp_path / "out"],
        "rectify": ["--calibration", tmp_path / "c.yml", "--out", tmp_path / "out"],
        "video": ["--config", "tiny", "--out", tmp_path / "out"],
    }[command]
    of = (lambda path: path.parent) if command == "video" else lambda path: path
    succeed(command, "--left", of(whole), "--right", of(whole), *more)
    for left, right in ((whole, cut), (cut, whole)):
        says = ["0.jpg: is truncated or damaged", "Premature end of JPEG file"]
        fail(tmp_path, command, "--left", of(left), "--right", of(right), *more, says=says)


def test_crop_of_images_too_small(tmp_path, match):
    for option, name in (("--left", "ls.pgm"), ("--right", "rs.pgm")):
        match = changed(match, option, write_image(tmp_path / name, WIDTH + 9, HEIGHT - 1))
    fail(tmp_path, *match, "--fit", "crop", says=["--fit crop", "41x11", "32x12"])
