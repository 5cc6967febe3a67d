# SPDX-License-Identifier: Apache-2.0
"""Finds the programs this flow calls, and calls them."""

import os
import selectors
import shutil
import subprocess
import time
from pathlib import Path

from .errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED, EXIT_USAGE, FlowError

ROOT = Path(__file__).resolve().parents[3]
GENERATED_RTL = ROOT / "generated_rtl"
BAMBU_DOWNLOAD = "https://release.bambuhls.eu"


def find_tool(name, variable=None, hint=""):
    """Path of a program: from the environment variable if set, else from PATH."""
    chosen = os.environ.get(variable or "") or name
    path = shutil.which(chosen)
    if path is None:
        where = f"{variable}={chosen}" if chosen != name else f"PATH{' or ' + variable if variable else ''}"
        raise FlowError(f"{name} not found in {where}{'; ' + hint if hint else ''}", EXIT_MISSING_TOOL)
    return path


def find_bambu():
    return find_tool("bambu", "BAMBU", f"download its AppImage from {BAMBU_DOWNLOAD} and set BAMBU to its path")


def find_ghdl():
    return find_tool("ghdl", "GHDL", "on Debian: apt-get install ghdl-mcode")


def find_verilator():
    return find_tool("verilator", "VERILATOR", "on Debian: apt-get install verilator")


def find_stereo_hls():
    """The native program: STEREO_HLS, else the build folders of the CMake presets."""
    chosen = os.environ.get("STEREO_HLS")
    candidates = [Path(chosen)] if chosen else [ROOT / "build" / p / "stereo_hls" for p in ("release", "ci", "debug")]
    for candidate in candidates:
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    raise FlowError(
        f"stereo_hls not found at {candidates[0]}; build it with: cmake --preset release && cmake --build --preset release",
        EXIT_MISSING_TOOL,
    )


def run(command, cwd=None, log=None, passes_errors=False):
    """Runs a program to its end and returns its standard output.

    With `log`, everything it prints goes to that file. With `passes_errors`, the program is one of ours: its own sentence
    on stderr becomes ours, and so does its exit code, unless it broke off.
    """
    command = [str(part) for part in command]
    result = subprocess.run(
        command, cwd=cwd, text=True, errors="replace", capture_output=True, stdin=subprocess.DEVNULL
    )
    if log is not None:
        Path(log).write_text(result.stdout + result.stderr)
    if result.returncode != 0:
        lines = (result.stderr or result.stdout).strip().splitlines() or ["no message"]
        if passes_errors:
            ours = result.returncode in (EXIT_USAGE, EXIT_MISSING_TOOL)
            raise FlowError(lines[-1].removeprefix("stereo_hls: "), result.returncode if ours else EXIT_TOOL_FAILED)
        name = Path(command[0]).name
        where = f"; see {log}" if log is not None else ""
        raise FlowError(f"{name} failed with exit code {result.returncode}: {lines[-1]}{where}", EXIT_TOOL_FAILED)
    return result.stdout


def run_with_progress(command, on_line, watchdog_seconds, cwd=None):
    """Runs a simulator, hands each line it prints to `on_line`, and ends it when it stays silent for too long.

    Returns the seconds it took.
    """
    command = [str(part) for part in command]
    started = time.monotonic()
    tail = []
    with (
        subprocess.Popen(
            command,
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
        selector.register(process.stdout, selectors.EVENT_READ)
        while True:
            if not selector.select(timeout=watchdog_seconds):
                process.kill()
                raise FlowError(
                    f"{Path(command[0]).name} made no progress for {watchdog_seconds:g} s and was stopped",
                    EXIT_TOOL_FAILED,
                )
            line = process.stdout.readline()
            if not line:
                break
            tail = (tail + [line.strip()])[-5:]
            on_line(line.strip())
        code = process.wait()
    if code != 0:
        raise FlowError(
            f"{Path(command[0]).name} failed with exit code {code}{': ' if tail else ''}{' / '.join(tail)}",
            EXIT_TOOL_FAILED,
        )
    return time.monotonic() - started
