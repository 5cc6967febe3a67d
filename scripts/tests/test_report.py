# SPDX-License-Identifier: Apache-2.0
"""What the page of a demo shows: pictures with the right pixels, and a layout that a reader can use, wide and on a
phone."""

import io
import subprocess

import pytest

from browser import look
from conftest import need
from flow.base.errors import FlowError
from flow.base.tools import find_stereo_hls
from flow.implementation import results
from flow.pages import demo_folder, map_pictures, performance, report
from flow.rendering import page, pictures
from flow_commands import call, scene
from test_demo import COSIM, COSIMS, change

pytest.importorskip("matplotlib", reason="SKIP: python3-matplotlib is not installed")
numpy, Image = pictures.libraries()


def fill(folder, config, truth=True):
    """A demo folder as the demo leaves it, with made-up co-simulations."""
    left, right = scene(folder / "scene", config, seed=3)
    side = "left" if "left" in config else "right"
    images, words = ["--left", left, "--right", right], []
    if truth:
        words += ["--truth", folder / "scene" / f"disparity_{side}.png"]
        words += ["--visible", folder / "scene" / f"visible_{side}.png"]
    subprocess.run(
        [find_stereo_hls(), "match", "--config", config, *images, *words, "--out", folder / "match"],
        check=True,
        capture_output=True,
    )
    whole = {
        "simulator": "verilator",
        "rows": None,
        "frames": 2,
        "clocks_per_frame": 384,
        "expected": 576,
        "compared": 576,
    }
    for name, changes in zip(COSIMS, ({}, whole)):
        (folder / name).mkdir()
        change(folder / name / "report.json", dict(COSIM), config=config, **changes)
    return folder


@pytest.fixture(scope="module", params=["tiny", "tiny_all", "tiny_lr_left", "tiny_subpixel", "tiny_min3"])
def demo(request, tmp_path_factory):
    return demo_folder.read_demo(fill(tmp_path_factory.mktemp(request.param), request.param))


def colors(picture):
    return numpy.asarray(Image.open(io.BytesIO(picture.png)).convert("RGB"))


def count(picture, color):
    return int((colors(picture) == pictures.rgb(color)).all(axis=2).sum())


def test_pictures_are_those_of_the_demo(demo):
    drawn, notes = report.draw(demo)
    titles = [picture.title for picture in drawn]
    assert titles == ["Left image", "Right image", "Disparity", "Error against the ground truth"] + (
        ["Rejections"] if demo.has_checks else []
    )
    assert notes == [], "and the error picture has as many bad pixels as match.json"
    left = numpy.asarray(Image.open(demo.folder / "scene" / "left.png").convert("RGB"))
    assert (colors(drawn[0]) == left).all()
    for picture in drawn:
        assert colors(picture).shape == (demo.match["height_px"], demo.match["width_px"], 3)


def test_disparity_has_the_colours_of_its_scale(demo):
    picture = report.draw(demo)[0][2]
    match, values = demo.match, pictures.load(demo.folder / demo_folder.MAP)
    valid = pictures.load(demo.folder / demo_folder.VALID) != 0 if demo.has_checks else numpy.ones(values.shape, bool)
    x, y = next((x, y) for y in range(values.shape[0]) for x in range(values.shape[1]) if valid[y, x])
    share = values[y, x] / match["disparity_steps_per_px"] / (match["disparities"] - 1)
    bar = numpy.asarray(Image.open(io.BytesIO(pictures.scale_png())))
    shown = colors(picture)[y, match["output_first_column"] + x].astype(int)
    assert abs(shown - bar[0, round(share * 255)].astype(int)).max() <= 6
    low = match["min_disparity"]
    assert picture.scale[0] == f"{low} px" and picture.scale[-1] == f"{low + match['disparities'] - 1} px"
    assert count(picture, pictures.REJECTED) == (~valid).sum()


def test_errors_are_counted_as_the_program_counts_them(demo):
    picture = report.draw(demo)[0][3]
    large = sum(count(picture, color) for _, color in map_pictures.ERRORS[2:])
    assert large == demo.match["truth"]["bad_px"] > 0
    shares = [share for _, _, share in picture.legend if share is not None]
    assert sum(shares) == pytest.approx(100)


def test_rejections_are_counted(demo):
    if not demo.has_checks:
        assert len(report.draw(demo)[0]) == 4
        return
    picture = report.draw(demo)[0][4]
    rejected = int((pictures.load(demo.folder / demo_folder.VALID) == 0).sum())
    assert count(picture, map_pictures.GOOD) + count(picture, map_pictures.TOO_STRICT) == rejected > 0


def test_a_pair_that_is_gone_leaves_notes(demo):
    gone = {**demo.match, "left": "no/left.png", "truth": {**demo.match["truth"], "visible": "no/visible.png"}}
    drawn, notes = report.draw(demo_folder.Demo(demo.folder, gone, demo.cosims, demo.core, demo.has_checks))
    assert "Left image" not in [picture.title for picture in drawn] and "Error against the ground truth" not in [
        picture.title for picture in drawn
    ]
    assert any("no/left.png" in note for note in notes) and any("no/visible.png" in note for note in notes)


def test_truth_of_another_run_is_noticed(demo):
    other = {**demo.match, "truth": {**demo.match["truth"], "bad_px": demo.match["truth"]["bad_px"] + 1}}
    _, notes = report.draw(demo_folder.Demo(demo.folder, other, demo.cosims, demo.core, demo.has_checks))
    assert len(notes) == 1 and "not of one run" in notes[0]


def test_every_row_of_the_comparison_stands_on_the_page(tmp_path):
    text = report.render(demo_folder.read_demo(fill(tmp_path / "demo", "tiny")))
    for other in performance.PUBLISHED:
        assert other.system in text
    for system in performance.SYSTEMS:
        assert system.name in text
    targets = results.Configuration("ambrosch2007", stale_is_none=True).targets
    assert not targets or f"{targets['cyclonev']['aluts']:,}" in text
    own = results.Configuration("tiny", stale_is_none=True).targets
    for name, result in own.items():
        assert f"--target {name}" in text and f">{result['ffs']:,}<" in text
    assert own or "not measured yet" in text


def test_results_of_other_vhdl_are_none(tmp_path, monkeypatch):
    demo = demo_folder.read_demo(fill(tmp_path / "demo", "tiny"))
    monkeypatch.setattr(results.record, "is_fresh", lambda result, entry: False)
    stale = results.Configuration("tiny", stale_is_none=True)
    assert stale.stale and stale.targets == {}
    with pytest.raises(FlowError, match="of other VHDL"):
        results.Configuration("tiny")
    text = report.render(demo_folder.Demo(demo.folder, demo.match, demo.cosims, stale, demo.has_checks))
    assert "is of other VHDL" in text and "MHz after place and route" not in text


def test_without_matplotlib_one_sentence(tmp_path):
    folder = fill(tmp_path / "demo", "tiny")
    (tmp_path / "modules").mkdir()
    (tmp_path / "modules" / "matplotlib.py").write_text("raise ImportError('none', name='matplotlib')")
    process = call("report.py", "--demo", folder, environment={"PYTHONPATH": str(tmp_path / "modules")})
    assert (
        process.returncode == 3
        and "apt-get install python3-matplotlib" in process.stderr
        and process.stderr.count("\n") == 1
    )
    assert not (folder / "report.html").exists()


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """A page with checks, a long path in its commands, and one with a failed co-simulation."""
    need("chromium")
    folder = fill(tmp_path_factory.mktemp("a_folder_with_quite_a_long_name_that_does_not_break"), "tiny_all")
    change(
        folder / COSIMS[0] / "report.json",
        passed=False,
        mismatches=2,
        first_mismatch="clock 9, frame 0, x 3, y 1: expected disparity 2 flags 4, got disparity 1",
    )
    (folder / "report.html").write_text(report.render(demo_folder.read_demo(folder)))
    return folder / "report.html"


@pytest.mark.parametrize("width", [1280, 768, 390])
def test_layout(pages, tmp_path, width):
    seen = look(pages, tmp_path, width)
    assert seen["width"] == width and seen["scroll_width"] == width, "the page itself does not scroll sideways"
    assert seen["too_wide"] == []
    assert seen["text"] > 3000 and seen["smallest_text_px"] >= 11
    assert [image["alt"] for image in seen["images"] if image["natural"] == 0] == [], "every picture is shown"
    maps = [image for image in seen["images"] if not image["alt"].startswith("colour scale")]
    assert len(maps) == 5
    for image in maps:
        assert image["shown"] >= (0.85 * width if width < 520 else 300)


@pytest.mark.parametrize("scheme,paper", [("light", "rgb(255, 255, 255)"), ("dark", "rgb(21, 24, 26)")])
def test_text_can_be_read_in_both_schemes(pages, tmp_path, scheme, paper):
    seen = look(pages, tmp_path, 1280, scheme=scheme)
    assert seen["paper"] == paper
    assert seen["contrast"][0] >= 4.5, f"{seen['contrast'][1]}, WCAG's AA"


def test_the_contrast_check_sees_grey_on_grey(pages, tmp_path):
    broken = tmp_path / "broken.html"
    broken.write_text(pages.read_text().replace("--quiet: #4f565c", "--quiet: #9fa6ac", 1))
    assert look(broken, tmp_path, 1280)["contrast"][0] < 4.5


def test_a_table_that_goes_on_shows_it(pages, tmp_path):
    """With a shadow at its edge, and the keyboard reaches it."""
    seen = look(pages, tmp_path, 390)
    assert len(seen["scrolling"]) >= 2
    assert all(tab == 0 and shadows == 4 for tab, shadows in seen["scrolling"]), seen["scrolling"]


def test_the_layout_check_sees_an_overflow(pages, tmp_path):
    broken = tmp_path / "broken.html"
    broken.write_text(pages.read_text().replace("<h1>", '<div style="width: 1500px">wide</div><h1>', 1))
    seen = look(broken, tmp_path, 390)
    assert seen["scroll_width"] > 390 and seen["too_wide"]


def test_numbers_and_cells():
    assert page.number(None) == "–" and page.number(1234.5, 1) == "1,234.5"
    assert page.cell("this core, `a<b`") == "this core, <code>a&lt;b</code>" and page.cell("-") == "–"
    assert page.is_number("1,234.5") and page.is_number("-") and not page.is_number("1 of 2")
