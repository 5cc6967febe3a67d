# SPDX-License-Identifier: Apache-2.0
"""A core between the files of a co-simulation (see vectors.py): any simulator for which there is a bench reads a
stimulus file and writes an observed file."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from ..base import ghdl, rtl
from ..base.tools import ROOT, Word, find_ghdl, run
from ..simulation import simulators
from ..simulation.simulation import Simulation
from ..simulation.simulators import Design
from . import bench, coverage, vcd, waveform

BENCH = ROOT / "hls_tb" / "cosim"
# Components that Bambu writes in Verilog only.
READ_PORT, MULTIPLIER = BENCH / "bambu_read_port.vhd", BENCH / "bambu_multiplier.vhd"
TOP = bench.VHDL.stem
LIBRARY = "library"  # folder of what is Bambu's
Clocks = tuple[int, int]  # first and last


class Original(simulators.Ghdl):
    """Bambu's own VHDL with its component library in GHDL, to prove the lowering. Needs a run of synthesize.py on this
    machine; the files are the tool's, memory images included. Of matching cores only."""

    name = "original"

    def build(self, work: Path, design: Design) -> None:
        own = simulators.written(work, design.texts)
        ports = [path for path in own if path.parent.name == LIBRARY]
        sources: list[Path] = []
        for path in design.files:
            if path.suffix == ".mem":
                shutil.copy(path, work)
            elif path.name == f"{rtl.CORE.function}.vhd":
                sources.insert(0, path)
            else:
                # Each component file brings the same package; one copy, in the design itself, is enough.
                copy = work / LIBRARY / path.name.replace("\\", "")
                copy.write_text(path.read_text().rpartition("end package body;")[2])
                sources.append(copy)
        sources += [*ports, MULTIPLIER]
        log = work / "library.log"
        run([find_ghdl(), "-a", ghdl.STANDARD, "--work=bambu", *sources], cwd=work, log=log)
        ghdl.analyse([path for path in own if path not in ports], work)
        ghdl.elaborate(work, design.top)

    @staticmethod
    def texts(ports: bench.Ports, config: str) -> dict[str, str]:
        """What stands beside the tool's files and around them."""
        inputs = [port.name for port in ports.kind.ports if port.direction == "in"]
        template = READ_PORT.read_text()
        made = {f"{LIBRARY}/{name}.vhd": template.replace("PORT", name) for name in inputs}
        return {**made, bench.ORIGINAL.name: Original._wrapper(ports, config)}

    @staticmethod
    def _wrapper(ports: bench.Ports, config: str) -> str:
        """The tool's design for this configuration's core, with the ports of its settings."""
        text = bench.ORIGINAL.read_text().replace(rtl.core_entity("NAME"), rtl.core_entity(config))
        settings = [port.name for port in ports.kind.ports if port.bits is not None]
        declared = "".join(f"    {name} : in std_logic_vector;\n" for name in settings)
        joined = "".join(f"      {name} => {name},\n" for name in settings)
        pixels = next(ports.bits(port) for port in ports.kind.ports if port.name == "left_pixel")
        text = text.replace("PIXELS", str(max(8, 1 << (pixels - 1).bit_length())))
        return text.replace("    -- ports of settings\n", declared).replace("      -- settings\n", joined)


class Covered(simulators.Verilator):
    """One that counts what it moves."""

    def edited(self, verilog: str, top: str) -> str:
        return coverage.marked(verilog, top)


SIMULATORS: dict[str, simulators.Simulator] = {
    simulator.name: simulator for simulator in (*simulators.of_benches_in("vhdl", "c++"), Original())
}
# Those whose waveforms show a mismatch as it is: of others GHDL runs the VHDL again.
IN_GHDL = {name for name, simulator in SIMULATORS.items() if isinstance(simulator, simulators.Ghdl)}


class CoreSimulation(Simulation):
    """Some VHDL files in one of them, under the bench for their ports."""

    def __init__(
        self,
        simulator: simulators.Simulator,
        config: str,
        vhdl_files: Iterable[Path],
        root: Path,
        pixels: int = 1,  # pairs a clock
        disparity_bits: int = 8,  # of one pixel
        trace: bool = False,
        kind: rtl.Kind = rtl.CORE,
    ) -> None:
        self.config, self.kind, self.vhdl_files = config, kind, list(vhdl_files)
        self.pixels, self.disparity_bits = pixels, disparity_bits
        super().__init__(simulator, self._design(simulator, trace), root)

    def _design(self, simulator: simulators.Simulator, trace: bool) -> Design:
        ports = bench.Ports(self.kind, self.pixels, self.disparity_bits)
        options = simulator.trace_options if trace else ()
        if simulator.bench == "c++":
            counted = ("--coverage-toggle",) if isinstance(simulator, Covered) else ()
            return Design(
                self.kind.entity(self.config), self.vhdl_files, [bench.CPP], ports.cpp(), [*options, *counted]
            )
        texts = {bench.VHDL.name: ports.vhdl(self.config)}
        if not isinstance(simulator, Original):
            return Design(TOP, self.vhdl_files, texts=texts, options=options)
        return Design(TOP, self.vhdl_files, [MULTIPLIER], {**Original.texts(ports, self.config), **texts}, options)

    def run(
        self,
        stimulus: Path,
        observed: Path,
        on_clock: Callable[[int], object],
        watchdog_seconds: float,
        wave: Path | None = None,
        wave_clocks: Clocks = (0, 0),
    ) -> float:
        """Simulates the whole stimulus; returns the seconds it took. `wave_clocks`: what to dump."""

        def on_line(line: str) -> None:
            if line.startswith("progress "):
                on_clock(int(line.split()[1]))

        observed = observed.resolve()
        given = {"stimulus_file": stimulus.resolve(), "observed_file": observed}
        with self._wave_options(wave, wave_clocks) as options:
            return self.run_bench(given, watchdog_seconds, on_line, options, observed)

    @contextmanager
    def _wave_options(self, wave: Path | None, clocks: Clocks) -> Iterator[Sequence[Word]]:
        """A .vcd of GHDL has the clocks that were asked for: GHDL writes all into a pipe, and they are cut out at its
        other end."""
        if wave is None:
            yield []
            return
        if self.simulator.bench == "c++":
            yield [wave, *clocks]
            return
        stop_ns = waveform.start_ns(clocks[1] + 1)
        if wave.suffix != ".vcd":
            yield self.simulator.wave_options(wave, stop_ns)
            return
        with tempfile.TemporaryDirectory() as folder:
            pipe = Path(folder) / "wave.vcd"
            os.mkfifo(pipe)
            # Opened for both directions, so that neither end waits for the other to open it.
            keeper = os.open(pipe, os.O_RDWR)
            cutter = threading.Thread(target=_cut, args=(pipe, wave, *map(waveform.start_ns, clocks)))
            cutter.start()
            try:
                yield self.simulator.wave_options(pipe, stop_ns)
            finally:
                os.close(keeper)
                cutter.join()


def _cut(pipe: Path, path: Path, first_ns: int, last_ns: int) -> None:
    with pipe.open(encoding="ascii") as lines, path.open("w", encoding="ascii") as result:
        vcd.cut(lines, result.write, first_ns, last_ns)


Ghdl = partial(CoreSimulation, SIMULATORS["ghdl"])
