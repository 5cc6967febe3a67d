# SPDX-License-Identifier: Apache-2.0
"""What notices a fault in the VHDL: GHDL's analysis, proofs, co-simulation of the core, the tests of the shell."""

from collections.abc import Iterable
from pathlib import Path

from ..base import ghdl, rtl
from ..base.configurations import configuration, designs
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
CONFIG_OF_SHORT_FRAMES = "tiny_all_p4"  # shorter than their way through the core: a third frame has to wait


def shell_stages(config: str) -> tuple[list[Selection], list[Selection]]:
    """(those that notice most faults, those that take long)"""
    short = [
        Selection(config, "test_stereo_ip", ("full_speed", "stalls_30_30")),
        Selection(config, "test_registers"),
        Selection(config, "test_resets"),
        Selection(config, "test_stereo_ip"),
    ]
    short_frames = Selection(CONFIG_OF_SHORT_FRAMES, "test_stereo_ip", ("stalls_0_10", "mixture"))
    return short, [*other_generics(config), short_frames, SETTINGS]


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


class Core:
    """Mutants of the core: what cosim.py sends by default."""

    def __init__(self, config: str) -> None:
        self.config, self.parameters = config, configuration(config, designs())
        self.kind, self.lanes = rtl.kind_of(self.parameters), self.parameters["pixels_per_clock"]
        self.bits, self.entity = vectors.row_bits(self.parameters), self.kind.entity(config)
        self.stimulus, self.expected = self.stream()
        self.clocks = len(vectors.read_stimulus(self.stimulus, self.kind))

    def stream(self, seed: int = 1) -> tuple[Path, list[vectors.Expected]]:
        """(the stress stream of a seed, what the core must answer)"""
        folder = WORK / f"vectors_{self.config}_{seed}"
        command: list[Word] = [
            find_stereo_hls(),
            "vectors",
            "--config",
            self.config,
            "--stress",
            "--seed",
            seed,
            "--out",
            folder,
        ]
        run(command, passes_errors=True)
        return folder / "stimulus.txt", vectors.read_expected(folder / "expected.txt")[0]

    def noticed(self, core: list[Path], shell: list[Path], folder: Path) -> str:
        simulator = Ghdl(self.config, core, folder / "core", self.lanes, self.bits, kind=self.kind)
        simulator.build()
        observed_path = folder / "observed.txt"
        try:
            simulator.run(self.stimulus, observed_path, lambda clock: None, WATCHDOG_SECONDS)
            observed, simulated = vectors.read_observed(observed_path)
        except FlowError as error:
            return f"co-simulation: {error}"
        verdict = checker.compare(self.expected, observed, self.bits)
        return "" if verdict.passed and simulated == self.clocks else f"co-simulation: {verdict.first_mismatch}"


class Shell:
    """Mutants of the shell: the cocotb tests."""

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
