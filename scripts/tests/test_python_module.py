# SPDX-License-Identifier: Apache-2.0
"""The Python module stereo_hls: it says what the program says."""

import importlib
import json
import os
import random
import sys
import threading
import time
import tomllib

import numpy as np
import pytest

from conftest import SEED, where_reachable
from flow.base import python_module
from flow.base.tools import ROOT, find_stereo_hls, run

WIDTH, HEIGHT, RANGE = 96, 60, 20


@pytest.fixture(scope="module")
def module():
    programs = where_reachable(python_module.install)
    sys.path.append(str(python_module.site_packages(programs)))
    return importlib.import_module("stereo_hls")


@pytest.fixture(scope="module")
def pair(module):
    return module.scene(WIDTH, HEIGHT, RANGE, seed=3)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The same scene as files: {option of `evaluate`: path}."""
    folder = tmp_path_factory.mktemp("scene")
    sizes = ["--width", WIDTH, "--height", HEIGHT, "--disparities", RANGE, "--seed", 3]
    run([find_stereo_hls(), "scene", *sizes, "--out", folder])
    names = {"left": "left", "right": "right", "truth-left": "disparity_left", "truth-right": "disparity_right"}
    return [word for option, name in names.items() for word in (f"--{option}", folder / f"{name}.png")]


def test_it_is_built_with_the_pinned_packages():
    with (ROOT / "pyproject.toml").open("rb") as file:
        wanted = tomllib.load(file)["build-system"]["requires"]
    assert set(wanted) <= set(python_module.REQUIREMENTS.read_text().splitlines())


def test_version(module):
    assert f"VERSION {module.__version__} " in (ROOT / "CMakeLists.txt").read_text()


def test_configurations_are_those_of_the_program(module):
    assert module.configurations() == json.loads(run([find_stereo_hls(), "configurations", "--json"]))


def test_families_have_the_options_of_their_configurations(module):
    families = module.families()
    for name, row in module.configurations().items():
        for option, about in families[row["family"]].items():
            value = row[option]
            if "words" in about:
                assert (json.dumps(value) if isinstance(value, bool) else value) in about["words"], (name, option)
            else:
                assert type(value) is int and type(about["default"]) is int and about["meaning"]
    assert families["semi_global"]["p2"] == {"default": 22, "low": 0, "high": 4095, "meaning": "the penalty P2"}
    assert families["block_matching"]["window_px"]["high"] is None
    assert families["block_matching"]["cost"] == {"default": "sad", "words": ["sad", "ssd", "census"]}


@pytest.mark.parametrize(
    "configuration,options",
    [
        ("tiny", {}),
        ("opencv_bm", {"disparities": 16, "median": True}),
        ("census_450", {"disparities": RANGE, "cost": "census", "window_px": 4, "reference": "left"}),
        ("tiny_sgm", {"disparities": RANGE, "p2": 40, "left_right_threshold": 1, "subpixel": True}),
        ("tiny_sgm", {"min_disparity": -3, "path_above": False}),
        ("tiny_trellis", {"drop_cost": 6}),
        ("example", {}),
    ],
)
def test_match_and_evaluate_are_those_of_the_program(module, pair, files, tmp_path, configuration, options):
    settings = [
        word
        for name, value in options.items()
        for word in ("--set", f"{name}={str(value).lower() if isinstance(value, bool) else value}")
    ]
    program = [find_stereo_hls(), "evaluate", *files, "--config", configuration, *settings, "--border", 5]
    run([*program, "--json", tmp_path / "evaluation.json"])
    method = json.loads((tmp_path / "evaluation.json").read_text())["methods"][0]
    found = module.match(pair.left, pair.right, configuration, **options)
    assert found.options == method["parameters"] and found.reference == method["reference"]
    image, truth, other = pair.left, pair.truth_left, pair.truth_right
    if found.reference == "right":
        image, truth, other = pair.right, pair.truth_right, pair.truth_left
    measures = module.evaluate(found, truth, other, image, border_px=5)
    assert measures == method["masks"] and len(measures) >= 4
    # The same from an array.
    again = module.evaluate(
        found.disparity, truth, other, image, reference=found.reference, search=found.search, border_px=5
    )
    assert again == measures


def test_masked_pixels_do_not_count(module):
    """As those that are not finite, in each array."""
    rng = np.random.default_rng(SEED)
    truth = rng.integers(0, RANGE, (HEIGHT, WIDTH)).astype(np.float64)
    found = truth + rng.integers(0, 3, truth.shape)
    hidden = {name: rng.random(truth.shape) < 0.3 for name in ("disparity", "truth", "other_truth")}
    arrays = {"disparity": found, "truth": truth, "other_truth": truth}
    masked = {name: np.ma.masked_array(array, hidden[name]) for name, array in arrays.items()}
    marked = {name: np.where(hidden[name], np.nan, array) for name, array in arrays.items()}
    say = {"reference": "left", "border_px": 0}
    wanted = module.evaluate(**marked, **say)
    assert module.evaluate(**masked, **say) == wanted != module.evaluate(**arrays, **say)
    assert wanted["all"]["pixels"] == (~hidden["truth"]).sum()
    for name, array in masked.items():
        alone = module.evaluate(**{**arrays, name: array}, **say)
        assert alone == module.evaluate(**{**arrays, name: marked[name]}, **say), name
    unmasked = {name: np.ma.masked_array(array) for name, array in arrays.items()}
    assert module.evaluate(**unmasked, **say) == module.evaluate(**arrays, **say)
    single = np.ma.masked_array(truth.astype(np.float32), hidden["truth"])
    assert module.evaluate(found, single, **say)["all"]["pixels"] == wanted["all"]["pixels"]


@pytest.mark.parametrize("value", [-1, 0, 1000.5])
def test_a_value_of_the_truth_can_stand_for_unknown(module, value):
    random = np.random.default_rng(SEED)
    truths = [random.integers(1, 10, (HEIGHT, WIDTH)).astype(np.float32) for _ in range(2)]
    found = truths[0] + random.normal(0, 1, truths[0].shape).astype(np.float32)
    hidden = [random.random(truth.shape) < 0.3 for truth in truths]
    say = {"reference": "left", "border_px": 0}
    nan, marked = ([np.where(h, v, t) for t, h in zip(truths, hidden)] for v in (np.float32(np.nan), np.float32(value)))
    wanted = module.evaluate(found, *nan, **say)
    assert module.evaluate(found, *marked, unknown=value, **say) == wanted != module.evaluate(found, *marked, **say)
    assert module.evaluate(found.astype(np.float64), *marked, unknown=value, **say) == wanted


def test_images_have_no_mask(module, pair):
    hidden = np.ma.masked_array(pair.left, pair.left > 100)
    for left, right, name in ((hidden, pair.right, "left"), (pair.left, hidden, "right")):
        with pytest.raises(ValueError, match=f"^{name}: has masked pixels"):
            module.match(left, right, "tiny")
    with pytest.raises(ValueError, match="^image: has masked pixels"):
        module.evaluate(pair.truth_left, pair.truth_left, image=hidden, reference="left")
    whole = module.match(np.ma.masked_array(pair.left), pair.right, "tiny")
    assert np.array_equal(whole.steps, module.match(pair.left, pair.right, "tiny").steps)


def test_a_map_says_itself_what_it_is(module, pair):
    found = module.match(pair.left, pair.right, "tiny", disparities=RANGE)
    truth = pair.truth(found.reference)
    plain = module.evaluate(found, truth)
    said = {"reference": found.reference, "search": list(found.search), "pixel_bits": 8}
    assert module.evaluate(found, truth, **said) == plain
    other = {"left": "right", "right": "left"}[found.reference]
    for name, value in (("reference", other), ("search", (0, RANGE + 1)), ("pixel_bits", 10)):
        with pytest.raises(ValueError, match=f"^{name}=.*: the map's is"):
            module.evaluate(found, truth, **{name: value})


@pytest.mark.parametrize("configuration,options", [("tiny_10bit", {}), ("tiny_sgm", {"pixel_bits": 12})])
def test_pixels_of_more_bits(module, tmp_path, configuration, options):
    """The same scene, maps and measures as the program's. An array of uint8 is taken as it is."""
    bits = options.get("pixel_bits", 10)
    sizes = ["--width", WIDTH, "--height", HEIGHT, "--disparities", RANGE, "--seed", 3, "--pixel-bits", bits]
    run([find_stereo_hls(), "scene", *sizes, "--out", tmp_path])
    names = {"left": "left", "right": "right", "truth-left": "disparity_left", "truth-right": "disparity_right"}
    files = [word for option, name in names.items() for word in (f"--{option}", tmp_path / f"{name}.png")]
    settings = [word for name, value in options.items() for word in ("--set", f"{name}={value}")]
    program = [find_stereo_hls(), "evaluate", *files, "--config", configuration, *settings]
    run([*program, "--json", tmp_path / "evaluation.json"])
    method = json.loads((tmp_path / "evaluation.json").read_text())["methods"][0]
    pair = module.scene(WIDTH, HEIGHT, RANGE, seed=3, pixel_bits=bits)
    assert pair.left.dtype == pair.right.dtype == np.uint16 and 255 < pair.left.max() < 1 << bits
    found = module.match(pair.left, pair.right, configuration, **options)
    image, other = (pair.right, "left") if found.reference == "right" else (pair.left, "right")
    truths = pair.truth(found.reference), pair.truth(other)
    measures = module.evaluate(found, *truths, image)
    assert measures == method["masks"] and "textureless" in measures
    again = module.evaluate(
        found.disparity, *truths, image, reference=found.reference, search=found.search, pixel_bits=bits
    )
    assert again == measures
    narrow = module.scene(WIDTH, HEIGHT, RANGE, seed=3)
    maps = [
        module.match(narrow.left.astype(kind), narrow.right, configuration, **options) for kind in (np.uint16, np.uint8)
    ]
    np.testing.assert_array_equal(maps[0].steps, maps[1].steps)
    wide = pair.left.copy()
    wide[7, 5] = 1 << bits
    says = f"left: has the grey value {1 << bits} at x=5 y=7 but pixels of {bits} bits are at most {(1 << bits) - 1}"
    with pytest.raises(ValueError, match=says):
        module.match(wide, pair.right, configuration, **options)
    with pytest.raises(ValueError, match=says.replace("left", "image")):
        module.evaluate(found, *truths, wide)
    with pytest.raises(ValueError, match="pixel_bits: must be given where image is an array of uint16"):
        module.evaluate(found.disparity, *truths, image, reference=found.reference)
    with pytest.raises(ValueError, match="pixel_bits=11: must be 8, 10 or 12"):
        module.scene(pixel_bits=11)


def test_what_a_map_says_of_itself(module, pair):
    found = module.match(
        pair.left, pair.right, "tiny", disparities=RANGE, subpixel=True, min_disparity=2, uniqueness_percent=20
    )
    assert found.disparity.dtype == np.float32 and found.disparity.shape == (HEIGHT, WIDTH)
    assert found.steps.dtype == np.uint16 and found.valid.dtype == np.bool_
    assert found.steps.shape == found.valid.shape and found.steps_per_px == 16 and found.search == (2, RANGE)
    columns = slice(found.first_column, found.first_column + found.steps.shape[1])
    expected = np.where(found.valid, 2 + found.steps / 16, np.nan)
    np.testing.assert_array_equal(found.disparity[:, columns], expected)
    assert 0 < np.isnan(expected).sum() < expected.size, "or the check has done nothing"
    assert np.isfinite(found.disparity).sum() == found.valid.sum()


def test_arrays_of_any_strides(module, rng):
    wide = np.random.default_rng(rng.randrange(2**32)).integers(0, 256, (2 * HEIGHT, 3 * WIDTH), np.uint8)
    views = [wide[::2, ::3], wide[1::2, 2::3], wide[::-2, ::-3], np.asfortranarray(wide[:HEIGHT, :WIDTH])]
    views += [wide.T[:HEIGHT, :WIDTH], np.broadcast_to(wide[:1, :WIDTH], (HEIGHT, WIDTH)), wide[:HEIGHT, :WIDTH]]
    read_only = wide[:HEIGHT, :WIDTH].copy()
    read_only.flags.writeable = False
    for left in [*views, read_only]:
        right = random.Random(SEED).choice(views)
        expected = module.match(left.copy(order="C"), right.copy(order="C"), "tiny")
        np.testing.assert_array_equal(module.match(left, right, "tiny").steps, expected.steps)
    truth = np.asfortranarray(wide[::2, ::3].astype(np.float64))
    measures = module.evaluate(truth[:, ::-1], truth, reference="left", border_px=0)
    assert measures == module.evaluate(truth[:, ::-1].copy(), truth.copy(), reference="left", border_px=0)


@pytest.mark.parametrize("configuration", ["opencv_bm", "tiny_sgm", "tiny_trellis"])
def test_any_number_of_threads(module, pair, configuration):
    maps = [
        module.match(pair.left, pair.right, configuration, threads=n, disparities=RANGE) for n in (1, 2, 3, 7, None)
    ]
    for found in maps[1:]:
        np.testing.assert_array_equal(found.disparity, maps[0].disparity)


def test_the_clocked_core(module):
    tiny = module.configurations()["tiny"]
    pair = module.scene(tiny["width_px"], tiny["height_px"], tiny["disparities"])
    fast, clocked = (module.match(pair.left, pair.right, "tiny", engine=engine) for engine in ("fast", "clocked"))
    np.testing.assert_array_equal(fast.steps, clocked.steps)
    np.testing.assert_array_equal(fast.disparity, clocked.disparity)


def test_a_core_that_is_not_built(module, pair, tmp_path, monkeypatch):
    with pytest.raises(module.CoreNotBuilt, match="census_450 is not built"):
        module.match(pair.left, pair.right, "census_450", engine="clocked")
    monkeypatch.setenv("STEREO_CORES", str(tmp_path))
    with pytest.raises(module.CoreNotBuilt, match=str(tmp_path)):
        module.trace("tiny")


def test_traces_are_those_of_the_program(module, tmp_path):
    run([find_stereo_hls(), "trace", "--config", "tiny", "--clocks", 90, "--out", tmp_path])
    title, names, *lines = (tmp_path / "trace.txt").read_text().splitlines()
    trace = module.trace("tiny", 90)
    assert list(trace) == names.split()
    expected = [[int(word, 16) for word in line.split()] for line in lines]
    assert [list(map(int, values)) for values in zip(*trace.values())] == expected
    assert {values.dtype for values in trace.values()} <= {np.dtype(np.int64), np.dtype(np.uint64)}
    assert min(min(row) for row in expected) < 0, "or no signed register was compared"


BAD_CALLS = {
    "no configuration": (ValueError, "nope: there is no such configuration; known are: ambrosch2007", ["nope"], {}),
    "no option": (ValueError, "window=3: there is no such option; known are: disparities", [], {"window": 3}),
    "no number": (ValueError, "window_px=x: the value must be a whole number", [], {"window_px": "x"}),
    "no word": (ValueError, "cost=foo: the value must be sad or ssd or census", [], {"cost": "foo"}),
    "beyond a limit": (ValueError, "the window side is 0 but must be at least 1", [], {"window_px": 0}),
    "too wide": (ValueError, "wider than the disparity range 96", [], {"disparities": WIDTH}),
    "no type": (TypeError, "window_px: must be a number, a flag or a word but is 2.5", [], {"window_px": 2.5}),
    "no engine": (ValueError, "engine='vhdl': must be", [], {"engine": "vhdl"}),
    "clocked, another size": (ValueError, "configuration tiny takes", ["tiny"], {"engine": "clocked"}),
    "clocked, options": (ValueError, "options of a clocked core", [], {"engine": "clocked", "window_px": 5}),
    "no threads": (ValueError, "threads=0: must be 1 ... 1024", [], {"threads": 0}),
}


@pytest.mark.parametrize("kind", BAD_CALLS)
def test_bad_calls(module, pair, kind):
    error, sentence, words, options = BAD_CALLS[kind]
    with pytest.raises(error) as raised:
        module.match(pair.left, pair.right, *(words or ["tiny"]), **options)
    assert sentence in str(raised.value) and "\n" not in str(raised.value)


def test_bad_arrays(module, pair):
    for left, error, sentence in [
        (pair.left.astype(np.float32), TypeError, "left: must be an array of uint8 or uint16 but is one of float32"),
        (pair.left.astype(np.int8), TypeError, "int8"),
        (pair.left[0], ValueError, "left: must have two axes"),
        (np.stack([pair.left] * 3, 2), ValueError, f"its shape is ({HEIGHT}, {WIDTH}, 3)"),
        (pair.left[:0], ValueError, "left: has no pixels"),
        (pair.left[1:], ValueError, f"left is {WIDTH}x{HEIGHT - 1}, right is {WIDTH}x{HEIGHT}"),
        (None, TypeError, "left: must be an array of uint8"),
        (pair.left.astype(np.uint16), TypeError, "left, right: must be arrays of uint8 where pixel_bits is 8"),
    ]:
        with pytest.raises(error) as raised:
            module.match(left, pair.right, "tiny")
        assert sentence in str(raised.value)


def test_bad_evaluations_scenes_and_traces(module, pair):
    truth = pair.truth_left
    for call, error, sentence in [
        (lambda: module.evaluate(truth, truth), ValueError, "reference: must be 'left' or 'right'"),
        (lambda: module.evaluate(truth[1:], truth, reference="left"), ValueError, "disparity: is 96x59 but the truth"),
        (
            lambda: module.evaluate(pair.left, truth, reference="left"),
            TypeError,
            "disparity: must be an array of floats",
        ),
        (lambda: module.evaluate(truth, truth, reference="left", border_px=-1), ValueError, "border_px=-1"),
        (lambda: module.scene(10, 10, 20), ValueError, "a scene's width is 10"),
        (lambda: module.scene(seed=2**64), ValueError, f"seed={2**64}: must be 0 ... {2**64 - 1}"),
        (lambda: module.trace("tiny", 9), ValueError, "clocks=9: must be 10 ... 1000000"),
        (lambda: module.trace("nope"), ValueError, "nope: there is no such configuration"),
    ]:
        with pytest.raises(error) as raised:
            call()
        assert sentence in str(raised.value)


def test_masks_follow_from_what_is_given(module, pair):
    truth, other = pair.truth_left.copy(), pair.truth_right
    truth[:, ::2] = np.nan
    truth[:, 1::4] = np.inf
    only = module.evaluate(truth, truth, reference="left", border_px=0)
    assert list(only) == ["all"] and only["all"]["pixels"] == np.isfinite(truth).sum() > 0
    nothing = module.evaluate(np.full_like(truth, np.nan), truth, reference="left", border_px=0)["all"]
    assert nothing["density"] == 0 and nothing["avg_px"] is None and nothing["bad_1"]["invalid_bad"] == 1
    assert "textureless" not in module.evaluate(truth, truth, other, reference="left", border_px=0)
    assert module.evaluate(np.nan * truth, np.nan * truth, reference="left") == {}


def test_other_threads_run_meanwhile(module):
    pair = module.scene(640, 480, 128)
    turns, over = 0, threading.Event()

    def count():
        nonlocal turns
        while not over.is_set():
            turns += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    module.match(pair.left, pair.right, "tiny_sgm", disparities=128, threads=1)  # whatever is made at the first call
    during, started = turns, time.monotonic()
    while time.monotonic() - started < 0.5:
        before = turns
        module.match(pair.left, pair.right, "tiny_sgm", disparities=128, threads=1)
        during = max(during, turns - before)
    over.set()
    other.join()
    assert during > 3, "a match takes tens of milliseconds"


def test_editors_find_types_and_texts(module):
    assert os.path.isfile(os.path.join(os.path.dirname(module.__file__), "py.typed"))
    assert all(getattr(module, name).__doc__ for name in module.__all__ if name != "Option")
