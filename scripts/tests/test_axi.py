# SPDX-License-Identifier: Apache-2.0
"""A stereo_ip against the C++ core: the short run of scripts/verify_axi.py, and faults that it must find."""

import json
import re
import xml.etree.ElementTree as xml
from functools import cache
from pathlib import Path

import pytest

from conftest import where_reachable
from cover import with_slow
from flow.base import rtl
from flow.base.configurations import configuration
from flow.mutation import judges
from flow.shell import cocotb_runs, design, judge, pool, script, template, verify, verilated
from flow.shell.broken import beats_of
from flow.synthesis import manifest
from flow_commands import call, refused


@pytest.fixture(scope="module")
def cocotb():
    return where_reachable(cocotb_runs.environment_folder)


IN_FAST = ["tiny_f4_all", "tiny_size_all"]  # a pair in several clocks, settings and sizes
SHORT = [
    "tiny",
    "tiny_p2",
    "tiny_p4",
    "tiny_all_recursive",
    "tiny_all_p4",
    "tiny_dense",
    "tiny_f4_all",
    "tiny_settings_all",
    "tiny_size_all",
]


def test_frames_in_verilator(ghdl, verilator, tmp_path):
    """Some configurations of the short run."""
    words = [word for config in IN_FAST for word in ("--config", config)]
    process = call("verify_axi.py", *words, "--frames", 40, "--simulator", "verilator", "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["failed"] == 0 and report["broken_stream_cases"] >= 20 and {*IN_FAST} < {*SHORT}
    assert len(report["exact_frames"]) == len(IN_FAST) and all(count >= 20 for count in report["exact_frames"].values())


@pytest.mark.slow
def test_short_run_in_verilator(ghdl, verilator, tmp_path):
    process = call("verify_axi.py", "--short", "--simulator", "verilator", "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["failed"] == 0 and report["broken_stream_cases"] >= 20
    assert list(verify.SHORT_FRAMES) == SHORT
    assert all(count >= 20 for count in report["exact_frames"].values())


def test_cocotb_can_mean_no_other_module():
    """Where cocotb finds pytest, scripts/tests comes first on the path of Python (pyproject.toml)."""
    benches = {path.name for path in cocotb_runs.TESTS.glob("*.py")}
    assert benches and not benches & {path.name for path in Path(__file__).parent.glob("*.py")}


def test_each_module_is_in_each_run():
    modules = {path.stem for path in cocotb_runs.TESTS.glob("test_*.py")}
    short, long = judges.shell_stages("tiny")
    for selections in (verify.selections(is_short=True), verify.selections(is_short=False), [*short, *long]):
        assert {selection.module for selection in selections} == modules


@pytest.mark.slow
def test_short_run_in_ghdl(ghdl, cocotb, tmp_path):
    process = call("verify_axi.py", "--short", "--simulator", "ghdl", "--seed", 5, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    assert "seed 5" in process.stdout.splitlines()[-1]
    suites = xml.parse(tmp_path / "junit.xml").getroot()
    assert sum(int(suite.get("tests")) for suite in suites) > 25
    assert all(suite.get("failures") == "0" for suite in suites)


FAULTS = {
    "a beat changes while it waits": (
        "stream_fifo",
        r"\(shows = '0' or out_ready = '1'\)",
        "true",
        "changed before it was taken",
    ),
    "the shell takes no more beats": (
        "stream_credit",
        "elsif unused = '1' or taken = '1' then",
        "elsif false then",
        "not taken for ever",
    ),
    "two credits less": ("stereo_axis", r"latency_clocks \+ 9;", "latency_clocks + 7;", "clocks a frame instead of"),
    "a partial frame is not marked": (
        "stereo_frames",
        r"broken\(0\) <= breaks;",
        "broken(0) <= '0';",
        "its last beat does not say so",
    ),
}


def altered_shell(folder, file, pattern, replacement, config="tiny"):
    """The core, and a copy of the hand-written VHDL with the first place that matches changed."""
    folder.mkdir()
    for path in design.shell_files():
        text = path.read_text()
        if path.stem == file:
            text, count = re.subn(pattern, replacement, text, count=1)
            assert count == 1, f"{file}.vhd has no '{pattern}'"
        (folder / path.name).write_text(text)
    return [*manifest.core_files(config), *design.shell_files(folder)]


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["two credits less"]))
def test_fault_is_found_in_verilator(ghdl, verilator, rng, tmp_path, fault):
    file, pattern, replacement, word = FAULTS[fault]
    parameters = configuration("tiny")
    geometry = pool.Geometry.of(parameters)
    frames = pool.make_pool("tiny", parameters, 2, 1, tmp_path / "pool")
    simulation = verilated.Verilated(
        "tiny",
        tmp_path / "model",
        [*altered_shell(tmp_path / "rtl", file, pattern, replacement), template.path("tiny")],
    )
    simulation.build()
    full = script.send([beat for frame in frames for beat in beats_of(frame, geometry)])
    observation = simulation.play([*full, ("drain",)], 1, tmp_path / "full")
    starts = [clock for _, flags, clock in observation.segments[-1] if flags & 1]
    problems = [
        f"{b - a} clocks a frame instead of {geometry.groups}"
        for a, b in zip(starts, starts[1:])
        if b - a != geometry.groups
    ]
    whole = script.send(beats_of(frames[0], geometry))
    half = whole[: len(whole) // 2]
    # Two frames between the broken ones: they stand in both of the shell's places for a frame.
    steps = [*half, *whole, *whole, *half, *whole, ("rates", 20, 60), *script.mixture(rng, frames, geometry, 10)]
    problems += judge.judge(
        steps, simulation.play([*steps, ("drain",)], 1, tmp_path / "mixture"), geometry, frames
    ).problems
    assert any(word in problem for problem in problems), problems[:5]


SETTING_FAULTS = {
    "no limit": (
        "stereo_registers",
        "to_integer(unsigned(write_data(15 downto 0))) <= settings_largest(i)",
        "true",
        "register ",
    ),
    "no interrupt": ("stereo_registers", "(frame_done and frame_done_enabled)", "'0'", "irq is not 1"),
}
PENALTY_FAULTS = {
    "P2 in the register of another": (
        "stereo_ip_tiny_sgm_settings",
        "p2 => settings(3)",
        "p2 => settings(2)",
        "expected",
    ),
}
COST_FAULTS = {
    "the cost of an occlusion in the register of a drop": (
        "stereo_ip_tiny_trellis_settings",
        "occlusion_cost => settings(1)",
        "occlusion_cost => settings(0)",
        "expected",
    ),
}
SIZE_FAULTS = {
    "no least size": ("stereo_registers", ">= settings_least(i)", ">= 0", "register "),
    "a height of half a group": ("stereo_registers", "mod pixels_per_clock /= 0", "< 0", "register "),
    "no wait for the frame before": (
        "stereo_axis",
        "may_begin <= enable and not resizes",
        "may_begin <= enable",
        "frame",
    ),
    "the rows of the frame before": (
        "stereo_axis",
        "row_groups_now <= to_integer(unsigned(height_wanted)) / pixels_per_clock;",
        "",
        "not taken for ever",
    ),
}
FAULTS_OF = {
    "tiny_settings": SETTING_FAULTS,
    "tiny_sgm_settings": PENALTY_FAULTS,
    "tiny_trellis_settings": COST_FAULTS,
    "tiny_size_census_p2": SIZE_FAULTS,
}


@pytest.fixture(scope="module")
def settings_frames(tmp_path_factory):
    """The frames of a configuration, made once. Ten are too few for some seeds: none has the settings that show the
    fault."""

    @cache
    def frames(config):
        row = configuration(config)
        return pool.make_pool(config, row, pool.pairs_for(row, 120), 1, tmp_path_factory.mktemp(config))

    return frames


CASES = [(config, fault) for config in FAULTS_OF for fault in (None, *FAULTS_OF[config])]


@pytest.mark.slow  # that all is well with settings and sizes, the frames above show in the fast set
@pytest.mark.parametrize("config, fault", CASES)
def test_each_frame_has_its_settings(ghdl, verilator, settings_frames, rng, tmp_path, config, fault):
    parameters = configuration(config)
    files = design.vhdl_files(config)
    if fault:
        name, text, instead, said = FAULTS_OF[config][fault]
        place = next(place for place, path in enumerate(files) if path.stem == name)
        assert files[place].read_text().count(text) == 1
        changed = tmp_path / files[place].name
        changed.write_text(files[place].read_text().replace(text, instead))
        files[place] = changed
    simulation = verilated.Verilated(config, tmp_path / "model", files)
    simulation.build()
    geometry = pool.Geometry.of(parameters)
    frames = settings_frames(config)
    steps = script.changed_settings(rng, frames, geometry, rtl.settings_of(parameters))
    verdict = judge.judge(steps, simulation.play([*steps, ("drain",)], 1, tmp_path / "play"), geometry, frames)
    if fault:
        assert any(said in problem for problem in verdict.problems), verdict.problems[:5]
    else:
        assert verdict.problems == [] and verdict.exact_frames == len(frames)


# {fault: (configuration, (file, pattern, replacement), module, {test: whether it passes}, what the log says)}
COCOTB_FAULTS = {
    # It never gives its credit back: in the end the shell takes nothing.
    "a beat is written over": (
        "tiny",
        FAULTS["a beat changes while it waits"][:3],
        "test_stereo_ip",
        {"full_speed": True, "stalls_0_50": False},
        "a beat was not taken for ever",
    ),
    "a soft reset keeps the errors": (
        "tiny",
        ("stereo_registers", r"(resetting <= '0';)\n *sticky <= \(others => '0'\);", r"\1"),
        "test_resets",
        {"soft_reset_keeps_enable": True, "soft_reset_clears_errors_and_events": False},
        "left behind",
    ),
    "a byte of a setting counts": (
        "tiny_size_all",
        ("stereo_registers", r'write_bytes\(1 downto 0\) = "11"', "write_bytes(0) = '1'"),
        "test_settings",
        {"what_does_not_fit_is_refused": True, "only_a_whole_value_counts": False},
        "part of ",
    ),
}


@pytest.mark.parametrize("fault", with_slow(COCOTB_FAULTS, ["a beat is written over"]))
def test_fault_is_found_under_cocotb(ghdl, cocotb, tmp_path, fault):
    config, change, module, tests, said = COCOTB_FAULTS[fault]
    files = altered_shell(tmp_path / "rtl", *change, config)
    simulation = cocotb_runs.Ghdl(config, tmp_path / "work", files)
    simulation.build()
    results = simulation.run(module, 1, tmp_path / "out", list(tests))
    assert {result.name: result.passed for result in results} == tests
    assert said in (tmp_path / "out" / f"{module}.log").read_text()


@pytest.mark.slow
def test_replay_of_one_chunk(ghdl, verilator, tmp_path):
    """The same seed gives the same stream and the same beats in the same clocks."""
    texts = []
    options = ["--config", "tiny", "--frames", 60, "--chunk", 1, "--seed", 9, "--simulator", "verilator"]
    for folder in ("a", "b"):
        process = call("verify_axi.py", *options, "--out", tmp_path / folder)
        assert process.returncode == 0, process.stdout + process.stderr
        texts.append((tmp_path / folder / "verilator tiny" / "mixture_1" / "observed.txt").read_text())
    assert texts[0] == texts[1]


@pytest.mark.parametrize(
    "options, words",
    [
        (["--config", "nonsense"], ["unknown configuration"]),
        (["--frames", "3"], ["needs --config"]),
        (["--chunk", "1"], ["needs one --config"]),
        (["--seed", "-1"], ["--seed must be 0 or more"]),
    ],
)
def test_bad_options(options, words):
    refused(call("verify_axi.py", *options), 2, *words)
