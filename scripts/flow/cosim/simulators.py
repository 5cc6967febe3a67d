# SPDX-License-Identifier: Apache-2.0
"""The ways to run the VHDL. Each reads a stimulus file and writes an observed file (see vectors.py)."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from ..base import builds, ghdl, nvc, rtl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Word, find_ghdl, find_verilator, run, run_with_progress, tool_version
from . import bench, coverage, vcd, waveform

BENCH = ROOT / "hls_tb" / "cosim"
# Components that Bambu writes in Verilog only.
READ_PORT, MULTIPLIER = BENCH / "bambu_read_port.vhd", BENCH / "bambu_multiplier.vhd"
VERILATOR_OPTIONS = ["--cc", "--exe", "--build", "-O3", "--x-assign", "fast", "--output-split", "20000", "-Wno-fatal"]
TOP = bench.VHDL.stem
Clocks = tuple[int, int]  # first and last


class Simulator:
    """Builds a simulation of some VHDL files once, in a folder of `root`, then runs it any number of times."""

    name = ""
    wave_suffixes: tuple[str, ...] = ()

    def __init__(
        self,
        config: str,
        vhdl_files: Iterable[Path],
        root: Path,
        pixels: int = 1,
        disparity_bits: int = 8,
        trace: bool = False,
        kind: rtl.Kind = rtl.CORE,
    ) -> None:
        self.config = config
        self.kind = kind
        self.ports = bench.Ports(kind, pixels, disparity_bits)
        self.pixels = pixels  # pairs a clock
        self.disparity_bits = disparity_bits  # of one pixel
        self.vhdl_files = list(vhdl_files)
        self.root = root
        self.trace = trace
        self._built: builds.Build | None = None

    @staticmethod
    def tools() -> dict[str, str]:
        """{name: version} of what it runs on."""
        raise NotImplementedError

    def _bench_files(self) -> list[Path]:
        raise NotImplementedError

    def _build(self, work: Path, vhdl_files: list[Path]) -> None:
        raise NotImplementedError

    def build(self) -> bool:
        """Whether it had to be built; not, where the same was built before."""
        makers = [*self._bench_files(), *bench.makers(), Path(__file__), Path(ghdl.__file__)]
        options = (self.config, self.kind.ports, self.pixels, self.disparity_bits, self.trace, self.tools())
        self._built = builds.build_once(self.root, self.vhdl_files, makers, options, self._build)
        return self._built.is_new

    @property
    def work(self) -> Path:
        """Its folder, once it is built."""
        assert self._built is not None
        return self._built.folder

    def _command(self, stimulus: Path, observed: Path, wave: Path | None, wave_clocks: Clocks) -> list[Word]:
        raise NotImplementedError

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
        observed.unlink(missing_ok=True)
        command = self._command(stimulus.resolve(), observed.resolve(), wave, wave_clocks)

        def on_line(line: str) -> None:
            if line.startswith("progress "):
                on_clock(int(line.split()[1]))

        seconds = run_with_progress(command, on_line, watchdog_seconds, cwd=self.work)
        if not observed.is_file():
            raise FlowError(f"{self.name} ended with exit code 0 but has simulated nothing", EXIT_TOOL_FAILED)
        return seconds


class OfVhdl(Simulator):
    """One that takes the VHDL as it is, with the bench in VHDL."""

    def _bench_files(self) -> list[Path]:
        return [bench.VHDL]

    def _build(self, work: Path, vhdl_files: list[Path]) -> None:
        self._elaborate(work, [*vhdl_files, self._bench(work)])

    def _bench(self, work: Path) -> Path:
        """The one for this configuration's design."""
        copy = work / bench.VHDL.name
        copy.write_text(self.ports.vhdl(self.config))
        return copy

    @staticmethod
    def _generics(stimulus: Path, observed: Path) -> list[str]:
        return ghdl.options_of({"stimulus_file": str(stimulus), "observed_file": str(observed)})

    def _elaborate(self, work: Path, files: Iterable[Path]) -> None:
        raise NotImplementedError


class Ghdl(OfVhdl):
    """The judge."""

    name = "ghdl"
    wave_suffixes = (".ghw", ".fst", ".vcd")

    @staticmethod
    def tools() -> dict[str, str]:
        return {"ghdl": ghdl.full_version()}

    def _elaborate(self, work: Path, files: Iterable[Path]) -> None:
        ghdl.analyse(files, work)
        ghdl.elaborate(work, TOP)

    def _command(self, stimulus: Path, observed: Path, wave: Path | None, wave_clocks: Clocks) -> list[Word]:
        command: list[Word] = [find_ghdl(), "-r", ghdl.STANDARD, TOP, *self._generics(stimulus, observed)]
        if wave is not None:
            # GHDL always dumps from the start; the stop time bounds the end.
            option = {".ghw": "--wave", ".fst": "--fst", ".vcd": "--vcd"}[wave.suffix]
            command += [f"{option}={wave}", f"--stop-time={waveform.start_ns(wave_clocks[1] + 1)}ns"]
        return command

    def run(
        self,
        stimulus: Path,
        observed: Path,
        on_clock: Callable[[int], object],
        watchdog_seconds: float,
        wave: Path | None = None,
        wave_clocks: Clocks = (0, 0),
    ) -> float:
        """A .vcd has the clocks that were asked for: GHDL writes all into a pipe, and they are cut out at its other
        end."""
        if wave is None or wave.suffix != ".vcd":
            return super().run(stimulus, observed, on_clock, watchdog_seconds, wave, wave_clocks)
        folder = tempfile.TemporaryDirectory()
        pipe = Path(folder.name) / "wave.vcd"
        os.mkfifo(pipe)
        # Opened for both directions, so that neither end waits for the other to open it.
        keeper = os.open(pipe, os.O_RDWR)
        cutter = threading.Thread(target=_cut, args=(pipe, wave, *map(waveform.start_ns, wave_clocks)))
        cutter.start()
        try:
            return super().run(stimulus, observed, on_clock, watchdog_seconds, pipe, wave_clocks)
        finally:
            os.close(keeper)
            cutter.join()
            folder.cleanup()


def _cut(pipe: Path, path: Path, first_ns: int, last_ns: int) -> None:
    with pipe.open(encoding="ascii") as lines, path.open("w", encoding="ascii") as result:
        vcd.cut(lines, result.write, first_ns, last_ns)


class Nvc(OfVhdl):
    """A second VHDL simulator, written by others: what both take as one means the same to both."""

    name = "nvc"
    wave_suffixes = (".fst",)

    @staticmethod
    def tools() -> dict[str, str]:
        return {"nvc": nvc.version()}

    def _elaborate(self, work: Path, files: Iterable[Path]) -> None:
        """Analyses only: it elaborates with the generics, which name the files of a run."""
        run([*nvc.start(), "-a", *files], cwd=work, log=work / "analyse.log")

    def _command(self, stimulus: Path, observed: Path, wave: Path | None, wave_clocks: Clocks) -> list[Word]:
        elaborate = ["-e", "--jit", "--no-save", *self._generics(stimulus, observed), TOP]
        command: list[Word] = [*nvc.start(), *elaborate, "-r"]
        if wave is not None:
            command += [f"--wave={wave}", f"--stop-time={waveform.start_ns(wave_clocks[1] + 1)}ns"]
        return [*command, TOP]


class Original(Ghdl):
    """Bambu's own VHDL with its component library in GHDL, to prove the lowering. Needs a run of synthesize.py on this
    machine; `vhdl_files` are the tool's files, memory images included. Of matching cores only."""

    name = "original"

    def _bench_files(self) -> list[Path]:
        return [READ_PORT, MULTIPLIER, bench.ORIGINAL, *super()._bench_files()]

    def _build(self, work: Path, vhdl_files: list[Path]) -> None:
        library = work / "library"
        library.mkdir()
        sources: list[Path] = []
        for path in vhdl_files:
            if path.suffix == ".mem":
                shutil.copy(path, work)
            elif path.name == f"{rtl.CORE.function}.vhd":
                sources.insert(0, path)
            else:
                # Each component file brings the same package; one copy, in the design itself, is enough.
                copy = library / path.name.replace("\\", "")
                copy.write_text(path.read_text().rpartition("end package body;")[2])
                sources.append(copy)
        template = READ_PORT.read_text()
        for port in [port.name for port in self.kind.ports if port.direction == "in"]:
            copy = library / f"{port}.vhd"
            copy.write_text(template.replace("PORT", port))
            sources.append(copy)
        sources.append(MULTIPLIER)
        log = work / "library.log"
        run([find_ghdl(), "-a", ghdl.STANDARD, "--work=bambu", *sources], cwd=work, log=log)
        original = work / "bambu_original.vhd"
        original.write_text(self._original_text())
        self._elaborate(work, [original, self._bench(work)])

    def _original_text(self) -> str:
        """The tool's design for this configuration's core, with the ports of its settings."""
        text = bench.ORIGINAL.read_text().replace(rtl.core_entity("NAME"), rtl.core_entity(self.config))
        settings = [port.name for port in self.kind.ports if port.bits is not None]
        declared = "".join(f"    {name} : in std_logic_vector;\n" for name in settings)
        joined = "".join(f"      {name} => {name},\n" for name in settings)
        pixels = next(self.ports.bits(port) for port in self.kind.ports if port.name == "left_pixel")
        text = text.replace("PIXELS", str(max(8, 1 << (pixels - 1).bit_length())))
        return text.replace("    -- ports of settings\n", declared).replace("      -- settings\n", joined)


class Verilator(Simulator):
    """The same VHDL through `ghdl --synth`, for whole frames."""

    name = "verilator"
    wave_suffixes = (".fst",)

    def _bench_files(self) -> list[Path]:
        return [bench.CPP]

    @staticmethod
    def tools() -> dict[str, str]:
        return {"ghdl": ghdl.full_version(), "verilator": tool_version(find_verilator())}

    def _build(self, work: Path, vhdl_files: list[Path]) -> None:
        options = ["--trace-fst"] if self.trace else []
        (work / bench.CPP_PORTS).write_text(self.ports.cpp())
        options += ["-CFLAGS", "-I.."]  # from the model's folder on: verilate
        verilate(work, vhdl_files, self.kind.entity(self.config), self._bench_files(), options)

    def _command(self, stimulus: Path, observed: Path, wave: Path | None, wave_clocks: Clocks) -> list[Word]:
        dump: list[Word] = [] if wave is None else [wave, *wave_clocks]
        return [verilated_bench(self.work), stimulus, observed, *dump]


class Covered(Verilator):
    """The same, counting what it moves."""

    def _build(self, work: Path, vhdl_files: list[Path]) -> None:
        top = self.kind.entity(self.config)
        (work / bench.CPP_PORTS).write_text(self.ports.cpp())
        options = ["--coverage-toggle", "-CFLAGS", "-I.."]
        verilate(work, vhdl_files, top, self._bench_files(), options, lambda verilog: coverage.marked(verilog, top))

    @property
    def verilog(self) -> Path:
        return self.work / f"{self.kind.entity(self.config)}.v"


def verilate(
    work: Path,
    vhdl_files: Iterable[Path],
    top: str,
    bench_files: Sequence[Path],
    options: Sequence[str] = (),
    edited: Callable[[str], str] = str,
) -> None:
    """Compiles a design and its C++ bench, which knows it as Vdesign, to the program verilated_bench(work). All that
    make sees stands in a folder without blanks: it refuses them."""
    verilator = find_verilator()
    source = work / f"{top}.v"
    source.write_text(edited(ghdl.to_verilog(vhdl_files, work, top)))
    command: list[Word] = [verilator, *VERILATOR_OPTIONS, "-j", os.cpu_count() or 1, *options]
    # What runs once is not worth optimising. Verilator's own part and the bench are the same in each simulation.
    settings = "OPT_FAST=-O2 OPT_SLOW=-O0 OPT_GLOBAL=-O2" + (" OBJCACHE=ccache" if shutil.which("ccache") else "")
    command += ["-CFLAGS", "-std=c++20", "-MAKEFLAGS", settings]
    command += ["--top-module", top, "--prefix", "Vdesign", "-o", "bench"]
    with _without_blanks(work) as folder:
        for path in bench_files:
            if path.parent != folder:
                shutil.copy(path, folder)
        files = [folder / path.name for path in [source, *bench_files]]
        run([*command, "--Mdir", folder / "model", *files], cwd=folder, log=work / "verilator.log")


@contextmanager
def _without_blanks(work: Path) -> Iterator[Path]:
    """The folder, or one elsewhere with what stands in it, whose `model` becomes its own."""
    if not any(sign.isspace() for sign in str(work)):
        yield work
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path in work.iterdir():
            if path.is_file():
                shutil.copy(path, folder)
        yield folder
        shutil.copytree(folder / "model", work / "model", dirs_exist_ok=True)


def verilated_bench(work: Path) -> Path:
    return work / "model" / "bench"


SIMULATORS: dict[str, type[Simulator]] = {simulator.name: simulator for simulator in (Ghdl, Verilator, Nvc, Original)}
