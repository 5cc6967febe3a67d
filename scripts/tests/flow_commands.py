# SPDX-License-Identifier: Apache-2.0
"""Calls the commands in scripts/ and the native program as a user does."""

import contextlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

from flow.base import committed, files
from flow.base.configurations import configuration, designs
from flow.base.errors import FlowError
from flow.base.locks import NOTICE
from flow.base.tools import ROOT, find_stereo_hls
from flow.synthesis import manifest
from flow.synthesis.presentation.present import expand
from flow.synthesis.structure import structure_digest


def call(command, *arguments, environment=None):
    """The finished process of scripts/COMMAND, under the Python of the tests: that of PATH may lack packages."""
    python = [sys.executable] if command.endswith(".py") else []
    words = [*python, str(ROOT / "scripts" / command), *map(str, arguments)]
    return subprocess.run(
        words, capture_output=True, text=True, env={**os.environ, **(environment or {})}, stdin=subprocess.DEVNULL
    )


def complaints(process):
    """What a command said on stderr, but for notices of waits: a test beside this one may hold what it waits for."""
    return [line for line in process.stderr.splitlines() if not line.startswith(NOTICE)]


def refused(process, exit_code, *words):
    """Asserts that a command ended with this code and one sentence on stderr that has all the words."""
    assert process.returncode == exit_code, process.stdout + process.stderr
    lines = complaints(process)
    assert len(lines) == 1, process.stderr
    for word in words:
        assert word in lines[0], lines[0]
    assert "Traceback" not in process.stderr


def scene(folder, config, seed=7):
    """(left, right) of a generated pair of the size that a configuration takes."""
    subprocess.run(
        [find_stereo_hls(), "scene", "--config", config, "--seed", str(seed), "--out", str(folder)],
        check=True,
        capture_output=True,
    )
    return folder / "left.png", folder / "right.png"


def random_pair(folder, config, levels, seed=1, brightest=255):
    """(left, right) of unrelated noise with so many grey levels from 0 to the brightest: few levels give ties
    everywhere, far apart also extremes, close together sums that differ by little. Brighter than 255: 16 bits."""
    size = configuration(config, designs())
    generator = random.Random(f"{levels} {seed}")
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("left", "right"):
        width, height = size["width_px"], size["height_px"]
        pixels = [generator.randrange(levels) * brightest // max(levels - 1, 1) for _ in range(width * height)]
        deep = brightest > 255
        content = files.deep_pgm(width, height, pixels) if deep else files.pgm(width, height, bytes(pixels))
        (folder / f"{name}.pgm").write_bytes(content)
    return folder / "left.pgm", folder / "right.pgm"


def cosim(config, pair, out, *options, environment=None, takes_edited=True):
    """Of the pair alone, which has known outputs; the stress stream has tests of its own."""
    options = ["--stimulus", "scene", *options]
    if takes_edited and "--rtl" in options and "--allow-edited" not in options:
        options.append("--allow-edited")
    words = ["--config", config, "--left", pair[0], "--right", pair[1], "--out", out, *options]
    return call("cosim.py", *words, environment=environment)


def stream(folder, config, pair, *options):
    """A folder with the stimulus.txt and expected.txt of a pair."""
    words = ["vectors", "--config", config, "--left", pair[0], "--right", pair[1], "--out", folder, *options]
    subprocess.run([find_stereo_hls(), *map(str, words)], check=True, capture_output=True)
    return folder


def report(out):
    return json.loads((Path(out) / "report.json").read_text())


def altered_rtl(folder, config, pattern, replacement, with_arrays=False):
    """A copy of the committed VHDL with the first place that matches changed, and a manifest that fits the change.
    `with_arrays`: of the text as it is committed, else of that with a signal for each register."""
    target = Path(folder) / config
    shutil.copytree(committed.folder(config), target)
    design = target / f"{committed.entity(config)}.vhd"
    before = design.read_text() if with_arrays else expand(design.read_text())
    text, count = re.subn(pattern, replacement, before, count=1, flags=re.MULTILINE)
    assert count == 1, f"the VHDL of {config} has no '{pattern}'"
    design.write_text(text)
    entry = manifest.read(target)
    entry["files"][design.name] = manifest.digest(design)
    with contextlib.suppress(FlowError, ValueError, IndexError, KeyError):  # no VHDL of ours any more
        entry["structure"] = structure_digest(text)
    manifest.write(target, entry)
    return target
