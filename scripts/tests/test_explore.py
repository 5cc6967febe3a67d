# SPDX-License-Identifier: Apache-2.0
"""The parameter study: what is measured, estimated or absent, which choices are on the front, and the whole command."""

import csv
import itertools
import json
import os
import shlex
import subprocess
from pathlib import Path

import pytest

from flow.base import committed, places
from flow.base.configurations import configurations
from flow.base.tools import find_stereo_hls
from flow.implementation import figures, results
from flow.planning.model import Core, Model, implemented
from flow.planning.path_shape import PathShape
from flow.planning.window_shape import WindowShape
from flow.quality import explore, front, hardware_cost
from flow.quality.hardware_cost import ABSENT, ESTIMATE, MEASURED, Study
from flow.synthesis import manifest
from flow_commands import call, refused

TABLE = configurations()


class Known:
    """A configuration with a result of our making."""

    def __init__(self, name, luts):
        self.parameters = TABLE[name]
        self.targets = {} if luts is None else {"ecp5": {"luts": luts}}


LUTS = {
    "study": 5000,
    "study_recursive": 4500,
    "study_w3": 3000,
    "study_w7": 8000,
    "study_census": None,
    "study_xsobel": 5600,
    "study_texture": 6100,
    "study_median": 5300,
    "study_subpixel": 5400,
    "study_left_right": 6000,
    "study_ssd": 7000,
    "study_uniqueness": 5800,
    "study_left": 4900,
    "study_p2": 1,
    "study_cost1": 1,
}


KNOWN = {name: Known(name, luts) for name, luts in LUTS.items()}


def made_up():
    return Study(KNOWN)


def options(**changes):
    return {**TABLE["study"], **changes}


def test_a_configuration_of_the_family_is_measured():
    """Of direct and recursive sums the smaller one; other depths and pixels a clock do not count."""
    assert made_up().cost(options()) == hardware_cost.Cost(MEASURED, 4500, ("study_recursive",))
    assert made_up().cost(options(window_px=7)).luts == 8000
    assert made_up().cost(options(left_right_threshold=3)).sources == ("study_left_right",)
    assert made_up().measured == sorted(
        name for name, luts in LUTS.items() if luts is not None and name not in ("study_p2", "study_cost1")
    )


def test_what_is_not_measured_is_estimated_by_the_model_of_plan():
    """The smaller one of direct and recursive sums; of any number of disparities."""
    model = Model(implemented())
    for changes in ({"window_px": 9, "median": True}, {"cost": "census"}, {"disparities": 64}):
        row = options(**changes)
        luts = [model.luts(Core(WindowShape({**row, "aggregation": sums})), "ecp5") for sums in hardware_cost.SUMS]
        assert made_up().cost(row) == hardware_cost.Cost(ESTIMATE, min(luts)), changes
    assert made_up().cost(options(disparities=64)).luts > 2 * made_up().cost(options(disparities=17)).luts


def test_nothing_measured_makes_the_cost_absent():
    """Of all cores, or of a configuration whose family has no model."""
    assert Study(KNOWN, Model([])).cost(options(median=True, window_px=9)) == hardware_cost.Cost(ABSENT, None)
    assert hardware_cost.of_configuration("huge", 64) == hardware_cost.Cost(ABSENT, None, (), ("huge",))
    unrouted = hardware_cost.of_configuration("tiny_trellis_median", 12)
    assert unrouted == hardware_cost.Cost(ABSENT, None, (), ("tiny_trellis_median",))


def test_configurations_with_other_disparities():
    """By the model, or in proportion where there is none."""
    model, row = Model(implemented()), TABLE["sgm_450"]
    assert hardware_cost.of_configuration("sgm_450", 64).kind == MEASURED
    luts = model.luts(Core(PathShape({**row, "disparities": 96})), "ecp5")
    assert hardware_cost.of_configuration("sgm_450", 96) == hardware_cost.Cost(ESTIMATE, luts)
    trellis = hardware_cost.of_configuration("trellis_1300", 64)
    half = hardware_cost.of_configuration("trellis_1300", 32)
    assert (trellis.kind, half.kind, half.luts) == (MEASURED, ESTIMATE, round(trellis.luts / 2))


def test_committed_results():
    """Each configuration with a result of its own costs what its file says, or less with the other sums."""
    committed = Study()
    assert len(committed.measured) > 10
    for name in committed.measured:
        configuration = results.Configuration(name, stale_is_none=True)
        cost = committed.cost(configuration.parameters)
        assert cost.kind == MEASURED and cost.luts <= figures.lut_count(configuration.targets["ecp5"])


def test_switches_are_options_of_the_study_family():
    for switch, name in {**explore.SWITCHES, **explore.COSTS}.items():
        assert manifest.read(committed.folder(name))["use"] == "study"
        found = Study().options_of(name)
        assert set(found) <= set(hardware_cost.OPTIONS) and (found or name == "study"), switch


def test_no_core_has_census_with_a_prefilter():
    sweep = explore.Sweep([5], ["sad", "census"], [16], ["xsobel", "texture"])
    found, refused_ones = explore.choices(sweep, Study())
    titles = [choice.title for choice in found]
    assert titles == ["sad 5x5", "sad 5x5 xsobel", "sad 5x5 xsobel texture", "census 5x5"] and refused_ones == 4


def test_front_is_what_no_other_choice_beats(rng):
    for _ in range(200):
        table = [
            {
                "luts": rng.choice([None, *range(1, 9)]),
                "bad": rng.choice([None, *range(8)]),
                "disparities": rng.choice([16, 64]),
            }
            for _ in range(rng.randrange(1, 25))
        ]
        known = [row for row in table if row["luts"] is not None and row["bad"] is not None]
        explore.mark_front(table, "bad")
        for row in table:
            rivals = [other for other in known if other["disparities"] == row["disparities"]]
            beaten = row not in known or any(
                (o["luts"] <= row["luts"] and o["bad"] < row["bad"])
                or (o["luts"] < row["luts"] and o["bad"] <= row["bad"])
                for o in rivals
            )
            twins = [o for o in rivals if (o["luts"], o["bad"]) == (row["luts"], row["bad"])]
            assert not (row["front"] and beaten)
            assert beaten or sum(o["front"] for o in twins) == 1, "of equal ones the first"


# --- the command ------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def explored(tmp_path_factory):
    """(process, folder) of a small sweep on one scene and, given by its files, on the same scene again."""
    folder = tmp_path_factory.mktemp("explore")
    scene = folder / "pair"
    words = "scene --width 120 --height 80 --disparities 16 --seed 3 --out".split()
    subprocess.run([find_stereo_hls(), *words, scene], check=True, capture_output=True)
    pair = [scene / name for name in ("left.png", "right.png", "disparity_left.png", "disparity_right.png")]
    options = (
        "--scenes 1 --window 3 5 --cost sad census --switch left_right --range 16 --config sgm_450 --jobs 2".split()
    )
    process = call("explore.py", "--pair", *pair, *options, "--out", folder / "out")
    assert process.returncode == 0, process.stdout + process.stderr
    return process, folder / "out"


def test_files_of_a_sweep(explored):
    process, out = explored
    content = json.loads((out / "explore.json").read_text())
    assert content["format"] == explore.FORMAT and len(content["choices"]) == 9
    assert "9 choices of options on 2 pairs (pair, scene 1)" in process.stdout
    assert (out / "front.png").read_bytes().startswith(b"\x89PNG") and (out / "front.png").stat().st_size > 10_000
    with open(out / "explore.csv", newline="") as file:
        lines = list(csv.DictReader(file))
    assert [line["title"] for line in lines] == [row["title"] for row in content["choices"]]
    for line, row in zip(lines, content["choices"]):
        assert float(line["bad_1_invalid_bad_percent"]) == pytest.approx(row["bad_1_invalid_bad_percent"], rel=1e-4)
        assert line["luts_are"] == row["luts_are"] and line["luts"] == ("" if row["luts"] is None else str(row["luts"]))


def test_rows_are_what_their_commands_print(explored, tmp_path):
    """The mean over the pairs of what stereo_hls evaluate says when each command is called again."""
    _, out = explored
    for row in json.loads((out / "explore.json").read_text())["choices"][::3]:
        masks = []
        for line in row["commands"]:
            words = shlex.split(line)
            assert words[0] == explore.PROGRAM
            subprocess.run(
                [find_stereo_hls(), *words[1:], "--json", tmp_path / "again.json"], check=True, capture_output=True
            )
            method = json.loads((tmp_path / "again.json").read_text())["methods"][0]
            assert method["parameters"]["window_px"] == row["window"] and method["parameters"]["cost"] == row["cost"]
            assert (method["parameters"]["left_right_threshold"] >= 0) == ("left_right" in row["switches"])
            masks.append(method["masks"]["non_occluded"])
        assert row["bad_2_valid_only_percent"] == pytest.approx(50 * sum(mask["bad_2"]["valid_only"] for mask in masks))
        assert row["density_percent"] == pytest.approx(50 * sum(mask["density"] for mask in masks))


def test_a_configuration_of_another_family_is_tried_as_it_is(explored):
    _, out = explored
    row = json.loads((out / "explore.json").read_text())["choices"][-1]
    assert (row["title"], row["cost"], row["disparities"]) == ("sgm_450", "semi_global", 16)
    assert all("--config sgm_450" in line and "disparities=16" in line for line in row["commands"])
    assert (row["luts"] is None) == (row["luts_are"] == ABSENT)


def test_what_is_measured_is_said(explored):
    process, out = explored
    choices = {row["title"]: row for row in json.loads((out / "explore.json").read_text())["choices"]}
    measured = Study().measured
    plain = {"study", "study_recursive"} & set(measured)
    for title, names in (
        ("sad 5x5", plain),
        ("sad 3x3", {"study_w3", "study_w3_recursive"} & set(measured)),
        ("sad 5x5 left_right", {"study_left_right"} & set(measured)),
    ):
        assert (choices[title]["luts_are"] == MEASURED) == bool(names) and set(choices[title]["luts_from"]) <= names
    assert choices["sad 3x3 left_right"]["luts_are"] == ESTIMATE
    assert all(name in process.stdout for name in measured)
    for word in ("measured:", "estimate:", "absent:", "Worth their LUTs, 16 disparities", "Measured configurations"):
        assert word in process.stdout
    for row in choices.values():
        assert row["luts_are"] != ABSENT or (not row["front"] and row["luts_missing"])


@pytest.mark.parametrize(
    "arguments,words",
    [
        (["--window", 1], ["--window", "2 ... 31"]),
        (["--range", 300], ["--range", "2 ... 256"]),
        (["--scenes", -1], ["--scenes"]),
        (["--scenes", 0], ["no pair"]),
        (["--jobs", 0], ["--jobs"]),
        (["--pair", "no.png", "no.png", "-", "-"], ["no.png", "no such file"]),
        (["--cost", "ncc"], ["invalid choice: 'ncc'"]),
        (["--cost", "census", "--switch", "colour"], ["invalid choice: 'colour'"]),
    ],
)
def test_bad_options(tmp_path, arguments, words):
    refused(call("explore.py", "--out", tmp_path / "out", *arguments), 2, *words)
    assert not (tmp_path / "out" / "explore.json").exists()


def test_a_folder_that_cannot_be(tmp_path):
    (tmp_path / "file").write_text("")
    refused(call("explore.py", "--out", tmp_path / "file" / "out"), 2, "cannot create")


def stand_in(folder, answer):
    """A program that evaluates wrongly, and does all else as the real one."""
    program = folder / "stereo_hls"
    program.write_text(f"""#!/usr/bin/python3
import os, pathlib, sys
if sys.argv[1] != "evaluate":
    os.execv({str(Path(find_stereo_hls()).resolve())!r}, ["stereo_hls", *sys.argv[1:]])
{answer}
""")
    program.chmod(0o755)
    return {"STEREO_HLS": str(program)}


@pytest.mark.parametrize(
    "answer,code,words",
    [
        ("print('stereo_hls: the truth is lost', file=sys.stderr); sys.exit(2)", 2, ["the truth is lost"]),
        ("pathlib.Path(sys.argv[-1]).write_text('{}')", 4, ["something else than 'stereo-hls evaluation 1'"]),
        (
            "pathlib.Path(sys.argv[-1]).write_text("
            '\'{"format": "stereo-hls evaluation 2", "methods": [{"parameters": {}, "masks": {}}]}\')',
            4,
            ["something else"],
        ),
    ],
)
def test_an_evaluation_that_fails(tmp_path, answer, code, words):
    options = "--scenes 1 --window 3 --cost sad --switch --range 16 --out".split()
    process = call("explore.py", *options, tmp_path / "out", environment=stand_in(tmp_path, answer))
    refused(process, code, *words)
    assert [name for name in os.listdir(tmp_path / "out") if not name.startswith("scene")] == [places.MARK]


# --- the picture ------------------------------------------------------------------------------------------------------


def crowded(number, rng):
    """A table whose front has `number` points close to each other, among others that are not on it."""

    def row(title, luts, bad):
        return {"title": title, "cost": "sad", "luts": luts, "luts_are": MEASURED, "disparities": 16, "bad": bad}

    front_rows = [row(f"sad 9x9 xsobel {i}", 5000 + 60 * i, 20 * 0.99**i) for i in range(number)]
    others = [row("other", 5000 + rng.randrange(900), 21 + 5 * rng.random()) for _ in range(20)]
    absent = {**row("absent", None, 19), "luts_are": ABSENT}
    far = row("far", 9000, 0.9 * 20 * 0.99 ** (number - 1))
    table = [*front_rows, *others, absent, far]
    explore.mark_front(table, "bad")
    assert sum(row["front"] for row in table) == number + 1
    return table


def test_names_of_the_front_cover_nothing(rng):
    text = pytest.importorskip("matplotlib.text", reason="SKIP: python3-matplotlib is not installed")
    table = crowded(8, rng)
    figure = front.panels(table, "bad", "bad 1", lambda disparities: "LUT4")
    figure.canvas.draw()
    (axis,) = figure.axes
    labels = [label for label in axis.texts if label.get_text()]
    assert len(labels) == 9
    boxes = {label.get_text(): text.Text.get_window_extent(label) for label in labels}
    for (name, box), (other, other_box) in itertools.combinations(boxes.items(), 2):
        assert not box.overlaps(other_box), f"{name} on {other}"
    points = axis.transData.transform([(row["luts"], row["bad"]) for row in table if row["luts"] is not None])
    panel = axis.get_window_extent()
    for name, box in boxes.items():
        assert not [point for point in points if box.contains(*point)], f"{name} on a point"
        assert not box.overlaps(axis.get_legend().get_window_extent()), f"{name} on the legend"
        assert panel.x0 <= box.x0 and box.x1 <= panel.x1 and panel.y0 <= box.y0 and box.y1 <= panel.y1, name
