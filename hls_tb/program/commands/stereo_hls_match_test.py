# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls match: disparity maps, their facts, the options that it takes."""

import json
import os

import pytest

from cover import fast, with_slow
from stereo_hls_program import (
    DISPARITIES,
    HEIGHT,
    PROGRAM,
    WIDTH,
    changed,
    fail,
    match_facts,
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


def test_match_writes_its_facts(tmp_path, match, pair):
    succeed(*match)
    facts = match_facts(tmp_path)
    assert facts.pop("milliseconds") >= 0
    assert facts.pop("threads") == len(os.sched_getaffinity(0))
    assert facts.pop("files") == ["disparity.png", "disparity_color.png", "overview.png"]
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


def test_set_changes_options_of_the_fast_model(tmp_path, match):
    out = succeed(*match, "--set", "window_px=5", "--set", "left_right_threshold=1")
    assert "window 5x5" in out and match_facts(tmp_path)["window_px"] == 5
    assert (tmp_path / "out" / "valid.png").exists()
    match = changed(match, "--out", tmp_path / "other")
    fail(tmp_path, *match, "--set", "window=5", says=["--set window=5", "window_px"])
    fail(tmp_path, *match, "--set", "disparities=40", says=["32x12", "wider than the disparity range 40"])
    fail(tmp_path, *match, "--engine", "clocked", "--set", "window_px=5", says=["--set window_px=5", "built in"])


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
