# SPDX-License-Identifier: Apache-2.0
"""What only checks writes nothing and says no with exit code 1; a simulation that stops early is no result; a full disk
leaves no half of a file."""

import importlib
import os
import re
import resource
import signal
import sys
import xml.etree.ElementTree as xml

import pytest

from flow.base import files
from flow.base.errors import FlowError
from flow.cosim import job, report
from flow.pages import clock_logic, features, performance
from flow.shell import registers
from flow.synthesis.manifest import Freshness
from flow_commands import call, cosim, refused, scene


def stale(monkeypatch, tmp_path):
    """The pages of the three commands, out of date."""
    page, picture = tmp_path / "page.md", tmp_path / "picture.svg"
    page.write_text("old")
    picture.write_text("old")
    for module in (performance, features):
        monkeypatch.setattr(module, "PAGE", page)
        monkeypatch.setattr(module, "page", lambda: "new")
    monkeypatch.setattr(performance, "routed_configurations", list)
    monkeypatch.setattr(performance, "one_number_table", lambda routed: "")
    monkeypatch.setattr(clock_logic, "PICTURE", picture)
    monkeypatch.setattr(clock_logic, "points", lambda routed: [])
    monkeypatch.setattr(clock_logic, "picture", lambda points: "old")
    monkeypatch.setattr(registers, "made_files", lambda: {page: "new"})
    return page


@pytest.mark.parametrize("kind", ["pipe", "link", "dangling"])
def test_what_is_no_regular_file_is_not_replaced(tmp_path, kind):
    path = tmp_path / kind
    if kind == "pipe":
        os.mkfifo(path)
    else:
        path.symlink_to(tmp_path / "there")
    if kind == "link":
        (tmp_path / "there").write_text("the user's own")
    with pytest.raises(FlowError, match=f"cannot write .*{kind}: it is no regular file"):
        files.write(path, "new")
    assert path.is_fifo() or path.is_symlink()
    assert kind != "link" or path.read_text() == "the user's own"


@pytest.mark.parametrize("command", ["performance", "features", "registers"])
def test_check_refuses_and_writes_nothing(monkeypatch, tmp_path, command):
    page = stale(monkeypatch, tmp_path)
    main = importlib.import_module(command).main
    monkeypatch.setattr(sys, "argv", [command, "--check"])
    with pytest.raises(FlowError, match="not up to date: .*page.md; run scripts/") as caught:
        main()
    assert caught.value.exit_code == 1 and page.read_text() == "old"
    monkeypatch.setattr(sys, "argv", [command])
    assert main() == 0 and page.read_text() == "new"
    monkeypatch.setattr(sys, "argv", [command, "--check"])
    assert main() == 0


@pytest.mark.parametrize("reasons, code", [([], 0), (["core.hpp changed"], 1)])
def test_check_of_the_vhdl_ends_with_its_answer(monkeypatch, capsys, reasons, code):
    synthesize = importlib.import_module("synthesize")
    fresh = {"b": Freshness(reasons)}
    monkeypatch.setattr(synthesize.manifest, "freshness", lambda name, row: fresh.get(name, Freshness([])))
    monkeypatch.setattr(synthesize, "check_program", lambda table: None)
    if code == 0:
        assert synthesize.check(["a", "b"], {"a": {}, "b": {}}) == 0
    else:
        with pytest.raises(FlowError, match="run scripts/synthesize.py --config b$") as caught:
            synthesize.check(["a", "b"], {"a": {}, "b": {}})
        assert caught.value.exit_code == code
        assert "a: up to date\nb: stale: core.hpp changed" in capsys.readouterr().out


def report_of(**changes):
    made = job.make_report(job.Job("tiny"), *verdict_and_timing(), clocks=12, seconds=1.0, build_seconds=0.1)
    return {**made, **changes}


def verdict_and_timing():
    from flow.cosim import checker

    return checker.Verdict(10, 10, 0, None), checker.Timing(1, None, None, None)


def test_junit_counts_failures():
    good, bad = report_of(), report_of(passed=False, mismatches=1, first_mismatch="clock 3")
    text = report.junit([report.case_of(one) for one in (good, bad, bad)]).decode()
    assert 'tests="3"' in text and 'failures="2"' in text and 'errors="0"' in text
    assert text.count("<failure ") == 2


def test_a_message_with_colours_makes_a_junit_file_that_can_be_read():
    failure = {"config": "tiny", "simulator": "ghdl", "command": "", "seed": 1, "passed": False, "environment": {}}
    failure["error"] = {"exit_code": 4, "message": "\x1b[1merror\x1b[0m: a < b\x00 \ud800"}
    suite = xml.fromstring(report.junit([report.case_of_failure(failure)]))
    assert suite.find("testcase/error").get("message") == "?[1merror?[0m: a < b? ?"


def test_a_simulation_that_stops_early_is_no_result(ghdl, tmp_path, monkeypatch):
    """The last clocks have no output, so that only their number tells."""
    left, right = scene(tmp_path / "scene", "tiny")
    read = job.vectors.read_observed

    def shortened(path):
        observed, clocks = read(path)
        return observed, clocks - 1

    monkeypatch.setattr(job.vectors, "read_observed", shortened)
    with pytest.raises(FlowError, match=r"the simulation ran \d+ of \d+ clocks") as caught:
        job.run_job(job.Job("tiny", left=left, right=right, out=tmp_path / "out"))
    ran, due = map(int, re.findall(r"\d+", str(caught.value)))
    assert ran == due - 1
    assert caught.value.exit_code == 4


def small_files():
    """As on a disk that is nearly full."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (200, resource.RLIM_INFINITY))


@pytest.fixture
def full_disk():
    limit, action = resource.getrlimit(resource.RLIMIT_FSIZE), signal.getsignal(signal.SIGXFSZ)
    small_files()
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, limit)
    signal.signal(signal.SIGXFSZ, action)


def test_a_full_disk_leaves_no_half_of_a_report(tmp_path, full_disk):
    for name in ("report.json", "junit.xml"):
        (tmp_path / name).write_text("old")
    with pytest.raises(FlowError, match="cannot write .*report.json: File too large"):
        report.write(tmp_path, report_of())
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"report.json": "old", "junit.xml": "old"}


def test_an_interruption_leaves_no_temporary_file(tmp_path, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(files.os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        files.write(tmp_path / "report.json", "new")
    assert list(tmp_path.iterdir()) == []


def test_commands_with_empty_paths(tmp_path):
    pair = scene(tmp_path / "scene", "tiny")
    assert cosim("tiny", pair, "").returncode == 2
    assert call("cosim.py", "--config", "tiny", "--rtl", "").returncode == 2


@pytest.mark.parametrize(
    "command,words",
    [
        ("explore.py", ["--scenes", 0]),
        ("implement.py", ["--config", "tiny", "--target", "ecp5"]),
        ("instantiate.py", ["--config", "tiny"]),
        ("mutate.py", []),
        ("notebook.py", []),
        ("report.py", ["--demo", "nothing"]),
        ("synthesize.py", []),
    ],
)
def test_an_empty_path_is_not_the_current_folder(command, words):
    refused(call(command, *words, "--out", ""), 2, "argument --out: must not be empty")


@pytest.mark.parametrize(
    "words, sentence",
    [
        ((), "which distribution? For example: try_distribution.sh trixie"),
        (("../..",), "which distribution?"),
        (("--out",), "--out needs a value"),
        (("--built",), "--built needs a value"),
        (("--built", "/nowhere", "trixie"), "--built /nowhere: there is no stereo_hls"),
        (("--nonsense", "trixie"), "unknown option '--nonsense'"),
    ],
)
def test_no_distribution_is_tried_by_chance(words, sentence):
    refused(call("try_distribution.sh", *words), 2, sentence)
