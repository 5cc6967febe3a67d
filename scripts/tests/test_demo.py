# SPDX-License-Identifier: Apache-2.0
"""The demo from one command to the page, and what the page's maker does with bad input."""

import base64
import copy
import json
import os
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import pytest

from conftest import need
from flow.base import committed
from flow.base.tools import ROOT, find_stereo_hls
from flow.synthesis import manifest
from flow_commands import call, random_pair, refused, report, scene

COSIMS = ("cosim-ghdl", "cosim-verilator")


def demo(*arguments, environment=None, cwd=ROOT):
    """scripts/demo.sh with the program under test; setup.sh then looks after the build that it came from."""
    program = Path(find_stereo_hls()).resolve()
    settings = {"STEREO_HLS": str(program), "STEREO_PRESET": program.parent.name, **(environment or {})}
    words = [str(ROOT / "scripts" / "demo.sh"), *map(str, arguments)]
    return subprocess.run(
        words, cwd=cwd, capture_output=True, text=True, env={**os.environ, **settings}, stdin=subprocess.DEVNULL
    )


class Resources(HTMLParser):
    """What a browser would load for a page."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        wanted = {
            name: value
            for name, value in attributes
            if name in ("src", "srcset", "href", "data", "poster") and tag != "a"
        }
        self.found += wanted.values()


def check_page(folder, text):
    """The page stands alone and has the numbers of the files that it was made from."""
    resources = Resources(text).found
    assert len(resources) >= 4, "the pair, the map and its scale"
    for resource in resources:
        kind, _, data = resource.partition(",")
        assert kind == "data:image/png;base64" and base64.b64decode(data, validate=True).startswith(b"\x89PNG\r\n")
    assert "url(" not in text and "@import" not in text and "<script" not in text
    for name in COSIMS:
        entry = report(folder / name)
        assert f"{entry['compared']:,} / {entry['expected']:,}" in text
        assert f"{round(entry['clocks_per_second']):,}" in text
        assert f"--simulator {entry['simulator']}" in text
        if entry["clocks_per_frame"]:
            assert f">{entry['clocks_per_frame']:,}<" in text
        interval = entry["initiation_interval"]
        assert f"{interval['min']} / {interval['avg']:.2f} / {interval['max']}" in text
    match = json.loads((folder / "match" / "match.json").read_text())
    facts = manifest.read(committed.folder(match["config"]))
    assert f"{facts['tool_report']['memory_bits']:,}" in text and facts["tool"] in text
    assert "153,120" in text and "884,736" in text


@pytest.fixture(scope="module")
def tiny_demo(tmp_path_factory):
    """(process, folder) of a demo of tiny, started from another folder with a relative --out."""
    need("ghdl", "GHDL")
    need("verilator", "VERILATOR")
    folder = tmp_path_factory.mktemp("demo")
    return demo("--config", "tiny", "--seed", 5, "--out", "results", cwd=folder), folder / "results"


def test_demo_makes_page_and_pictures(tiny_demo):
    process, folder = tiny_demo
    assert process.returncode == 0, process.stdout + process.stderr
    for name in ("scene/left.png", "match/disparity.png", "match/disparity_color.png", "match/overview.png"):
        assert (folder / name).read_bytes().startswith(b"\x89PNG")
    check_page(folder, (folder / "report.html").read_text())
    assert "VHDL and C++ agree" in (folder / "report.html").read_text()


def test_demo_simulates_what_it_says(tiny_demo):
    _, folder = tiny_demo
    ghdl, verilator = (report(folder / name) for name in COSIMS)
    assert (ghdl["simulator"], ghdl["rows"], ghdl["seed"]) == ("ghdl", "2:10", 5)
    assert (verilator["simulator"], verilator["rows"], verilator["frames"]) == ("verilator", None, 2)
    assert verilator["clocks_per_frame"] == 32 * 12


def test_demo_ends_with_the_key_facts(tiny_demo):
    process, folder = tiny_demo
    last = process.stdout.splitlines()[-4:]
    assert last[0] == f"Page: {folder}/report.html, picture: {folder}/match/overview.png"
    counts = [report(folder / name)["compared"] for name in COSIMS]
    said = [f"{count:,} of {count:,} outputs in {name}" for count, name in zip(counts, ("ghdl", "verilator"))]
    assert last[1].startswith(f"PASS: VHDL against C++ core, tiny: {', '.join(said)}; 0 mismatches")
    assert counts[1] - counts[0] == 2 * 24 * 12 - 7 * 24, (
        "two frames instead of seven rows, behind the same stress stream"
    )
    assert last[2].startswith("384 clocks a frame, latency 16 clocks, ") and "% bad pixels" in last[2]
    figures = manifest.read(committed.folder("tiny"))["tool_report"]
    assert last[3] == f"{figures['memory_bits']:,} memory bits, {figures['register_bits']:,} register bits"


def test_demo_of_a_given_pair_crops_and_says_so(ghdl, verilator, tmp_path):
    left, right = random_pair(tmp_path / "pair", "ambrosch2007", levels=256)
    process = demo("--config", "tiny", "--left", left, "--right", right, "--out", tmp_path / "out")
    assert process.returncode == 0, process.stdout + process.stderr
    assert "images cropped from 320x240 to the central 32x12" in process.stdout
    text = (tmp_path / "out" / "report.html").read_text()
    check_page(tmp_path / "out", text)
    assert "--fit crop" in text
    assert "Ground truth" not in text, "only a generated scene has ground truth"
    assert not (tmp_path / "out" / "scene").exists()


def test_a_tool_that_fails_makes_the_demo_fail(ghdl, tmp_path):
    (tmp_path / "report.html").write_text("of an earlier demo")
    (tmp_path / "match").mkdir()
    (tmp_path / "match" / "match.json").write_text("{}")
    process = demo("--config", "tiny", "--out", tmp_path, environment={"GHDL": "/bin/false"})
    assert process.returncode == 4, process.stdout
    assert "demo.sh: stopped with exit code 4 of: ./scripts/cosim.py" in process.stderr
    assert not (tmp_path / "report.html").exists(), "no page that looks as if this demo had made it"


def test_a_difference_makes_the_demo_fail(ghdl, tmp_path):
    """A stand-in for stereo_hls spoils one expected disparity."""
    program = tmp_path / "stereo_hls"
    program.write_text(f"""#!/usr/bin/python3
import pathlib, subprocess, sys
code = subprocess.run(["{Path(find_stereo_hls()).resolve()}", *sys.argv[1:]]).returncode
if sys.argv[1] == "vectors":
    path = pathlib.Path(sys.argv[sys.argv.index("--out") + 1]) / "expected.txt"
    lines = path.read_text().splitlines()
    lines[9] = " ".join(lines[9].split()[:4] + ["99", "0"])
    path.write_text("\\n".join(lines) + "\\n")
sys.exit(code)
""")
    program.chmod(0o755)
    process = demo("--config", "tiny", "--out", tmp_path / "out", environment={"STEREO_HLS": str(program)})
    assert process.returncode == 1, process.stderr
    assert "expected disparity 153" in process.stdout  # hexadecimal 99
    assert not (tmp_path / "out" / "report.html").exists()
    assert report(tmp_path / "out" / "cosim-ghdl")["mismatches"] == 1


@pytest.mark.parametrize(
    "arguments,words",
    [
        (["--frobnicate"], ["unknown option '--frobnicate'", "--help"]),
        (["tiny"], ["unknown option 'tiny'"]),
        (["--config"], ["--config needs a value"]),
        (["--out", ""], ["--out needs a value"]),
        (["--seed", "one"], ["--seed one", "whole number"]),
        (["--left", "left.png"], ["--left and --right go together"]),
        (["--left", "no.png", "--right", "no.png"], ["no.png", "no such file"]),
    ],
)
def test_bad_options_of_the_demo(tmp_path, arguments, words):
    refused(demo("--out", tmp_path / "out", *arguments), 2, *words)
    assert not (tmp_path / "out").exists()


def test_unknown_configuration_in_the_demo(tmp_path):
    refused(demo("--config", "huge", "--out", tmp_path / "out"), 2, "huge", "ambrosch2007, ", "tiny")


def test_a_folder_that_cannot_be(tmp_path):
    (tmp_path / "file").write_text("")
    refused(demo("--out", tmp_path / "file" / "out"), 2, "--out", "cannot be created")


def test_help():
    process = call("demo.sh", "--help")
    assert process.returncode == 0 and "--seed" in process.stdout and "Exit codes: 0 done, 2" in process.stdout
    process = call("report.py", "--help")
    assert process.returncode == 0 and "exit codes: 0 done" in " ".join(process.stdout.split())


# --- report.py without any simulator ----------------------------------------------------------------------------------

COSIM = {
    "config": "tiny",
    "command": "scripts/cosim.py --config tiny --rows 2:10 --seed 3 --simulator ghdl",
    "simulator": "ghdl",
    "rows": "2:10",
    "stall_percent": 0,
    "seed": 3,
    "passed": True,
    "expected": 1168,
    "compared": 1168,
    "mismatches": 0,
    "first_mismatch": None,
    "frames": 1,
    "clocks": 270,
    "clocks_per_frame": None,
    "initiation_interval": {"min": 1, "avg": 1.0, "max": 1},
    "latency_clocks": 10,
    "clocks_per_second": 4321.4,
    "build_seconds": 0.1,
    "simulation_seconds": 0.1,
}


@pytest.fixture
def filled(tmp_path):
    """A demo folder as the demo leaves it, with made-up co-simulations."""
    folder = tmp_path / "demo"
    left, right = scene(folder / "scene", "tiny", seed=3)
    images = ["--left", left, "--right", right]
    truth = ["--truth", folder / "scene" / "disparity_right.png", "--visible", folder / "scene" / "visible_right.png"]
    subprocess.run(
        [find_stereo_hls(), "match", "--config", "tiny", *images, *truth, "--out", folder / "match"],
        check=True,
        capture_output=True,
    )
    whole = {
        "simulator": "verilator",
        "command": "scripts/cosim.py --config tiny --frames 2 --seed 3 --simulator verilator",
        "rows": None,
        "frames": 2,
        "clocks_per_frame": 384,
        "expected": 576,
        "compared": 576,
    }
    for name, changes in zip(COSIMS, ({}, whole)):
        (folder / name).mkdir()
        change(folder / name / "report.json", copy.deepcopy(COSIM), **changes)
    return folder


def change(path, content=None, **changes):
    content = json.loads(path.read_text()) if content is None else content
    path.write_text(json.dumps({**content, **changes}))


def test_page_of_a_filled_folder(filled, tmp_path):
    process = call("report.py", "--demo", filled, "--out", tmp_path / "new" / "page.html")
    assert process.returncode == 0, process.stderr
    text = (tmp_path / "new" / "page.html").read_text()
    check_page(filled, text)
    truth = json.loads((filled / "match" / "match.json").read_text())["truth"]
    assert f"<b>{truth['bad_px']}</b> of {truth['compared_px']} visible pixels" in text
    assert "--seed 3" in text and "--rows 2:10" in text
    assert not (filled / "report.html").exists()


def test_page_of_a_difference(filled):
    change(filled / COSIMS[0] / "report.json", passed=False, mismatches=2, first_mismatch="clock 9: <surplus> output")
    change(
        filled / COSIMS[1] / "report.json",
        passed=False,
        compared=0,
        mismatches=576,
        clocks_per_frame=None,
        initiation_interval=None,
        latency_clocks=None,
    )
    process = call("report.py", "--demo", filled)
    assert process.returncode == 1, process.stderr
    assert process.stdout.splitlines()[1].startswith("FAIL: ") and "578 mismatches" in process.stdout
    text = (filled / "report.html").read_text()
    assert "VHDL and C++ differ" in text and "clock 9: &lt;surplus&gt; output" in text and "0 / 576" in text


@pytest.mark.parametrize("name", COSIMS)
def test_one_difference_is_a_failure(filled, name):
    change(filled / name / "report.json", passed=False, mismatches=1, first_mismatch="clock 9")
    process = call("report.py", "--demo", filled)
    assert process.returncode == 1, process.stderr
    assert process.stdout.splitlines()[1].startswith("FAIL: ")


def test_texts_from_files_are_escaped(filled):
    change(filled / "match" / "match.json", left="<script>alert(1)</script>/left.png")
    assert call("report.py", "--demo", filled).returncode == 0
    assert "<script" not in (filled / "report.html").read_text()


def cut(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def without(path, key):
    content = json.loads(path.read_text())
    del content[key]
    path.write_text(json.dumps(content))


@pytest.mark.parametrize(
    "name,damage,words",
    [
        ("match/match.json", Path.unlink, ["No such file", "demo.sh"]),
        ("match/match.json", cut, ["damaged", "demo.sh"]),
        ("match/match.json", lambda path: path.write_text("[]"), ["damaged", "not an object"]),
        ("match/match.json", lambda path: path.write_bytes(b"\xff\xfe"), ["damaged"]),
        ("match/match.json", lambda path: without(path, "left"), ["damaged", "no 'left'"]),
        ("match/match.json", lambda path: change(path, truth=7), ["damaged"]),
        ("match/match.json", lambda path: change(path, format="stereo-hls match 9"), ["match 9"]),
        ("match/match.json", lambda path: change(path, config="huge"), ["huge"]),
        ("match/disparity.png", Path.unlink, ["No such file", "demo.sh"]),
        ("match/disparity.png", lambda path: path.write_text("no image"), ["damaged", "PNG"]),
        ("match/disparity.png", cut, ["disparity.png", "not a readable image"]),
        (
            "match/match.json",
            lambda path: change(path, output_width_px=23),
            ["damaged", "its size is not the one in match.json"],
        ),
        ("cosim-ghdl/report.json", Path.unlink, ["No such file", "demo.sh"]),
        ("cosim-ghdl/report.json", cut, ["damaged"]),
        ("cosim-verilator/report.json", lambda path: without(path, "mismatches"), ["damaged", "no 'mismatches'"]),
        ("cosim-verilator/report.json", lambda path: change(path, compared="many"), ["damaged", "unusable 'compared'"]),
        ("cosim-verilator/report.json", lambda path: change(path, compared=True), ["damaged", "unusable 'compared'"]),
        (
            "cosim-verilator/report.json",
            lambda path: change(path, initiation_interval={"min": 1}),
            ["damaged", "no 'avg'"],
        ),
        (
            "cosim-ghdl/report.json",
            lambda path: change(path, expected=0, compared=0),
            ["damaged", "do not say what its 'passed' says"],
        ),
        ("cosim-ghdl/report.json", lambda path: change(path, compared=1167), ["damaged", "'passed'"]),
        ("cosim-ghdl/report.json", lambda path: change(path, mismatches=1), ["damaged", "'passed'"]),
        ("cosim-verilator/report.json", lambda path: change(path, passed=False), ["damaged", "'passed'"]),
        ("cosim-verilator/report.json", lambda path: change(path, config="ambrosch2007"), ["ambrosch2007", "tiny"]),
    ],
)
def test_bad_input_of_the_report(filled, name, damage, words):
    damage(filled / name)
    before = sorted(filled.rglob("*"))
    refused(call("report.py", "--demo", filled), 2, *words)
    assert sorted(filled.rglob("*")) == before


def test_a_folder_without_a_demo(tmp_path):
    refused(call("report.py", "--demo", tmp_path), 2, "match.json", "demo.sh")
    refused(call("report.py", "--demo", tmp_path / "none"), 2, "no such folder", "demo.sh")
    refused(call("report.py"), 2, "required", "--demo")


def test_a_page_that_cannot_be_written(filled, tmp_path):
    (tmp_path / "file").write_text("")
    refused(call("report.py", "--demo", filled, "--out", tmp_path / "file" / "page.html"), 2, "cannot write")
    (tmp_path / "folder.html").mkdir()
    refused(call("report.py", "--demo", filled, "--out", tmp_path / "folder.html"), 2, "cannot write")
    assert list((tmp_path / "folder.html").iterdir()) == []
    refused(call("report.py", "--demo", filled, "--out", filled / "match" / "disparity.png"), 2, "ends in .html")
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]
