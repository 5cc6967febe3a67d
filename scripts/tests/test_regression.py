# SPDX-License-Identifier: Apache-2.0
"""Many co-simulations at once: none is lost, none is green that is not, and runs side by side stay apart."""

import json
import os
import re
import shutil
import signal
import subprocess
import threading
import time
import xml.etree.ElementTree as xml

import pytest

from cover import with_slow
from flow.base import committed, places
from flow.base.errors import FlowError
from flow.base.farm import Farm
from flow.base.tools import ROOT, find_stereo_hls
from flow.cosim import overview, regression
from flow_commands import altered_rtl, call, cosim, random_pair, refused, report

WINNER = (r"(slice2_best_index_0_0 <= )slice1_best_index_0_0;", r"\g<1>slice1_best_index_0_0 / 2;")


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    return random_pair(tmp_path_factory.mktemp("pair"), "tiny", levels=4)


@pytest.mark.parametrize("rounds", with_slow([2, 12], [2]))
def test_a_good_and_a_faulty_core_at_once(ghdl, pair, tmp_path, rounds):
    """Each run says what is so of its own VHDL, though both have the same configuration and the same --out."""
    faulty = altered_rtl(tmp_path / "rtl", "tiny", *WINNER)
    command = [str(ROOT / "scripts" / "cosim.py"), "--config", "tiny", "--left", pair[0], "--right", pair[1]]
    for number in range(rounds):
        for folder in (faulty, committed.folder("tiny")):  # so that both are built again
            design = folder / "stereo_core_tiny.vhd"
            copy = shutil.copytree(folder, tmp_path / f"{number}-{folder.parent.name}" / "tiny")
            (copy / design.name).write_text(design.read_text() + f"-- {number}\n")
        runs = [
            subprocess.Popen(
                [*command, "--rtl", copy, "--allow-edited", "--out", tmp_path / "out"],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
            )
            for copy in (tmp_path / f"{number}-rtl" / "tiny", tmp_path / f"{number}-block_matching" / "tiny")
        ]
        said = [run.communicate()[0] for run in runs]
        assert [run.returncode for run in runs] == [1, 0], "\n".join(said)


@pytest.fixture
def stand_ins(monkeypatch, tmp_path):
    """A regression over `tiny` and others with a stand-in for cosim.py, which ends as the configuration's name says."""
    (tmp_path / "scripts").mkdir()
    script = tmp_path / "scripts" / "cosim.py"
    script.write_text("""import json, os, pathlib, sys, time
def value(name):
    return sys.argv[sys.argv.index(name) + 1]
config, out = value("--config"), pathlib.Path(value("--out"))
code = int(config[-1])
if config.startswith("killed"):
    os.kill(os.getpid(), 9)
if config.startswith("slow"):
    (out / "waits").touch()
    time.sleep(60)
content = {"config": config, "simulator": "ghdl", "seed": 1, "command": "cosim " + config, "passed": code == 0,
           "expected": 10, "compared": 10, "mismatches": code, "first_mismatch": "clock 3" if code else None,
           "clocks": 12, "simulation_seconds": 0.5, "initiation_interval": None, "latency_clocks": None,
           "clocks_per_frame": None, "clocks_per_second": 1.0, "build_seconds": 0.1}
if config.startswith("liar"):
    content["compared"], content["expected"] = 0, 0
if code > 1:
    content = {k: content[k] for k in ("config", "simulator", "seed", "command", "passed")}
    content["error"] = {"exit_code": code, "message": "the tool said no"}
if not config.startswith("silent"):
    (out / "report.json").write_text(json.dumps(content))
print("last words")
sys.exit(code)
""")
    monkeypatch.setattr(regression, "ROOT", tmp_path)
    monkeypatch.setattr(regression.Regression, "_digest", lambda self, config: config)
    return tmp_path / "out"


def run(out, *configs, jobs=1, **options):
    with Farm(jobs) as farm:
        code = regression.Regression(configs, "ghdl", [], [], out, farm, **options).run()
    return code, json.loads((out / "summary.json").read_text()), xml.parse(out / "junit.xml").getroot()


def outcomes(summary):
    return {entry["config"]: entry["outcome"] for entry in summary["runs"]}


def test_every_outcome_is_told(stand_ins, capsys):
    code, summary, suite = run(stand_ins, "good0", "wrong1", "input2", "missing3", "broken4", jobs=2)
    assert code == 1 and summary["passed"] is False and summary["counts"]["ERROR"] == 3
    assert outcomes(summary) == {
        "good0": "pass",
        "wrong1": "FAIL",
        "input2": "ERROR",
        "missing3": "ERROR",
        "broken4": "ERROR",
    }
    assert [suite.get(key) for key in ("tests", "failures", "errors", "skipped")] == ["5", "1", "3", "0"]
    assert suite.find("testcase[@name='wrong1']/failure").get("message") == "clock 3"
    assert suite.find("testcase[@name='missing3']/error").get("message") == "the tool said no"
    assert suite.find("testcase[@name='good0']/properties/property[@name='command']").get("value") == "cosim good0"
    assert suite.find("properties/property[@name='processors']") is not None
    lines = capsys.readouterr().out.splitlines()
    assert sum(line.startswith(("pass ", "FAIL ", "ERROR ")) for line in lines) == 5
    assert "20 of 20 outputs compared, 1 mismatches" in lines[-1] and lines[-1].startswith(
        "FAIL: 1 pass, 1 FAIL, 3 ERR"
    )


def test_the_page_shows_every_run(stand_ins):
    run(stand_ins, "good0", "wrong1", "missing3")
    (stand_ins / "wrong1-ghdl" / "failure.html").touch()
    _, summary, _ = run(stand_ins, "good0", "wrong1", "missing3")
    text = (stand_ins / "summary.html").read_text()
    rows = {row: re.sub(r"<[^>]*>", " ", row).split() for row in re.findall(r"<tr>\n<td>.*?</tr>", text, re.DOTALL)}
    shown = {words[0]: (row, words) for row, words in rows.items()}
    assert shown.keys() == {"good0", "wrong1", "missing3"}
    assert shown["good0"][1][2:6] == ["pass", "10", "10", "0"]
    assert shown["wrong1"][1][2] == "FAIL" and "clock 3" in shown["wrong1"][0]
    assert 'href="wrong1-ghdl/failure.html"' in shown["wrong1"][0] and "failure.html" not in shown["good0"][0]
    assert "the tool said no" in shown["missing3"][0] and 'class="badge fail"' in text


def test_without_jinja_there_is_no_page(stand_ins, monkeypatch, capsys):
    def missing(*_, **__):
        raise ModuleNotFoundError(name="jinja2")

    monkeypatch.setattr(overview.page, "render", missing)
    assert run(stand_ins, "good0")[0] == 0
    assert "no summary.html: the Python package jinja2 is missing" in capsys.readouterr().out
    assert not (stand_ins / "summary.html").exists()


@pytest.mark.parametrize(
    "configs, code", [(["good0"], 0), (["good0", "input2", "broken4"], 4), (["good0", "wrong1"], 1)]
)
def test_exit_code(stand_ins, configs, code):
    assert run(stand_ins, *configs)[0] == code


@pytest.mark.parametrize("config", ["silent0", "liar0", "silent1"])
def test_an_exit_code_that_the_report_does_not_bear_out_is_an_error(stand_ins, config):
    code, summary, _ = run(stand_ins, config)
    assert code == 4 and outcomes(summary) == {config: "ERROR"}


def test_one_that_was_killed_is_an_error(stand_ins):
    """As by the kernel, where memory is short."""
    code, summary, suite = run(stand_ins, "good0", "killed0")
    assert code == 4 and summary["passed"] is False and outcomes(summary) == {"good0": "pass", "killed0": "ERROR"}
    assert suite.find("testcase[@name='killed0']/error").get("message") == "killed by signal 9"


def test_an_interruption_keeps_what_has_run(stand_ins, monkeypatch):
    """Ctrl-C, or the time limit of a CI service."""

    def interrupt():
        while not (stand_ins / "slow0-ghdl" / "waits").exists():
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    kept = []
    monkeypatch.setattr(regression.record, "keep", lambda reports, _: kept.extend(one["config"] for one, _ in reports))
    monkeypatch.setattr(regression.record, "design", lambda config: {})
    started = time.monotonic()
    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        run(stand_ins, "good0", "slow0", "other0", recorded="runs")
    assert kept == ["good0"]
    assert time.monotonic() - started < 30, "what runs is ended"
    summary = json.loads((stand_ins / "summary.json").read_text())
    assert outcomes(summary) == {"good0": "pass", "slow0": "not run", "other0": "not run"}
    assert summary["passed"] is False and summary["exit_code"] == 130
    suite = xml.parse(stand_ins / "junit.xml").getroot()
    assert (
        suite.get("skipped") == "2" and suite.find("testcase[@name='other0']/skipped").get("message") == "interrupted"
    )
    assert outcomes(run(stand_ins, "good0", "other0", only_changed=True)[1]) == {"good0": "unchanged", "other0": "pass"}


def test_what_was_compared_is_kept_at_the_end(stand_ins, monkeypatch):
    """A wrong result, too: whoever reads it asks whether it passed."""
    kept = []
    monkeypatch.setattr(regression.record, "keep", lambda *of: kept.append(of))
    monkeypatch.setattr(regression.record, "design", lambda config: {"structure": config})
    run(stand_ins, "good0", "wrong1", "input2")
    assert kept == []
    run(stand_ins, "good0", "wrong1", "input2", recorded="stress")
    [(reports, stimulus)] = kept
    assert [(one["config"], one["passed"]) for one, _ in reports] == [("good0", True), ("wrong1", False)]
    assert stimulus == "stress" and all(design == {"structure": one["config"]} for one, design in reports)


def test_a_report_of_an_earlier_run_is_not_taken(stand_ins):
    (stand_ins / "silent0-ghdl").mkdir(parents=True)
    shutil.copy(run(stand_ins, "good0") and stand_ins / "good0-ghdl" / "report.json", stand_ins / "silent0-ghdl")
    assert run(stand_ins, "silent0")[0] == 4


def test_fail_fast(stand_ins):
    code, summary, suite = run(stand_ins, "good0", "wrong1", "other0", fails_fast=True)
    assert code == 1 and outcomes(summary) == {"good0": "pass", "wrong1": "FAIL", "other0": "not run"}
    assert suite.get("skipped") == "1"


def test_only_what_has_changed(stand_ins, monkeypatch):
    run(stand_ins, "good0", "other0", "wrong1")
    for _ in range(2):
        code, summary, _ = run(stand_ins, "good0", "other0", "wrong1", only_changed=True)
        assert code == 1 and outcomes(summary) == {"good0": "unchanged", "other0": "unchanged", "wrong1": "FAIL"}
    monkeypatch.setattr(regression.Regression, "_digest", lambda self, config: f"{config} new")
    _, summary, _ = run(stand_ins, "good0", only_changed=True)
    assert outcomes(summary) == {"good0": "pass"}


def test_a_damaged_summary_is_refused(stand_ins):
    stand_ins.mkdir()
    for text in ("", "[]", '{"format": "stereo-hls regression 1", "runs": 7}'):
        (stand_ins / "summary.json").write_text(text)
        with pytest.raises(FlowError, match="damaged"):
            run(stand_ins, "good0", only_changed=True)


def test_the_inputs_that_count(ghdl, tmp_path, monkeypatch):
    shutil.copytree(committed.folder("tiny"), tmp_path / "rtl" / "block_matching" / "tiny")
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path / "rtl")
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    image = tmp_path / "left.pgm"
    image.write_text("1")

    def digest(*options):
        return regression.Regression(["tiny"], "ghdl", options, [image], tmp_path, Farm(1))._digest("tiny")

    seen = [digest(), digest("--frames", "2")]
    image.write_text("2")
    seen.append(digest())
    design = tmp_path / "rtl" / "block_matching" / "tiny" / "stereo_core_tiny.vhd"
    design.write_text(design.read_text() + "\n")
    seen.append(digest())
    program = shutil.copy(find_stereo_hls(), tmp_path / "stereo_hls")
    monkeypatch.setenv("STEREO_HLS", str(program))
    monkeypatch.setenv("STEREO_CORES", str(tmp_path))
    for name in ("stereo_hls_images.so", "tiny.so", "stereo_hls"):  # what reads the images, the core, the program
        with (tmp_path / name).open("ab") as file:
            file.write(b"another")
        seen.append(digest())
    assert len(set(seen)) == 7 and digest() == seen[-1]


def test_names_and_patterns():
    made = committed.known_designs()
    assert regression.select(["tiny_p2", "tiny", "tiny_p2"]) == ["tiny_p2", "tiny"]
    assert regression.select(["all"]) == made
    assert regression.select(["tiny_p?"]) == ["tiny_p2", "tiny_p4"]
    with pytest.raises(FlowError, match="'huge\\*'"):
        regression.select(["tiny", "huge*"])
    with pytest.raises(FlowError, match="unknown configuration 'huge'"):
        regression.select(["tiny", "huge"])


def test_two_configurations_are_two_runs(ghdl, tmp_path):
    """Without images: generated scenes, of each configuration's size."""
    process = call("cosim.py", "--config", "tiny", "--config", "tiny_p2", "--rows", "8", "--out", tmp_path)
    assert outcomes(json.loads((tmp_path / "summary.json").read_text())).keys() == {"tiny", "tiny_p2"}
    assert process.returncode == 0, process.stdout + process.stderr
    assert report(tmp_path / "tiny_p2-ghdl")["compared"] > 0


@pytest.mark.parametrize(
    "options, words",
    [
        (["--config", "tiny", "tiny_p2", "--rtl", "x"], ["--rtl is for one"]),
        (["--config", "all", "--wave", "x.vcd"], ["--wave is for one"]),
        (["--config", "tiny", "--jobs", "2"], ["--jobs", "several"]),
        (["--config", "all", "--jobs", "0"], ["--jobs: '0' is no whole number, 1 or more"]),
        (["--config", "huge*"], ["'huge*'"]),
    ],
)
def test_wrong_use(tmp_path, options, words):
    refused(call("cosim.py", *options, "--out", tmp_path / "out"), 2, *words)
    assert not (tmp_path / "out").exists()


# --- what a report says -----------------------------------------------------------------------------------------------


def test_a_report_names_its_surroundings(ghdl, pair, tmp_path):
    for cached in (False, True):
        design = altered_rtl(tmp_path / str(cached), "tiny", r"\Z", f"-- {tmp_path}\n")
        assert cosim("tiny", pair, tmp_path / "out", "--rtl", design).returncode == 0
        result = report(tmp_path / "out")
        assert result["is_cached"] is cached and result["seed"] == 1
        assert result["tools"]["ghdl"].startswith("GHDL ")
        assert {"commit", "system", "processors"} <= result["environment"].keys()


def test_edited_vhdl_is_marked(ghdl, pair, tmp_path):
    copy = shutil.copytree(committed.folder("tiny"), tmp_path / "tiny")
    design = copy / "stereo_core_tiny.vhd"
    design.write_text(design.read_text() + "-- tried out\n")
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", copy, "--allow-edited")
    assert process.returncode == 0, process.stderr
    assert "EDITED VHDL" in process.stdout and report(tmp_path / "out")["edited"] == [str(design)]
    suite = xml.parse(tmp_path / "out" / "junit.xml").getroot()
    assert suite.find("testcase/properties/property[@name='edited']").get("value") == str(design)
    assert "--allow-edited" in report(tmp_path / "out")["command"]
    refused(call("cosim.py", "--config", "tiny", "--record", "--allow-edited"), 2, "--record")


def test_vectors_of_ones_own(ghdl, pair, tmp_path):
    assert cosim("tiny", pair, tmp_path / "made").returncode == 0
    stimulus, expected = tmp_path / "made" / "stimulus.txt", tmp_path / "made" / "expected.txt"
    words = ["--config", "tiny", "--stimulus", stimulus, "--expected", expected, "--out", tmp_path / "out"]
    process = call("cosim.py", *words)
    assert process.returncode == 0, process.stderr
    assert report(tmp_path / "out")["compared"] == 288
    lines = expected.read_text().splitlines()
    lines[5] = " ".join([*lines[5].split()[:4], "7f", lines[5].split()[5]])
    expected.write_text("\n".join(lines) + "\n")
    assert call("cosim.py", *words).returncode == 1
    assert report(tmp_path / "out")["mismatches"] == 1
    refused(call("cosim.py", *words, "--rows", "8"), 2, "--stimulus")
    refused(call("cosim.py", "--config", "tiny", "--stimulus", stimulus), 2, "--expected")
    expected.write_text(expected.read_text().replace("config=tiny ", "config=tiny_p2 "))
    refused(call("cosim.py", *words), 2, f"{expected}, line 1", "config=tiny_p2, but the core is tiny")
    stimulus.write_bytes(b"\xff")
    refused(call("cosim.py", *words), 2, f"cannot read vector file {stimulus}: not a text file")


def test_vhdl_of_another_configuration(pair, tmp_path):
    process = cosim("tiny_p2", pair, tmp_path / "out", "--rtl", committed.folder("tiny"))
    refused(process, 2, "is the VHDL of tiny, not of tiny_p2")


def test_a_relative_folder_of_vhdl(ghdl, pair, tmp_path):
    copy = shutil.copytree(committed.folder("tiny"), tmp_path / "copy")
    words = [str(ROOT / "scripts" / "cosim.py"), "--config", "tiny", "--left", pair[0], "--right", pair[1]]
    words += ["--rtl", copy.name, "--out", "out"]
    process = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True)
    assert process.returncode == 0, process.stderr


@pytest.mark.parametrize(
    "code, left, environment, says",
    [
        (2, "none.png", {}, "no such file"),
        (3, None, {"STEREO_CORES": "/nowhere"}, "the clocked core of tiny is not built"),
        (3, None, {"GHDL": "/nowhere/ghdl"}, "ghdl not found"),
    ],
)
def test_bad_input_and_missing_tools_leave_a_report(pair, tmp_path, code, left, environment, says):
    """None of an earlier run."""
    out = tmp_path / "out"
    out.mkdir()
    for name in ("report.json", "junit.xml", places.MARK):
        (out / name).write_text("of an earlier run")
    refused(cosim("tiny", (left or pair[0], pair[1]), out, environment=environment), code, says)
    error = report(out)["error"]
    assert error["exit_code"] == code and says in error["message"] and report(out)["passed"] is False
    suite = xml.parse(out / "junit.xml").getroot()
    assert [suite.get(key) for key in ("tests", "failures", "errors")] == ["1", "0", "1"]
    assert says in suite.find("testcase/error").get("message")


def test_an_error_leaves_a_report(ghdl, pair, tmp_path):
    """GHDL's own first line is the message, with the user's file."""
    copy = altered_rtl(tmp_path / "rtl", "tiny", r"^begin$", "  signal x : no_such_type;\nbegin")
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", copy)
    refused(process, 4, str(copy / "stereo_core_tiny.vhd"), 'no declaration for "no_such_type"')
    error = report(tmp_path / "out")["error"]
    assert error["exit_code"] == 4 and "no_such_type" in error["message"]
    suite = xml.parse(tmp_path / "out" / "junit.xml").getroot()
    assert [suite.get(key) for key in ("tests", "failures", "errors")] == ["1", "0", "1"]
    assert "no_such_type" in suite.find("testcase/error").get("message")
    assert cosim("tiny", pair, tmp_path / "out").returncode == 0
    assert "error" not in report(tmp_path / "out")
