# SPDX-License-Identifier: Apache-2.0
"""The whole verification of stereo_ip: many random frames in Verilator, all scenarios under cocotb in GHDL."""

import json
import random
import time
import xml.etree.ElementTree as xml
from dataclasses import asdict, dataclass, field
from pathlib import Path

from ..base.configurations import configuration
from ..base.errors import EXIT_MISMATCH, EXIT_OK
from ..base.tools import ROOT
from . import cocotb_runs, judge, pool, script, verilated
from .broken import CASES, beats_of
from .contract import RESULT_START

WORK = ROOT / "build" / "axi"
CHUNK_FRAMES = 50  # correct frames of one simulation
# Some of them without stalls. With options: left reference and checks; a gap between frames; frames that are shorter than their way
# through the core, in beats of more than 64 bits.
FRAMES = {
    "tiny": 600,
    "tiny_p2": 450,
    "tiny_p4": 450,
    "tiny_all_left_p2": 150,
    "tiny_all_recursive": 150,
    "tiny_all_p4": 150,
    "ambrosch2007": 26,
}
LARGEST_FOR_CASES = 10000  # groups of a frame: larger ones meet the broken streams in the mixture only
SHORT_FRAMES = {"tiny": 60, "tiny_p2": 20, "tiny_p4": 20, "tiny_all_recursive": 20, "tiny_all_p4": 20}
# (configuration, module, tests or None for all, generics that differ, what differs)
COCOTB_RUNS = (
    ("tiny", "test_stereo_ip", None, {}, ""),
    ("tiny", "test_registers", None, {}, ""),
    ("tiny_p2", "test_stereo_ip", ["full_speed", "sink_waits_then_takes_all", "mixture", "reset_at_any_clock"], {}, ""),
    ("tiny_p2", "test_registers", None, {}, ""),
    ("tiny_p4", "test_stereo_ip", ["full_speed", "sink_waits_then_takes_all", "mixture", "reset_at_any_clock"], {}, ""),
    ("tiny_p4", "test_registers", None, {}, ""),
    (
        "tiny_all_recursive",
        "test_stereo_ip",
        ["full_speed", "gaps_of_all_lengths", "mixture", "reset_at_any_clock"],
        {},
        "",
    ),
    (
        "tiny",
        "test_stereo_ip",
        ["full_speed", "gaps_of_all_lengths", "mixture"],
        {"gap_groups": 33},
        "gap of the whole flush",
    ),
    (
        "tiny",
        "test_stereo_ip",
        ["full_speed", "gaps_of_all_lengths", "mixture"],
        {"gap_groups": 40, "flush_groups": 60},
        "gap within a longer flush",
    ),
    ("tiny", "test_generics", ["wrong_latency"], {"latency_clocks": 14}, "latency too short"),
    ("tiny", "test_generics", ["wrong_latency"], {"latency_clocks": 16}, "latency too long"),
    ("tiny", "test_generics", ["starts_disabled"], {"enabled_at_reset": "false"}, "disabled at reset"),
)
SHORT_RUNS = (
    (
        "tiny",
        "test_stereo_ip",
        [
            "full_speed",
            "sink_waits_then_takes_all",
            "stalls_0_50",
            "stalls_30_30",
            "broken_a_beat_lost",
            "broken_a_single_beat_with_both_flags",
            "broken_half_a_frame",
            "broken_no_end_of_a_line",
            "broken_no_start_of_frame",
            "broken_start_of_frame_with_each_beat",
            "reset_at_any_clock",
            "mixture",
        ],
        {},
        "",
    ),
    *(COCOTB_RUNS[place] for place in (1, 4, 8, 9, 11)),
)


@dataclass
class Case:
    suite: str
    name: str
    seconds: float = 0.0
    problems: list = field(default_factory=list)
    exact_frames: int = 0
    broken_frames: int = 0
    compared: int = 0
    clocks: int = 0
    hangs: bool = False


def chunks_of(frames):
    """Numbers of the simulations that share so many frames."""
    return range((frames + CHUNK_FRAMES - 1) // CHUNK_FRAMES)


class Verification:
    def __init__(self, seed, out, say=print):
        self.seed, self.out, self.say = seed, Path(out), say
        self.cases = []

    def _add(self, case):
        self.cases.append(case)
        for problem in case.problems[:5]:
            self.say(f"  FAIL {case.suite} {case.name}: {problem}")

    def _play(self, simulation, suite, name, steps, geometry, frames, seed):
        started = time.monotonic()
        folder = self.out / suite / name.replace(" ", "_")
        observation = simulation.play([*steps, ("drain",)], seed, folder)
        verdict = judge.judge(steps, observation, geometry, frames)
        case = Case(
            suite,
            name,
            time.monotonic() - started,
            verdict.problems,
            verdict.exact_frames,
            verdict.broken_frames,
            verdict.compared,
            observation.clocks,
            observation.hangs,
        )
        self._add(case)
        return case, observation

    def run_verilator(self, config, count, only_chunk=None):
        """`count` correct frames with everything that can stand between them, all broken streams, and the full speed."""
        parameters = configuration(config)
        geometry = pool.Geometry.of(parameters)
        suite = f"verilator {config}"
        frames = pool.make_pool(config, parameters, 6, self.seed, self.out / suite / "pool")
        simulation = verilated.Verilated(config, WORK / "verilator" / config)
        self.say(f"{suite}: building ...")
        simulation.build()
        first = len(self.cases)
        for chunk in chunks_of(count):
            if only_chunk in (None, chunk):
                rng = random.Random(f"{self.seed} {config} {chunk}")
                steps = script.mixture(rng, frames, geometry, min(CHUNK_FRAMES, count - chunk * CHUNK_FRAMES))
                self._play(simulation, suite, f"mixture {chunk}", steps, geometry, frames, self.seed * 1000 + chunk)
        if only_chunk is None:
            for case in CASES if geometry.groups <= LARGEST_FOR_CASES else ():
                rng = random.Random(f"{self.seed} {config} {case}")
                steps = [
                    *script.broken(rng, frames, geometry, case),
                    ("rates", 30, 40),
                    *script.broken(rng, frames, geometry, case),
                ]
                self._play(simulation, suite, case, steps, geometry, frames, self.seed)
            self._full_speed(simulation, suite, parameters, geometry, frames)
        self._summarise(suite, self.cases[first:])

    def _full_speed(self, simulation, suite, parameters, geometry, frames):
        steps = script.send([beat for frame in frames[:4] for beat in beats_of(frame, geometry)])
        case, observation = self._play(simulation, suite, "full speed", steps, geometry, frames, self.seed)
        starts = [clock for _, flags, clock in observation.segments[-1] if flags & RESULT_START]
        periods = sorted(b - a for a, b in zip(starts, starts[1:]))
        due = geometry.groups + parameters["gap_groups"]
        # At most two frames are inside: short ones wait until the one before the last has left.
        way = parameters["flush_groups"] + parameters["latency_clocks"]
        longest = due if way <= geometry.groups else due + way
        if not periods or periods[0] < due or periods[-1] > longest:
            case.problems.append(
                f"{periods} clocks a frame instead of {due if longest == due else f'{due} ... {longest}'}"
            )
            self.say(f"  FAIL {suite}: {case.problems[-1]}")
        else:
            self.say(f"  full speed: {periods[-1]} clocks a frame, the core takes {due}")

    def _summarise(self, suite, cases):
        total = {
            name: sum(getattr(case, name) for case in cases)
            for name in ("exact_frames", "broken_frames", "compared", "clocks", "seconds")
        }
        failed = sum(bool(case.problems) for case in cases)
        self.say(
            f"{suite}: {total['exact_frames']} frames exact, {total['broken_frames']} broken ones marked, {total['compared']} beats compared, "
            f"{failed} of {len(cases)} simulations failed; {total['clocks']} clocks in {total['seconds']:.1f} s"
        )

    def run_cocotb(self, runs):
        for number, (config, module, tests, generics, what) in enumerate(runs):
            suite = f"ghdl {config}{', ' + what if what else ''}"
            work = WORK / "ghdl" / config
            simulation = cocotb_runs.Ghdl(config, work, generics=generics, say=self.say)
            simulation.build()
            results = simulation.run(module, self.seed, self.out / f"cocotb_{number}", tests)
            for result in results:
                self._add(Case(suite, result.name, result.seconds, [] if result.passed else [f"see {result.message}"]))
            missing = set(tests or ()) - {result.name for result in results}
            for name in sorted(missing):
                self._add(Case(suite, name, problems=["did not run"]))
            failed = sum(not result.passed for result in results)
            self.say(
                f"{suite}: {module}, {len(results) - failed} of {len(results)} tests passed in {sum(r.seconds for r in results):.0f} s"
            )

    def report(self):
        """Writes report.json and junit.xml, prints the last line; returns the exit code."""
        failed = [case for case in self.cases if case.problems]
        verilator = [case for case in self.cases if case.suite.startswith("verilator")]
        summary = {
            "seed": self.seed,
            "simulations": len(self.cases),
            "failed": len(failed),
            "exact_frames": {
                suite: sum(c.exact_frames for c in verilator if c.suite == suite)
                for suite in {c.suite for c in verilator}
            },
            "broken_stream_cases": len(CASES),
            "cases": [asdict(case) for case in self.cases],
        }
        self.out.mkdir(parents=True, exist_ok=True)
        (self.out / "report.json").write_text(json.dumps(summary, indent=2) + "\n")
        self._write_junit()
        passed = not failed and self.cases
        hangs = sum(case.hangs for case in self.cases)
        self.say(
            f"{'PASS' if passed else 'FAIL'}: {sum(c.exact_frames for c in verilator)} random frames exact in Verilator, "
            f"{len(self.cases) - len(verilator)} tests in GHDL, {sum(len(c.problems) for c in failed)} mismatches, {hangs} hangs; "
            f"seed {self.seed}; {self.out / 'report.json'}"
        )
        return EXIT_OK if passed else EXIT_MISMATCH

    def _write_junit(self):
        suites = xml.Element("testsuites")
        for name in dict.fromkeys(case.suite for case in self.cases):
            cases = [case for case in self.cases if case.suite == name]
            suite = xml.SubElement(
                suites,
                "testsuite",
                name=name,
                tests=str(len(cases)),
                failures=str(sum(bool(c.problems) for c in cases)),
            )
            for case in cases:
                entry = xml.SubElement(suite, "testcase", classname=name, name=case.name, time=f"{case.seconds:.3f}")
                if case.problems:
                    xml.SubElement(entry, "failure", message=case.problems[0]).text = "\n".join(case.problems)
        xml.ElementTree(suites).write(self.out / "junit.xml", encoding="utf-8", xml_declaration=True)
