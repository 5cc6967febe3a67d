# SPDX-License-Identifier: Apache-2.0
"""What notices a fault in the VHDL: GHDL's analysis, proofs, co-simulation of the core, the tests of the shell."""

import random
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from ..base import ghdl, rtl
from ..base.configurations import configuration
from ..base.errors import FlowError
from ..base.tools import ROOT, Word, find_stereo_hls, run
from ..cosim import checker, vectors
from ..cosim.simulators import Ghdl
from ..shell import cocotb_runs, formal, pool
from ..shell.cocotb_runs import Selection
from ..shell.selections import SETTINGS, other_generics
from ..synthesis import manifest
from .mutants import Mutant

WORK = ROOT / "build" / "mutation"
WATCHDOG_SECONDS = 120
# (grey levels, distance between them, bubbles in percent, what comes) of the co-simulations of the core alone
TWO_FRAMES = ("--frames", 2)
CORE_RUNS = (
    (4, 85, 10, TWO_FRAMES),
    (4, 1, 20, TWO_FRAMES),
    (256, 1, 0, TWO_FRAMES),
    (2, 255, 50, TWO_FRAMES),
    (4, 85, 5, ("--broken", 40)),
)
CONFIG_OF_SHORT_FRAMES = "tiny_all_p4"  # shorter than their way through the core: a third frame has to wait


def shell_stages(config: str) -> tuple[list[Selection], list[Selection]]:
    """(those that notice most faults, those that take long)"""
    short = [
        Selection(config, "test_stereo_ip", ("full_speed", "stalls_30_30")),
        Selection(config, "test_registers"),
        Selection(config, "test_stereo_ip"),
    ]
    short_frames = Selection(CONFIG_OF_SHORT_FRAMES, "test_stereo_ip", ("stalls_0_10", "mixture"))
    return short, [*other_generics(config), short_frames, SETTINGS]


def core_stages(config: str) -> list[Selection]:
    """What the co-simulation of the core alone does not do: what the shell makes of breaks and resets."""
    return [
        other_generics(config).longer_flush._replace(tests=("full_speed",)),
        Selection(config, "test_stereo_ip", ("reset_at_any_clock", "gaps_of_all_lengths", "mixture")),
    ]


def compiles(files: Iterable[Path], folder: Path) -> bool:
    try:
        ghdl.analyse(files, folder, "compile.log")
    except FlowError:
        return False
    return True


def refuted(mutant: Mutant, folder: Path) -> str:
    """The proof that a mutant of the memory cell or of a stream block breaks."""
    for number, proof in enumerate(formal.PROOFS):
        if mutant.file.stem == proof.block:
            try:
                outcome, clock = formal.prove(proof, folder / f"proof_{number}", folder / "rtl")
            except FlowError:
                return f"proof {proof.name}: its synthesis fails"
            if outcome != "proved":
                return f"proof {proof.name}: clock {clock}"
    return ""


class _Cosimulation(NamedTuple):
    stimulus: Path
    clocks: int
    expected: list[vectors.Expected]


class Core:
    """Mutants of the core: co-simulation with the C++ core, then inside the shell."""

    def __init__(self, config: str) -> None:
        self.config, self.parameters = config, configuration(config)
        self.runs = [self._made(number, *row) for number, row in enumerate(CORE_RUNS)]

    def _made(self, number: int, levels: int, distance: int, stalls: int, what: tuple[str, int]) -> _Cosimulation:
        folder = WORK / f"vectors_{self.config}_{number}"
        folder.mkdir(parents=True, exist_ok=True)
        generator = random.Random(number)
        for side in ("left", "right"):
            pool.write_noise(folder / f"{side}.pgm", self.parameters, generator, levels, distance)
        command: list[Word] = [find_stereo_hls(), "vectors", "--config", self.config, "--left", folder / "left.pgm"]
        command += ["--right", folder / "right.pgm", *what, "--stall-percent", stalls, "--out", folder]
        run(command, passes_errors=True)
        stimulus = folder / "stimulus.txt"
        expected, _ = vectors.read_expected(folder / "expected.txt")
        return _Cosimulation(stimulus, len(vectors.read_stimulus(stimulus, rtl.kind_of(self.parameters))), expected)

    def noticed(self, core: list[Path], shell: list[Path], folder: Path) -> str:
        lanes, bits = self.parameters["pixels_per_clock"], self.parameters["disparity_bits"]
        simulator = Ghdl(self.config, core, folder / "core", lanes, bits, kind=rtl.kind_of(self.parameters))
        simulator.build()
        for number, (stimulus, clocks, expected) in enumerate(self.runs):
            observed_path = folder / "observed.txt"
            try:
                simulator.run(stimulus, observed_path, lambda clock: None, WATCHDOG_SECONDS)
                observed, simulated = vectors.read_observed(observed_path)
            except FlowError as error:
                return f"co-simulation {number}: {error}"
            verdict = checker.compare(expected, observed, bits)
            if not verdict.passed or simulated != clocks:
                return f"co-simulation {number}: {verdict.first_mismatch}"
        return ""


class Shell:
    """Mutants of the shell, and of the core where the core alone shows nothing: the cocotb tests."""

    def __init__(self, config: str, stages: list[Selection]) -> None:
        self.config, self.stages = config, stages
        self.pools = {stage.config: WORK / f"pool_{stage.config}" for stage in self.stages}
        for config, path in self.pools.items():
            pool.make_pool(config, configuration(config), cocotb_runs.PAIRS, 1, path)

    def noticed(self, core: list[Path], shell: list[Path], folder: Path) -> str:
        """`core`: the files of the configuration's core."""
        for number, (config, module, tests, generics, _) in enumerate(self.stages):
            cores = core if config == self.config else manifest.core_files(config)
            simulation = cocotb_runs.Ghdl(config, folder / "shell", [*cores, *shell], generics)
            simulation.build()
            try:
                results = simulation.run(
                    module,
                    1,
                    folder / f"stage_{number}",
                    tests,
                    watchdog_seconds=WATCHDOG_SECONDS,
                    pool_folder=self.pools[config],
                    stop_at_failure=True,
                )
            except FlowError as error:
                return f"{module}: {str(error).rpartition(' / ')[2]}"
            failed = [result.name for result in results if not result.passed]
            if failed:
                return f"{module}: {failed[0]}"
        return ""
