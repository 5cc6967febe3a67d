# SPDX-License-Identifier: Apache-2.0
"""The programs that run VHDL, each a class and a row of SIMULATORS. A bench in VHDL or Verilog is a part of what they
build; Verilator's is in C++."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from ..base import ghdl, nvc
from ..base.tools import Word, find_ghdl, find_tool, find_verilator, run, tool_version
from ..synthesis.presentation import scalars

OPTIMISATION = "STEREO_MODEL_OPTIMISATION"  # of a model's C++; the model does the same with any
VERILATOR_OPTIONS = ["--cc", "--exe", "--build", "-O3", "--x-assign", "fast", "--output-split", "20000", "-Wno-fatal"]


@dataclass(frozen=True)
class Design:
    """What is built: VHDL with a bench around it."""

    top: str  # of the bench where that is in VHDL, else of the VHDL
    files: Sequence[Path]  # VHDL in compile order
    bench_files: Sequence[Path] = ()  # in another language; objects of a C++ bench, too
    texts: Mapping[str, str] = field(
        default_factory=dict
    )  # {name: file that is written for it}; VHDL behind the others
    options: Sequence[str] = ()  # of the build


class Simulator:
    """Builds a design in a folder; says the command that runs it there."""

    name = ""
    bench = "vhdl"  # the language of its benches
    wave_suffixes: tuple[str, ...] = ()
    trace_options: tuple[str, ...] = ()  # of the build, for one that can write waveforms

    @staticmethod
    def tools() -> dict[str, str]:
        """{name: version} of what it runs on."""
        raise NotImplementedError

    def build(self, work: Path, design: Design) -> None:
        raise NotImplementedError

    def command(self, work: Path, top: str, given: Mapping[str, Word], options: Sequence[Word] = ()) -> list[Word]:
        """`given`: what the bench is told, generics of a bench in VHDL."""
        raise NotImplementedError

    def wave_options(self, path: Path, stop_ns: int) -> list[Word]:
        """Of a run with a bench in VHDL."""
        raise NotImplementedError


def _generics(given: Mapping[str, Word]) -> list[str]:
    return ghdl.options_of({name: str(value) for name, value in given.items()})


def written(work: Path, texts: Mapping[str, str]) -> list[Path]:
    """The files that are written for a design."""
    paths = [work / name for name in texts]
    for path, text in zip(paths, texts.values()):
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    return paths


class Ghdl(Simulator):
    """The judge. `elaborates`: at once, so that a part that is nowhere is an error of the build."""

    name = "ghdl"
    wave_suffixes = (".ghw", ".fst", ".vcd")

    def __init__(self, elaborates: bool = True) -> None:
        self.elaborates = elaborates

    @staticmethod
    def tools() -> dict[str, str]:
        return {"ghdl": ghdl.full_version()}

    def build(self, work: Path, design: Design) -> None:
        ghdl.analyse([*design.files, *written(work, design.texts)], work)
        if self.elaborates:
            ghdl.elaborate(work, design.top)

    def command(self, work: Path, top: str, given: Mapping[str, Word], options: Sequence[Word] = ()) -> list[Word]:
        return [find_ghdl(), "-r", ghdl.STANDARD, top, *_generics(given), *options]

    def wave_options(self, path: Path, stop_ns: int) -> list[Word]:
        """GHDL always dumps from the start; the stop time bounds the end."""
        option = {".ghw": "--wave", ".fst": "--fst", ".vcd": "--vcd"}[path.suffix]
        return [f"{option}={path}", f"--stop-time={stop_ns}ns"]


class Nvc(Simulator):
    """A second VHDL simulator, written by others: what both take as one means the same to both."""

    name = "nvc"
    wave_suffixes = (".fst",)

    @staticmethod
    def tools() -> dict[str, str]:
        return {"nvc": nvc.version()}

    def build(self, work: Path, design: Design) -> None:
        """Analyses only: it elaborates with the generics, which name the files of a run."""
        files = [*design.files, *written(work, design.texts)]
        run([*nvc.start(), "-a", *files], cwd=work, log=work / "analyse.log")

    def command(self, work: Path, top: str, given: Mapping[str, Word], options: Sequence[Word] = ()) -> list[Word]:
        elaborate = ["-e", "--jit", "--no-save", *_generics(given), top]
        return [*nvc.start(), *elaborate, "-r", *options, top]

    def wave_options(self, path: Path, stop_ns: int) -> list[Word]:
        return [f"--wave={path}", f"--stop-time={stop_ns}ns"]


class Verilator(Simulator):
    """The same VHDL through `ghdl --synth`, for whole frames. The C++ bench knows the design as Vdesign, and takes what
    it is given as its words."""

    name = "verilator"
    bench = "c++"
    wave_suffixes = (".fst",)
    trace_options = ("--trace-fst",)

    @staticmethod
    def tools() -> dict[str, str]:
        return {"ghdl": ghdl.full_version(), "verilator": tool_version(find_verilator())}

    def edited(self, verilog: str, top: str) -> str:
        """What is built of what GHDL's synthesis gives."""
        return verilog

    def build(self, work: Path, design: Design) -> None:
        """All that make sees stands in a folder without blanks: it refuses them."""
        verilator = find_verilator()
        written(work, design.texts)
        source = self.verilog(work, design.top)
        # Wide registers, as arrays become, would be slow, and nobody would find their names.
        files = scalars.files(design.files)
        source.write_text(self.edited(ghdl.to_verilog(files, work, design.top), design.top))
        command: list[Word] = [verilator, *VERILATOR_OPTIONS, "-j", os.cpu_count() or 1, *design.options]
        # What runs once is not worth optimising. Verilator's own part and the bench are the same in each simulation.
        settings = f"OPT_FAST={os.environ.get(OPTIMISATION, '-O2')} OPT_SLOW=-O0 OPT_GLOBAL=-O2"
        settings += " OBJCACHE=ccache" if shutil.which("ccache") else ""
        # The bench finds what is written for it: the model's folder is one below.
        command += ["-CFLAGS", "-std=c++20", "-CFLAGS", "-I..", "-MAKEFLAGS", settings]
        command += ["--top-module", design.top, "--prefix", "Vdesign", "-o", "bench"]
        with _without_blanks(work) as folder:
            for path in design.bench_files:
                if path.parent != folder:
                    shutil.copy(path, folder)
            given = [folder / path.name for path in [source, *design.bench_files]]
            run([*command, "--Mdir", folder / "model", *given], cwd=folder, log=work / "verilator.log")

    @staticmethod
    def verilog(work: Path, top: str) -> Path:
        """What was built, in its folder."""
        return work / f"{top}.v"

    @staticmethod
    def program(work: Path) -> Path:
        return work / "model" / "bench"

    def command(self, work: Path, top: str, given: Mapping[str, Word], options: Sequence[Word] = ()) -> list[Word]:
        return [self.program(work), *given.values(), *options]


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


class Icarus(Simulator):
    """The same Verilog in four values, under a bench in Verilog."""

    name = "icarus"
    bench = "verilog"

    @staticmethod
    def tools() -> dict[str, str]:
        return {"ghdl": ghdl.full_version(), "icarus": run([Icarus._find("iverilog"), "-V"]).splitlines()[0]}

    @staticmethod
    def _find(program: str) -> str:
        return find_tool(program, hint="on Debian: apt-get install iverilog")

    def build(self, work: Path, design: Design) -> None:
        source = work / "design.v"
        source.write_text(ghdl.to_verilog(design.files, work, design.top))
        command: list[Word] = [self._find("iverilog"), "-g2005-sv", "-o", "bench", source, *design.bench_files]
        run(command, cwd=work, log=work / "iverilog.log")

    def command(self, work: Path, top: str, given: Mapping[str, Word], options: Sequence[Word] = ()) -> list[Word]:
        return [self._find("vvp"), work / "bench", *(f"+{name}={value}" for name, value in given.items()), *options]


SIMULATORS: dict[str, Simulator] = {simulator.name: simulator for simulator in (Ghdl(), Verilator(), Nvc(), Icarus())}


def of_benches_in(*languages: str) -> Iterable[Simulator]:
    return [simulator for simulator in SIMULATORS.values() if simulator.bench in languages]
