# SPDX-License-Identifier: Apache-2.0
"""The ways to run the VHDL. Each reads a stimulus file and writes an observed file (see vectors.py)."""

import hashlib
import os
import re
import shutil
import threading
from pathlib import Path

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, find_ghdl, find_verilator, run, run_with_progress
from . import vcd, waveform

BENCH = ROOT / "hls_tb" / "cosim"
GHDL_STANDARD = "--std=08"


class Simulator:
    """Builds a simulation of some VHDL files once, then runs it any number of times."""

    name = ""
    wave_suffixes = ()

    def __init__(self, vhdl_files, work_directory, pixels=1, disparity_bits=8, trace=False):
        self.pixels = pixels  # pairs a clock
        self.disparity_bits = disparity_bits  # of one pixel
        self.vhdl_files = [Path(path) for path in vhdl_files]
        self.work = Path(work_directory)
        self.trace = trace

    def _bench_files(self):
        raise NotImplementedError

    def _build(self):
        raise NotImplementedError

    def build(self):
        build_once(self.work, [*self.vhdl_files, *self._bench_files(), Path(__file__)], self.trace, self._build)

    def _command(self, stimulus, observed, wave, wave_clocks):
        raise NotImplementedError

    def run(self, stimulus, observed, on_clock, watchdog_seconds, wave=None, wave_clocks=(0, 0)):
        """Simulates the whole stimulus; returns the seconds it took. `wave_clocks`: first and last clock to dump."""
        Path(observed).unlink(missing_ok=True)
        command = self._command(Path(stimulus).resolve(), Path(observed).resolve(), wave, wave_clocks)

        def on_line(line):
            if line.startswith("progress "):
                on_clock(int(line.split()[1]))

        return run_with_progress(command, on_line, watchdog_seconds, cwd=self.work)


def build_once(work, files, options, build):
    """Calls `build` in the empty folder `work`, unless the same files and options were built there before."""
    key = hashlib.sha256(repr(options).encode())
    for path in map(Path, files):
        key.update(str(path.resolve()).encode())  # GHDL looks at the file again when it runs
        key.update(path.read_bytes())
    stamp = work / "built"
    if stamp.is_file() and stamp.read_text() == key.hexdigest():
        return
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    build()
    stamp.write_text(key.hexdigest())


class Ghdl(Simulator):
    """The judge: a VHDL simulator on the VHDL as it is."""

    name = "ghdl"
    wave_suffixes = (".ghw", ".fst", ".vcd")

    def _bench_files(self):
        return [BENCH / "tb_stereo_core.vhd"]

    def _build(self):
        self._analyse([*self.vhdl_files, *self._bench_files()])

    def _analyse(self, files):
        ghdl = find_ghdl()
        run([ghdl, "-a", GHDL_STANDARD, *files], cwd=self.work, log=self.work / "analyse.log")
        run([ghdl, "-e", GHDL_STANDARD, "tb_stereo_core"], cwd=self.work, log=self.work / "elaborate.log")

    def _command(self, stimulus, observed, wave, wave_clocks):
        command = [
            find_ghdl(),
            "-r",
            GHDL_STANDARD,
            "tb_stereo_core",
            f"-gpixels={self.pixels}",
            f"-gdisparity_bits={self.disparity_bits}",
            f"-gstimulus_file={stimulus}",
            f"-gobserved_file={observed}",
        ]
        if wave is not None:
            # GHDL always dumps from the start; the stop time bounds the end.
            option = {".ghw": "--wave", ".fst": "--fst", ".vcd": "--vcd"}[wave.suffix]
            command += [f"{option}={wave}", f"--stop-time={waveform.start_ns(wave_clocks[1] + 1)}ns"]
        return command

    def run(self, stimulus, observed, on_clock, watchdog_seconds, wave=None, wave_clocks=(0, 0)):
        """A .vcd has the clocks that were asked for: GHDL writes all into a pipe, and they are cut out at its other end."""
        if wave is None or wave.suffix != ".vcd":
            return super().run(stimulus, observed, on_clock, watchdog_seconds, wave, wave_clocks)
        pipe = self.work / "wave.vcd"
        pipe.unlink(missing_ok=True)
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
            pipe.unlink()


def _cut(pipe, path, first_ns, last_ns):
    with open(pipe, encoding="ascii") as lines, open(path, "w", encoding="ascii") as result:
        vcd.cut(lines, result.write, first_ns, last_ns)


class Original(Ghdl):
    """Bambu's own VHDL with its component library in GHDL, to prove the lowering. Needs a run of synthesize.py on this
    machine; `vhdl_files` are the tool's files, memory images included."""

    name = "original"

    def _bench_files(self):
        return [BENCH / "bambu_read_port.vhd", BENCH / "bambu_original.vhd", *super()._bench_files()]

    def _build(self):
        ghdl = find_ghdl()
        library = self.work / "library"
        library.mkdir()
        sources = []
        for path in self.vhdl_files:
            if path.suffix == ".mem":
                shutil.copy(path, self.work)
            elif path.name == "stereo_core.vhd":
                sources.insert(0, path)
            else:
                # Each component file brings the same package; one copy, in the design itself, is enough.
                copy = library / path.name.replace("\\", "")
                copy.write_text(path.read_text().rpartition("end package body;")[2])
                sources.append(copy)
        template = (BENCH / "bambu_read_port.vhd").read_text()
        for port in ("left_pixel", "right_pixel", "start_of_frame", "valid"):
            copy = library / f"{port}.vhd"
            copy.write_text(template.replace("PORT", port))
            sources.append(copy)
        run([ghdl, "-a", GHDL_STANDARD, "--work=bambu", *sources], cwd=self.work, log=self.work / "library.log")
        self._analyse(self._bench_files()[1:])


class Verilator(Simulator):
    """The same VHDL through `ghdl --synth`, for whole frames."""

    name = "verilator"
    wave_suffixes = (".fst",)

    def _bench_files(self):
        return [BENCH / "verilator_bench.cpp"]

    def _build(self):
        verilate(
            self.work,
            self.vhdl_files,
            "stereo_core",
            self._bench_files(),
            options=["--trace-fst"] if self.trace else [],
        )

    def _command(self, stimulus, observed, wave, wave_clocks):
        command = [verilated_bench(self.work), stimulus, observed]
        if wave is not None:
            command += [wave, *wave_clocks]
        return command


def verilate(work, vhdl_files, top, bench_files, generics=None, options=()):
    """Compiles a design and its C++ bench to the program verilated_bench(work)."""
    verilator = find_verilator()
    source = work / f"{top}.v"
    source.write_text(to_verilog(vhdl_files, work, top, generics))
    run(
        [
            verilator,
            "--cc",
            "--exe",
            "--build",
            "-j",
            os.cpu_count() or 1,
            "-O3",
            "--x-assign",
            "fast",
            "--output-split",
            "20000",
            "-Wno-fatal",
            *options,
            "-CFLAGS",
            "-O2",
            "--top-module",
            top,
            "--Mdir",
            work / "model",
            "-o",
            "bench",
            source,
            *bench_files,
        ],
        cwd=work,
        log=work / "verilator.log",
    )


def verilated_bench(work):
    return work / "model" / "bench"


SIMULATORS = {simulator.name: simulator for simulator in (Ghdl, Verilator, Original)}


def to_verilog(vhdl_files, work_directory, top="stereo_core", generics=None):
    """The design as Verilog text, by `ghdl --synth`. `generics`: {name: value} of the top."""
    ghdl = find_ghdl()
    folder = Path(work_directory) / "synth"
    folder.mkdir(parents=True, exist_ok=True)
    run([ghdl, "-a", GHDL_STANDARD, *vhdl_files], cwd=folder, log=folder / "analyse.log")
    values = [f"-g{name}={value}" for name, value in (generics or {}).items()]
    log = folder / "synth.log"
    verilog = run([ghdl, "--synth", GHDL_STANDARD, *values, "--out=verilog", top], cwd=folder, log=log)
    lost = re.search(r".*warning: no assignment for offset.*", log.read_text())
    if lost:
        raise FlowError(f"ghdl --synth leaves bits without a value: {lost.group()}", EXIT_TOOL_FAILED)
    if f"module {top}" not in verilog:
        raise FlowError(f"ghdl --synth did not write a module {top}", EXIT_TOOL_FAILED)
    return verilog
