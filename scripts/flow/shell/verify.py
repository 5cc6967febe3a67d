# SPDX-License-Identifier: Apache-2.0
"""The whole verification of stereo_ip: many random frames in Verilator, all scenarios under cocotb in GHDL."""

from __future__ import annotations

import json
import random
import time
import xml.etree.ElementTree as xml
from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from ..base import files, places, rtl
from ..base.configurations import Parameters, clocks_per_pixel, configuration
from ..base.errors import EXIT_MISMATCH, EXIT_OK
from ..base.tools import ROOT, Say
from . import cocotb_runs, script
from .broken import CASES, beats_of
from .cocotb_runs import Selection
from .contract import RESULT_START
from .judge import judge
from .pool import Frame, Geometry, make_pool, pairs_for
from .script import Step
from .selections import GAPS, SETTINGS, other_generics
from .verilated import Observation, Verilated

WORK = ROOT / "build" / "axi"
RESULTS = ("report.json", "junit.xml")
CHUNK_FRAMES = 50  # correct frames of one simulation
# Some of them without stalls. With options: left reference and checks; a gap between frames; frames that are shorter
# than their way through the core, in beats of more than 64 bits.
FRAMES = {
    "tiny": 600,
    "tiny_p2": 450,
    "tiny_p4": 450,
    "tiny_all_left_p2": 150,
    "tiny_all_recursive": 150,
    "tiny_all_p4": 150,
    "tiny_dense_p2": 150,
    "tiny_f2_lr": 150,
    "tiny_f3_census": 150,
    "ambrosch2007": 26,
    # each frame with its own settings
    "tiny_settings": 200,
    "tiny_settings_full": 200,
    "tiny_sgm_settings": 200,
    "tiny_sgm_settings_full": 200,
    "tiny_settings_all": 200,
    "tiny_trellis_settings": 200,
    "tiny_phase_settings": 200,
    # and its own size
    "tiny_size": 256,
    "tiny_size_all": 256,
    "tiny_size_census_p2": 256,
    "tiny_size_recursive": 256,
    "tiny_size_full": 256,
    "tiny_size_full_all": 256,
    "tiny_sgm_size": 256,
    "tiny_sgm_size_all": 256,
    "tiny_sgm_size_full": 256,
    "tiny_trellis_size": 256,
    "tiny_phase_size": 256,
    "tiny_phase_size_all": 256,
}
LARGEST_FOR_CASES = 10000  # groups of a frame: larger ones meet the broken streams in the mixture only
SHORT_FRAMES = {
    "tiny": 60,
    "tiny_p2": 20,
    "tiny_p4": 20,
    "tiny_all_recursive": 20,
    "tiny_all_p4": 20,
    "tiny_dense": 20,
    "tiny_f4_all": 20,
    "tiny_settings_all": 200,
    "tiny_size_all": 256,
}
_LANES = ("full_speed", "sink_waits_then_takes_all", "mixture", "reset_at_any_clock")
_SHORT_STREAMS = (
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
)


def selections(is_short: bool) -> tuple[Selection, ...]:
    """The runs under cocotb."""
    other = other_generics("tiny")
    if is_short:
        return (
            Selection("tiny", "test_stereo_ip", _SHORT_STREAMS),
            Selection("tiny", "test_registers"),
            Selection("tiny", "test_resets"),
            Selection("tiny_p4", "test_stereo_ip", _LANES),
            other.longer_flush,
            other.short_latency,
            other.disabled,
            SETTINGS,
        )
    return (
        Selection("tiny", "test_stereo_ip"),
        Selection("tiny", "test_registers"),
        Selection("tiny", "test_resets"),
        Selection("tiny_p2", "test_stereo_ip", _LANES),
        Selection("tiny_p2", "test_registers"),
        Selection("tiny_p2", "test_resets"),
        Selection("tiny_p4", "test_stereo_ip", _LANES),
        Selection("tiny_p4", "test_registers"),
        Selection("tiny_p4", "test_resets"),
        Selection("tiny_all_recursive", "test_stereo_ip", (*GAPS, "reset_at_any_clock")),
        *other,
        SETTINGS,
    )


@dataclass
class Case:
    suite: str
    name: str
    seconds: float = 0.0
    problems: list[str] = field(default_factory=list)
    exact_frames: int = 0
    broken_frames: int = 0
    compared: int = 0
    clocks: int = 0
    hangs: bool = False


def chunks_of(frames: int) -> range:
    """Numbers of the simulations that share so many frames."""
    return range((frames + CHUNK_FRAMES - 1) // CHUNK_FRAMES)


class Verification:
    def __init__(self, seed: int, out: Path, say: Say = print) -> None:
        self.seed, self.out, self.say = seed, out, say
        self.cases: list[Case] = []
        places.results_folder(out, RESULTS)
        for name in RESULTS:  # a run that breaks off leaves no result of an earlier one
            (out / name).unlink(missing_ok=True)

    def add(self, case: Case) -> None:
        self.cases.append(case)
        for problem in case.problems[:5]:
            self.say(f"  FAIL {case.suite} {case.name}: {problem}")

    # --- Verilator ----------------------------------------------------------------------------------------------------

    def run_verilator(self, config: str, count: int, only_chunk: int | None = None) -> None:
        """`count` correct frames with everything that can stand between them, all broken streams, and the full
        speed."""
        parameters = configuration(config)
        if rtl.settings_of(parameters):
            self._run_settings(config, count)
            return
        geometry = Geometry.of(parameters)
        suite = f"verilator {config}"
        frames = make_pool(config, parameters, 6, self.seed, self.out / suite / "pool")
        simulation = Verilated(config, WORK / "verilator" / config)
        self.say(f"{suite}: building ...")
        simulation.build()
        player = _Player(self, simulation, suite, geometry, frames)
        first = len(self.cases)
        for chunk in chunks_of(count):
            if only_chunk in (None, chunk):
                rng = random.Random(f"{self.seed} {config} {chunk}")
                steps = script.mixture(rng, frames, geometry, min(CHUNK_FRAMES, count - chunk * CHUNK_FRAMES))
                player.play(f"mixture {chunk}", steps, self.seed * 1000 + chunk)
        if only_chunk is None:
            for name in CASES if geometry.groups <= LARGEST_FOR_CASES else ():
                rng = random.Random(f"{self.seed} {config} {name}")
                before = script.broken(rng, frames, geometry, name)
                player.play(name, [*before, ("rates", 30, 40), *script.broken(rng, frames, geometry, name)], self.seed)
            self._full_speed(player, parameters)
        self._summarise(suite, self.cases[first:])

    def _run_settings(self, config: str, count: int) -> None:
        """`count` frames, each with settings that were written during the one before it."""
        parameters = configuration(config)
        geometry = Geometry.of(parameters)
        suite = f"verilator {config}"
        frames = make_pool(config, parameters, pairs_for(parameters, count), self.seed, self.out / suite / "pool")
        random.Random(f"{self.seed} order").shuffle(frames)
        simulation = Verilated(config, WORK / "verilator" / config)
        self.say(f"{suite}: building ...")
        simulation.build()
        player = _Player(self, simulation, suite, geometry, frames)
        first = len(self.cases)
        steps = script.changed_settings(
            random.Random(f"{self.seed} {config}"), frames, geometry, rtl.settings_of(parameters)
        )
        player.play("settings", steps, self.seed)
        of_a_frame = [setting for setting in rtl.settings_of(parameters) if not setting.held]
        if frames[0].geometry and not any(setting.largest for setting in of_a_frame):
            self._broken_smaller_frames(player, parameters)
        self._summarise(suite, self.cases[first:])

    def _broken_smaller_frames(self, player: _Player, parameters: Parameters) -> None:
        """All broken streams at the size, below the largest, of which there are the most frames."""
        sizes = Counter(frame.geometry for frame in player.frames if frame.geometry != player.geometry)
        geometry = sizes.most_common(1)[0][0]
        assert geometry is not None
        same = [replace(frame, geometry=None) for frame in player.frames if frame.geometry == geometry]
        smaller = replace(player, geometry=geometry, frames=same)
        before = script.with_size(geometry, parameters["pixels_per_clock"])
        for name in CASES:
            rng = random.Random(f"{self.seed} {player.suite} {name}")
            smaller.play(f"smaller {name}", [*before, *script.broken(rng, same, geometry, name, 3)], self.seed)

    def _full_speed(self, player: _Player, parameters: Parameters) -> None:
        geometry = player.geometry
        steps = script.send([beat for frame in player.frames[:4] for beat in beats_of(frame, geometry)])
        case, observation = player.play("full speed", steps, self.seed)
        starts = [clock for _, flags, clock in observation.segments[-1] if flags & RESULT_START]
        periods = sorted(b - a for a, b in zip(starts, starts[1:]))
        pace = clocks_per_pixel(parameters)
        due = pace * (geometry.groups + parameters["gap_groups"])
        # At most two frames are inside: short ones wait until the one before the last has left.
        way = pace * parameters["flush_groups"] + parameters["latency_clocks"]
        longest = due if way <= pace * geometry.groups else due + way
        if not periods or periods[0] < due or periods[-1] > longest:
            expected = f"{due}" if longest == due else f"{due} ... {longest}"
            case.problems.append(f"{periods} clocks a frame instead of {expected}")
            self.say(f"  FAIL {player.suite}: {case.problems[-1]}")
        else:
            self.say(f"  full speed: {periods[-1]} clocks a frame, the core takes {due}")

    def _summarise(self, suite: str, cases: list[Case]) -> None:
        exact, broken = sum(case.exact_frames for case in cases), sum(case.broken_frames for case in cases)
        compared, clocks = sum(case.compared for case in cases), sum(case.clocks for case in cases)
        failed, seconds = sum(bool(case.problems) for case in cases), sum(case.seconds for case in cases)
        self.say(
            f"{suite}: {exact} frames exact, {broken} broken ones marked, {compared} beats compared, "
            f"{failed} of {len(cases)} simulations failed; {clocks} clocks in {seconds:.1f} s"
        )

    # --- cocotb -------------------------------------------------------------------------------------------------------

    def run_cocotb(self, runs: Iterable[Selection]) -> None:
        for number, chosen in enumerate(runs):
            suite = f"ghdl {chosen.config}{', ' + chosen.what if chosen.what else ''}"
            simulation = cocotb_runs.Ghdl(chosen.config, WORK / "ghdl", generics=chosen.generics, say=self.say)
            simulation.build()
            results = simulation.run(chosen.module, self.seed, self.out / f"cocotb_{number}", chosen.tests)
            for result in results:
                self.add(Case(suite, result.name, result.seconds, [] if result.passed else [f"see {result.message}"]))
            missing = set(chosen.tests or ()) - {result.name for result in results}
            for name in sorted(missing):
                self.add(Case(suite, name, problems=["did not run"]))
            passed, seconds = sum(result.passed for result in results), sum(result.seconds for result in results)
            self.say(f"{suite}: {chosen.module}, {passed} of {len(results)} tests passed in {seconds:.0f} s")

    # --- report -------------------------------------------------------------------------------------------------------

    def report(self) -> int:
        """Writes report.json and junit.xml, prints the last line; returns the exit code."""
        failed = [case for case in self.cases if case.problems]
        verilator = [case for case in self.cases if case.suite.startswith("verilator")]
        suites = {case.suite for case in verilator}
        summary = {
            "seed": self.seed,
            "simulations": len(self.cases),
            "failed": len(failed),
            "exact_frames": {suite: sum(c.exact_frames for c in verilator if c.suite == suite) for suite in suites},
            "broken_stream_cases": len(CASES),
            "cases": [asdict(case) for case in self.cases],
        }
        files.write(self.out / "report.json", json.dumps(summary, indent=2) + "\n")
        self._write_junit()
        passed = not failed and self.cases
        hangs = sum(case.hangs for case in self.cases)
        self.say(
            f"{'PASS' if passed else 'FAIL'}: "
            f"{sum(case.exact_frames for case in verilator)} random frames exact in Verilator, "
            f"{len(self.cases) - len(verilator)} tests in GHDL, "
            f"{sum(len(case.problems) for case in failed)} mismatches, {hangs} hangs; "
            f"seed {self.seed}; {self.out / 'report.json'}"
        )
        return EXIT_OK if passed else EXIT_MISMATCH

    def _write_junit(self) -> None:
        suites = xml.Element("testsuites")
        for name in dict.fromkeys(case.suite for case in self.cases):
            cases = [case for case in self.cases if case.suite == name]
            failures = str(sum(bool(case.problems) for case in cases))
            suite = xml.SubElement(suites, "testsuite", name=name, tests=str(len(cases)), failures=failures)
            for case in cases:
                entry = xml.SubElement(suite, "testcase", classname=name, name=case.name, time=f"{case.seconds:.3f}")
                if case.problems:
                    xml.SubElement(entry, "failure", message=case.problems[0]).text = "\n".join(case.problems)
        files.write(self.out / "junit.xml", xml.tostring(suites, encoding="utf-8", xml_declaration=True))


@dataclass(frozen=True)
class _Player:
    """Plays steps in one simulation and keeps the verdicts as cases of one suite."""

    verification: Verification
    simulation: Verilated
    suite: str
    geometry: Geometry
    frames: list[Frame]

    def play(self, name: str, steps: list[Step], seed: int) -> tuple[Case, Observation]:
        started = time.monotonic()
        folder = self.verification.out / self.suite / name.replace(" ", "_")
        observation = self.simulation.play([*steps, ("drain",)], seed, folder)
        verdict = judge(steps, observation, self.geometry, self.frames)
        case = Case(
            self.suite,
            name,
            time.monotonic() - started,
            verdict.problems,
            verdict.exact_frames,
            verdict.broken_frames,
            verdict.compared,
            observation.clocks,
            observation.hangs,
        )
        self.verification.add(case)
        return case, observation
