# SPDX-License-Identifier: Apache-2.0
"""plan.py: what fits, its output; docs/plan.md."""

import dataclasses
import importlib
import json
import math
import re
import sys

import pytest

from flow.base.configurations import configurations
from flow.base.errors import FlowError
from flow.pages import plan as page, plan_picture
from flow.planning import candidates, compared, devices, plan_text, search
from flow.planning.candidates import Camera
from flow.planning.model import Implemented, implemented
from flow.planning.search import Number
from flow_commands import call, refused

VGA = ("--size", "640x480", "--fps", "30", "--disparities", "64")
SMALL = "ecp5_25f_grade6"


def place(target=SMALL, fill=85, margin=20, **changes):
    return search.Place(target, devices.device_of(target)._replace(**changes), fill, margin)


# --- what fits --------------------------------------------------------------------------------------------------------


def test_folded_cores_serve_what_others_do_not(planner):
    """Semi-global matching of 640x480 fits the 25F in several clocks a pixel pair, not in one."""
    plans = planner.plan(Camera(640, 480, 64, 30), place())
    titles = {planned.candidate.algorithm.title: planned for planned in search.best(plans)}
    folded = titles["P2 the same everywhere"]
    assert folded.candidate.options["clocks_per_pixel"] > 1 and folded.candidate.family == "semi_global"
    at_once = [
        p
        for p in plans
        if p.candidate.algorithm == folded.candidate.algorithm and not p.candidate.changes.get("clocks_per_pixel")
    ]
    assert at_once and not any(planned.fits for planned in at_once)


def test_clocks_needed_and_clocks_there(planner):
    for planned in planner.plan(Camera(320, 240, 100, 60), place()):
        if planned.candidate.problem:
            continue
        o, mhz = planned.candidate.options, planned.numbers.mhz
        groups = 320 * 240 // o["pixels_per_clock"] + planned.candidate.shape.gap_groups
        assert planned.needed_mhz == pytest.approx(groups * o["clocks_per_pixel"] * 60 / 1e6)
        enough = mhz.value >= planned.needed_mhz * (1 if mhz.of else 1.2)
        assert enough == (not any("MHz are needed" in reason for reason in planned.reasons))


def test_numbers_of_a_committed_core_are_measured(planner):
    plans = planner.plan(Camera(320, 240, 100, 60), place())
    (one,) = [planned for planned in plans if planned.row == "ambrosch2007_f10"] or [None]
    assert one is None, "the quality row has a left reference"
    right = planner.plan(Camera(320, 240, 100, 60, (), {"reference": "right"}), place())
    found = {planned.row: planned.numbers for planned in right if planned.row}
    record = next(c for c in planner.known if c.name == "ambrosch2007_f10" and c.target == SMALL)
    assert found["ambrosch2007_f10"].luts == Number(record.luts, "ambrosch2007_f10")
    assert found["ambrosch2007_f10"].mhz == Number(record.mhz, "ambrosch2007_f10")
    assert found["ambrosch2007_f10"].luts.kind == search.MEASURED
    p2 = found["ambrosch2007_p2"]
    assert p2.luts.of and not p2.mhz.of, "routed on another device alone: its clock follows from there"
    grade8 = next(c for c in planner.known if c.name == "ambrosch2007_p2" and c.target == "ecp5")
    assert p2.mhz.value == pytest.approx(grade8.mhz * planner.model.grades()[SMALL])


def test_a_threshold_of_another_value_is_the_same_hardware():
    table = configurations()
    row = table["study_left_right"]
    assert candidates.twins(table)[candidates.key_of({**row, "left_right_threshold": 3})] == "study_left_right"
    assert candidates.key_of({**row, "left_right_threshold": -1}) == candidates.key_of(table["study"])


def test_a_row_with_another_threshold_is_another_row(planner):
    """Its hardware is measured; its row is to be added."""
    plain = {"reference": "right", "slice_disparities": 8, "window_px": 5, "sign_memory": False}
    size = Camera(320, 64, 16, 60, ("left_right",), plain)
    for threshold in (1, 3):
        camera = dataclasses.replace(size, settings={**size.settings, "left_right_threshold": threshold})
        found = {planned.numbers.luts.of: planned for planned in planner.plan(camera, place()) if planned.numbers.luts}
        assert found["study_left_right"].row == ("study_left_right" if threshold == 1 else None)


def test_a_smaller_device_and_a_larger_margin_hold_less(planner):
    camera = Camera(640, 480, 64, 40)

    def fitting(where):
        return {
            (p.candidate.algorithm.title, *sorted(map(str, p.candidate.changes.items())))
            for p in planner.plan(camera, where)
            if p.fits
        }

    every = fitting(place("ecp5"))
    for less in (
        place("ecp5", lut_sites=8000),
        place("ecp5", flip_flops=8000),
        place("ecp5", block_rams=20),
        place("ecp5", fill=10),
        place("ecp5", margin=150),
        place("ecp5_grade6"),
    ):
        assert fitting(less) < every
    nothing = planner.plan(camera, place("ecp5", block_rams=0))
    assert not any(planned.fits for planned in nothing)
    assert all("of 0 block RAMs" in " ".join(p.reasons) for p in nothing if not p.candidate.problem)


def test_too_few_flip_flops_are_named(planner):
    """As many as a core takes of the share that it may take, and one fewer."""
    camera = Camera(640, 480, 64, 30, settings={"clocks_per_pixel": 8})

    def planned(flip_flops):
        where = place("ecp5", fill=100, flip_flops=flip_flops)
        return next(p for p in planner.plan(camera, where) if p.row == "sgm_640_64_f8")

    needed = planned(80_000).numbers.flip_flop_sites
    record = next(c for c in planner.known if (c.name, c.target) == ("sgm_640_64_f8", "ecp5"))
    assert needed == Number(record.flip_flops, record.name)
    assert planned(needed.value).fits and not planned(needed.value - 1).fits
    assert planned(needed.value - 1).reasons == (f"{needed.value:,} of {needed.value - 1:,} flip-flop sites",)


def test_semi_global_matching_does_not_fit_the_smallest_gowin(planner):
    """Of the size and range that nextpnr was given in vain."""
    where = place("gw1nr_9")
    plans = [p for p in planner.plan(Camera(320, 240, 64, 10), where) if p.candidate.family == "semi_global"]
    assert len(plans) > 20 and not any(p.fits for p in plans)
    (one,) = [p for p in plans if p.row == "sgm_320_64_f16"]
    assert "6,589 of 5,508 flip-flop sites" in one.reasons


def test_recommended_is_small_and_nearly_best(planner):
    shown = search.best(planner.plan(Camera(640, 480, 64, 30), place("ecp5")))
    one = shown[search.recommended(shown)]
    assert search.wrong_pixels(one) <= search.wrong_pixels(shown[0]) + search.NEAR
    near = [p for p in shown if search.wrong_pixels(p) <= search.wrong_pixels(shown[0]) + search.NEAR]
    assert one.numbers.luts.value == min(p.numbers.luts.value for p in near)


def test_what_does_not_fit_says_why(planner):
    plans = planner.plan(Camera(640, 480, 64, 30, ("texture",)), place())
    closest = {p.candidate.algorithm.title: p for p in search.closest(plans)}
    assert closest["semi-global, `sgm_450`"].reasons == ("this family has no check of texture",)
    assert closest["block matching, `census_450`"].reasons == ("census takes no prefilter",)


def test_a_target_without_clocks_or_rams_says_so(planner):
    where = dataclasses.replace(place(), target="xc7")
    (reasons,) = {p.reasons[-1] for p in planner.plan(Camera(320, 240, 64, 1), where) if not p.candidate.problem}
    assert reasons == "no clock is known on xc7"
    assert all(
        p.numbers.block_rams is None and p.load == math.inf for p in planner.plan(Camera(320, 240, 64, 1), where)
    )


def test_rows_are_cpp(planner):
    """Every row names options of its family; words have the option's type."""
    for planned in planner.plan(Camera(320, 240, 64, 60, ("left_right",), {"pixel_bits": 10}), place()):
        text = candidates.row_text("my_core", planned.candidate)
        match = re.fullmatch(r"STEREO_ROW\(my_core, system, (\w+)((?:, \w+ = [\w:-]+)+)\);", text)
        assert match and match[1] == planned.candidate.algorithm.config
        changes = dict(change.split(" = ") for change in match[2].removeprefix(", ").split(", "))
        assert changes["pixel_bits"] == "10" and changes.get("reference", "Reference::left") == "Reference::left"


# --- the command ------------------------------------------------------------------------------------------------------


def test_text():
    process = call("plan.py", *VGA)
    assert process.returncode == 0, process.stderr
    assert process.stdout.startswith(
        "640x480, 30 frames a second, 64 disparities, on ecp5_25f_grade6: 24,288 LUT sites and 24,288 "
        "flip-flops, of them 85 %, 56 block RAMs"
    )
    for word in ("MHz needed", "block RAMs", "Does not fit", "STEREO_ROW(my_sgm_640_64_f8, system, sgm_450, ", "* an"):
        assert word in process.stdout
    for command in ("setup.sh --core", "synthesize.py --config", "cosim.py --config", "implement.py --config"):
        assert f"{command} my_sgm_640_64_f8" in process.stdout


def test_json():
    process = call("plan.py", *VGA, "--with", "median", "left_right", "--set", "pixel_bits=10", "--json", "--all")
    assert process.returncode == 0, process.stderr
    plan = json.loads(process.stdout)
    assert plan["format"] == plan_text.FORMAT
    assert plan["camera"]["with"] == ["median", "left_right"] and plan["camera"]["settings"] == {"pixel_bits": 10}
    assert len(plan["fits"]) > len({one["algorithm"] for one in plan["fits"]}), "--all shows several of each"
    for one in plan["fits"]:
        assert one["changes"]["left_right_threshold"] == 1 and one["changes"]["pixel_bits"] == 10
        assert one["reasons"] == [] and {one[n]["is"] for n in ("mhz", "luts", "block_rams")} <= {
            "measured",
            "estimate",
        }
        assert 0 < one["flip_flops"]["value"] == one["flip_flop_sites"]["value"] < plan["device"]["flip_flops"]
        assert one["luts"]["value"] > 0 and isinstance(one["block_rams"]["value"], int)
        assert one["mhz"]["value"] >= 1.2 * one["needed_mhz"] - 0.1
    assert plan["add"]["row"].startswith("STEREO_ROW(my_") and len(plan["add"]["commands"]) == 5


def test_a_row_that_is_there_is_not_added_again():
    plan = json.loads(call("plan.py", *VGA, "--json").stdout)
    number = next(i for i, one in enumerate(plan["fits"], 1) if one["row"])
    process = call("plan.py", *VGA, "--choose", number)
    assert "its row is there: sgm_640_64_f8." in process.stdout and "STEREO_ROW" not in process.stdout


def test_a_row_with_more_clocks_in_front_serves_as_one_with_fewer():
    """The map is the same."""
    table = configurations()
    row, other = table["sgm_640_64_f8"], table["census_640_f8"]
    assert row["front_clocks"] == 2 and other["front_clocks"] == 1
    without = candidates.key_of({**row, "front_clocks": 1})
    assert candidates.serving(table)[without] == "sgm_640_64_f8" and without not in candidates.twins(table)
    for found in (candidates.twins(table), candidates.serving(table)):
        assert candidates.key_of({**other, "front_clocks": 2}) not in found


@pytest.mark.parametrize("clocks, row", [(None, "sgm_640_64_f8"), (1, None), (2, "sgm_640_64_f8")])
def test_a_row_that_was_not_asked_for_does_not_serve(planner, clocks, row):
    settings = {"clocks_per_pixel": 8, **({} if clocks is None else {"front_clocks": clocks})}
    plans = planner.plan(Camera(640, 480, 64, 30, settings=settings), place())
    rows = {planned.row for planned in plans if planned.candidate.algorithm.config == "sgm_640"}
    assert rows == {row}


def test_flip_flops_that_another_design_leaves():
    """LUTs and block RAMs are those of the device."""
    plan = json.loads(call("plan.py", *VGA, "--flip-flops", 3000, "--json").stdout)
    assert plan["device"]["flip_flops"] == 3000 and plan["device"]["lut_sites"] == 24_288
    assert all(one["flip_flop_sites"]["value"] <= 0.85 * 3000 for one in plan["fits"])
    short = [one["reasons"] for one in plan["does_not_fit"]]
    assert short and any("of 2,550 flip-flop sites" in " ".join(reasons) for reasons in short)


def test_nothing_fits():
    process = call("plan.py", *VGA, "--luts", 100)
    assert process.returncode == 1 and "Nothing fits." in process.stdout and "STEREO_ROW" not in process.stdout
    plan = json.loads(call("plan.py", *VGA, "--luts", 100, "--json").stdout)
    assert plan["fits"] == [] and plan["add"] is None
    assert all(one["reasons"] for one in plan["does_not_fit"])


@pytest.mark.parametrize(
    "words, said",
    [
        ([], "--size is missing"),
        (["--size", "640"], "'640' is no size"),
        (["--size", "640x0"], "is no size"),
        (["--size", "640x480", "--fps", "0"], "'0' is no number from 0.01"),
        (["--size", "640x480", "--fps", "many"], "'many' is no number"),
        (["--size", "640x480", "--fps", "30"], "--disparities is missing"),
        (["--size", "640x480", "--fps", "30", "--disparities", "1"], "--disparities must be 2 ... 256"),
        (["--size", "64x48", "--fps", "30", "--disparities", "64"], "wider than --disparities"),
        ([*VGA, "--device", "lattice"], "--device: invalid choice: 'lattice'"),
        ([*VGA, "--with", "everything"], "invalid choice: 'everything'"),
        ([*VGA, "--set", "window"], "'window' is not NAME=VALUE"),
        ([*VGA, "--set", "window=9"], "no family has the option 'window'"),
        ([*VGA, "--set", "p1=5000"], "p1 cannot be 5000"),
        ([*VGA, "--set", "cost=mad"], "cost cannot be mad"),
        ([*VGA, "--set", "width_px=320"], "have options of their own"),
        ([*VGA, "--set", "p2=30", "--set", "p2=40"], "--set p2 appears twice"),
        ([*VGA, "--set", "pixel_bits=9"], "must be 8, 10 or 12"),
        ([*VGA, "--set", "confidence=true"], "confidence needs a support threshold"),
        ([*VGA, "--set", "path_left=false", "--set", "path_right=false", "--set", "path_above=false"], "one path must"),
        ([*VGA, "--set", "census_width_px=4"], "both sides must be odd"),
        ([*VGA, "--set", "census_pattern=sparse", "--set", "census_width_px=3", "--set", "census_height_px=3"], "3x3"),
        ([*VGA, "--set", "border_cost=3"], "border_cost needs a map of full width"),
        ([*VGA, "--set", "median=false", "--with", "median"], "turns off what --with median asks for"),
        ([*VGA, "--set", "left_right_threshold=-1", "--with", "left_right"], "turns off what --with left_right"),
        ([*VGA, "--set", "pixels_per_clock=3"], "can have pixels_per_clock 3"),
        ([*VGA, "--set", "clocks_per_pixel=3"], "64 disparities and 480 rows can have clocks_per_pixel 3"),
        ([*VGA, "--name", "tiny"], "is a configuration already"),
        *(
            ([*VGA, "--set", f"{name}={value}"], f"{name} cannot be {value}")
            for name in ("slice_disparities", "winner_group", "front_clocks", "clocks_per_pixel", "cost_clocks")
            for value in ("0", "-5", "many")
        ),
        ([*VGA, "--fill", "0"], "'0' is no number from 1"),
        ([*VGA, "--margin", "nan"], "'nan' is no number"),
        ([*VGA, "--luts", "0"], "--luts must be 1 or more"),
        ([*VGA, "--luts", "-5"], "--luts"),
        ([*VGA, "--choose", "0"], "--choose must be 1 ... "),
        ([*VGA, "--choose", "99"], "--choose must be 1 ... "),
        ([*VGA, "--name", "9lives"], "--name must be a C++ name"),
        (["--page", "--check"], "not allowed with"),
    ],
)
def test_bad_options(words, said):
    refused(call("plan.py", *words), 2, said)


@pytest.mark.parametrize(
    "words",
    [
        ["--set", "border_cost=3", "--with", "full_width"],
        ["--set", "first_disparity=3", "--with", "full_width"],
        ["--set", "prefilter_cap=252", "--set", "pixel_bits=10"],
        ["--set", "left_right_threshold=2", "--with", "left_right"],
        ["--set", "support_threshold=5", "--set", "confidence=true"],
    ],
)
def test_options_that_others_allow(words):
    process = call("plan.py", *VGA, "--device", "ecp5", *words)
    assert process.returncode == 0, process.stderr


def test_a_device_of_unknown_size_needs_all_numbers(monkeypatch):
    command = importlib.import_module("plan")
    monkeypatch.setattr(devices, "device_of", lambda target: None)
    monkeypatch.setattr(sys, "argv", ["plan.py", *VGA, "--luts", "5000"])
    with pytest.raises(FlowError, match="give --luts, --flip-flops and --block-rams"):
        command.main()


def test_help():
    process = call("plan.py", "--help")
    assert process.returncode == 0 and "exit codes: 0 done, 1 the answer is no" in " ".join(process.stdout.split())


# --- the page ---------------------------------------------------------------------------------------------------------


def test_committed_page_is_up_to_date():
    process = call("plan.py", "--check")
    assert process.returncode == 0, process.stderr


def test_check_refuses_and_writes_nothing(monkeypatch, tmp_path):
    command, path = importlib.import_module("plan"), tmp_path / "plan.md"
    path.write_text("old")
    monkeypatch.setattr(page, "pages", lambda: {path: "new"})
    monkeypatch.setattr(sys, "argv", ["plan.py", "--check"])
    with pytest.raises(FlowError, match="not up to date: .*plan.md; run scripts/plan.py --page") as caught:
        command.main()
    assert caught.value.exit_code == 1 and path.read_text() == "old"
    monkeypatch.setattr(sys, "argv", ["plan.py", "--page"])
    assert command.main() == 0 and path.read_text() == "new"


def test_page_has_every_routed_core(errors):
    text = page.PAGE.read_text()
    routed = [core for core in implemented() if "device" in core.result]
    assert len(errors) == len(routed)
    for core in routed:
        assert f"| `{core.name}` | {devices.title_of(core.target)} | {core.luts:,} |" in text


def test_summary_names_the_worst():
    """Of cores of our making: the median of the errors' sizes, and the largest one."""

    def one(name, luts, mhz):
        result = {"luts": 100, "ffs": 200, "block_rams": 4, "fmax_mhz": {"median": 100.0}, "device": "x"}
        result["lut_sites"] = 50
        core, block_rams = Implemented(name, {}, "ecp5", result), 5 if name == "b" else 4
        return compared.Compared(core, luts, block_rams, mhz, luts and 2 * luts + 2, luts and luts // 2 + 2)

    rows = page.summary([one("a", 110, 101.0), one("b", 70, 99.0), one("c", 105, 150.0), one("d", None, None)])
    assert rows[0] == "| look-up tables | 3 | 10.0 % | 12 % | -30 %, `b`, 85F, grade 8 |"
    assert rows[1] == "| LUT sites | 3 | 14.0 % | 12 % | -26 %, `b`, 85F, grade 8 |"
    assert rows[2] == "| flip-flops | 3 | 11.0 % | 12 % | -29 %, `b`, 85F, grade 8 |"
    assert rows[3] == "| block RAMs | 4 | 3 exact | exact | `b`: 5 instead of 4 |"
    assert rows[4] == "| clock | 3 | 1.0 % | 20 % | +50 %, `c`, 85F, grade 8 |"


def test_picture_has_every_system_on_every_device(planner):
    shown = plan_picture.cells(planner)
    names = {name for name, row in configurations().items() if row["use"] in plan_picture.USES}
    targets = [target for target in devices.targets() if devices.device_of(target)]
    assert {(cell.name, cell.target) for cell in shown} == {(name, target) for name in names for target in targets}
    found = {(cell.name, cell.target): cell for cell in shown}
    record = next(c for c in planner.known if (c.name, c.target) == ("miyajima_640", "ecp5"))
    assert record.result["block_rams"] > 208 and found["miyajima_640", "ecp5"].color == plan_picture.TOO_LARGE
    assert found["ambrosch2007", "ecp5"].text.startswith("2,901 a second; 13 %"), "measured, without asterisk"
