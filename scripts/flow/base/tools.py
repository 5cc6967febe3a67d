# SPDX-License-Identifier: Apache-2.0
"""Finds the programs this flow calls, and calls them."""

from __future__ import annotations

import os
import re
import selectors
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from functools import cache
from pathlib import Path
from typing import IO, Union

from .errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED, EXIT_USAGE, FlowError

ROOT = Path(__file__).resolve().parents[3]
BAMBU_DOWNLOAD = "https://release.bambuhls.eu"

Word = Union[str, Path, int, float]  # of a command
Say = Callable[[str], None]  # takes a line for the user


def find_tool(name: str, variable: str | None = None, hint: str = "") -> str:
    """Path of a program: from the environment variable if set, else from PATH."""
    chosen = os.environ.get(variable or "") or name
    path = shutil.which(chosen)
    if path is None:
        where = f"{variable}={chosen}" if chosen != name else f"PATH{' or ' + variable if variable else ''}"
        raise FlowError(f"{name} not found in {where}{'; ' + hint if hint else ''}", EXIT_MISSING_TOOL)
    return path


def find_bambu() -> str:
    return find_tool("bambu", "BAMBU", f"download its AppImage from {BAMBU_DOWNLOAD} and set BAMBU to its path")


def find_ghdl() -> str:
    return find_tool("ghdl", "GHDL", "on Debian: apt-get install ghdl-mcode")


def find_nvc() -> str:
    return find_tool("nvc", "NVC", "on Debian from 13 on: apt-get install nvc")


def find_verilator() -> str:
    return find_tool("verilator", "VERILATOR", "on Debian: apt-get install verilator")


def find_yosys() -> str:
    return find_tool("yosys", "YOSYS", "on Debian: apt-get install yosys")


def find_stereo_hls() -> str:
    """The native program: STEREO_HLS, else the build folders of the CMake presets."""
    chosen = os.environ.get("STEREO_HLS")
    candidates = [Path(chosen)] if chosen else [ROOT / "build" / p / "stereo_hls" for p in ("release", "ci", "debug")]
    for candidate in candidates:
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    raise FlowError(
        f"stereo_hls not found at {candidates[0]}; build it with scripts/setup.sh, or scripts/setup.sh --core CONFIG",
        EXIT_MISSING_TOOL,
    )


def find_native(name: str) -> str:
    """A program of the native build that stands beside stereo_hls."""
    path = Path(find_stereo_hls()).parent / name
    if not path.is_file():
        build = path.parents[name.count("/")]
        raise FlowError(
            f"{path} is not built; make it with: cmake --build {build} --target {path.name}", EXIT_MISSING_TOOL
        )
    return str(path)


@cache
def tool_version(program: str) -> str:
    """The first line of what `program --version` says."""
    lines = run([program, "--version"]).splitlines()
    if not lines:
        raise FlowError(f"{Path(program).name} --version prints nothing", EXIT_TOOL_FAILED)
    return lines[0].strip()


def first_error(lines: Iterable[str]) -> str | None:
    """The line of a tool's messages that says what is wrong; what follows are places and consequences."""
    sign = re.compile(
        r"\b(error|fatal)\b|^\S+:\d+:\d+: |: \*\*\* ", re.IGNORECASE
    )  # or FILE:LINE:COLUMN: without a word, as GHDL; or asterisks, as make
    return next((line.strip() for line in lines if sign.search(line) and "warning" not in line.lower()), None)


def _read(stream: IO[str], copy: IO[str] | None) -> str:
    """All that comes, and at once into `copy`."""
    lines = []
    for line in stream:
        lines.append(line)
        if copy:
            copy.write(line)
            copy.flush()
    return "".join(lines)


def run(command: Iterable[Word], cwd: Path | None = None, log: Path | None = None, passes_errors: bool = False) -> str:
    """Runs a program to its end and returns its standard output.

    With `log`, everything it prints goes to that file as it comes, so that one can see how far a long run is. With
    `passes_errors`, the program is one of ours: its own sentence on stderr becomes ours, and so does its exit code,
    unless it broke off.
    """
    words = [str(word) for word in command]
    pipe = subprocess.PIPE
    with (
        log.open("w", errors="replace") if log else nullcontext() as copy,
        subprocess.Popen(
            words, cwd=cwd, text=True, errors="replace", stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe
        ) as process,
        ThreadPoolExecutor(2) as readers,
    ):
        assert process.stdout and process.stderr  # they are pipes
        try:
            parts = [readers.submit(_read, stream, copy) for stream in (process.stdout, process.stderr)]
            output, said = (part.result() for part in parts)
            code = process.wait()
        except BaseException:  # of an interruption, too
            process.kill()
            raise
    if code != 0:
        lines = (said or output).strip().splitlines() or ["no message"]
        if passes_errors:
            ours = code in (EXIT_USAGE, EXIT_MISSING_TOOL)
            raise FlowError(lines[-1].removeprefix("stereo_hls: "), code if ours else EXIT_TOOL_FAILED)
        name, why = Path(words[0]).name, first_error(lines) or lines[-1]
        where = f"; see {log}" if log is not None else ""
        raise FlowError(f"{name} failed with exit code {code}: {why}{where}", EXIT_TOOL_FAILED)
    return output


def run_with_progress(
    command: Iterable[Word], on_line: Callable[[str], object], watchdog_seconds: float, cwd: Path | None = None
) -> float:
    """Runs a simulator, hands each line it prints to `on_line`, and ends it when it stays silent for too long.

    Returns the seconds it took.
    """
    words = [str(word) for word in command]
    name = Path(words[0]).name
    started = time.monotonic()
    tail: list[str] = []
    error: str | None = None
    with (
        subprocess.Popen(
            words,
            cwd=cwd,
            text=True,
            errors="replace",
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            bufsize=1,
        ) as process,
        selectors.DefaultSelector() as selector,
    ):
        assert process.stdout is not None  # it is a pipe
        selector.register(process.stdout, selectors.EVENT_READ)
        try:
            while True:
                if not selector.select(timeout=watchdog_seconds):
                    raise FlowError(
                        f"{name} made no progress for {watchdog_seconds:g} s and was stopped", EXIT_TOOL_FAILED
                    )
                line = process.stdout.readline()
                if not line:
                    break
                tail = (tail + [line.strip()])[-5:]
                error = error or first_error([line])
                on_line(line.strip())
        except BaseException:  # of an interruption, too: it would go on without us
            process.kill()
            raise
        code = process.wait()
    if code != 0:
        said = error or " / ".join(tail)
        last_words = f": {said}" if said else ""
        raise FlowError(f"{name} failed with exit code {code}{last_words}", EXIT_TOOL_FAILED)
    return time.monotonic() - started


def require_core(config: str) -> None:
    """Refuses a configuration whose clocked core is not built, in place of the step that needs it minutes later."""
    with tempfile.TemporaryDirectory() as work:
        command: list[Word] = [find_stereo_hls(), "trace", "--config", config, "--clocks", 10, "--out", work]
        run(command, passes_errors=True)
