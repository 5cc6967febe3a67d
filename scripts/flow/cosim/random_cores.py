# SPDX-License-Identifier: Apache-2.0
"""Random configurations of a family: rows from random_rows, a module of each core, the verdict of check_cores
(hls_tb/random_cores/)."""

import re
import secrets
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from .errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from .tools import ROOT, find_native, find_tool, run


@dataclass(frozen=True)
class Core:
    name: str
    row: str
    verdict: str = ""

    @property
    def exact(self) -> bool:
        return self.verdict.startswith("exact, ")


def new_seed() -> int:
    return secrets.randbelow(1 << 31)


def source_folder(family: str) -> Path:
    """The folder of the family's core, beside hls/."""
    for folder in (ROOT / "hls", *sorted((ROOT / "hls_tb").glob("*"))):
        if (folder / family / "family.hpp").is_file():
            return folder
    raise FlowError(f"there is no family '{family}'")


def draw(family: str, count: int, seed: int) -> list[Core]:
    text = run([find_native("random_cores/random_rows"), family, seed, count])
    return [Core(re.match(r"STEREO_ROW\((\w+),", row).group(1), row) for row in text.splitlines()]


def build(core: Core, family: str, folder: Path) -> Path:
    """The module of one core."""
    rows, module = folder / f"{core.name}.hpp", folder / f"{core.name}.so"
    rows.write_text(core.row + "\n")
    run([find_tool("c++", "CXX", "on Debian: apt-get install g++"), "-std=c++20", "-O1", "-fPIC", "-shared",
         *(f"-I{path}" for path in (source_folder(family), ROOT / "hls", ROOT / "hls_tb")),
         f"-DSTEREO_FAMILY={family}", f"-DSTEREO_CONFIGURATION={core.name}", f'-DSTEREO_ROWS="{rows}"',
         *(ROOT / "hls_tb" / "engines" / "clocked" / name for name in ("core_module.cpp", "register_list.cpp")), "-o", module])
    return module


def check(core: Core, family: str, seed: int, folder: Path) -> Core:
    module = build(core, family, folder)
    result = subprocess.run([find_native("random_cores/check_cores"), str(seed), str(module)], capture_output=True, text=True)
    module.unlink()
    if result.returncode not in (EXIT_OK, EXIT_MISMATCH) or not result.stdout.startswith(f"{core.name}: "):
        raise FlowError(f"check_cores broke off on {core.row}: exit code {result.returncode} {result.stderr.strip()}", EXIT_TOOL_FAILED)
    return Core(core.name, core.row, result.stdout.removeprefix(f"{core.name}: ").strip())


def run_all(cores: list[Core], family: str, seed: int, jobs: int) -> list[Core]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    checked = []
    with tempfile.TemporaryDirectory() as folder, Progress(*columns) as bar, ThreadPoolExecutor(jobs) as pool:
        task = bar.add_task("cores", total=len(cores))
        for core in pool.map(lambda core: check(core, family, seed, Path(folder)), cores):
            checked.append(core)
            bar.advance(task)
            if not core.exact:
                bar.console.print(f"{core.name}: {core.verdict}\n  {core.row}", highlight=False, soft_wrap=True)
    return checked


def run_family(family: str, count: int, seed: int, jobs: int) -> int:
    """Returns the exit code."""
    print(f"{count} configurations of {family}, seed {seed}", flush=True)
    checked = run_all(draw(family, count, seed), family, seed, jobs)
    maps = sum(int(core.verdict.split()[1]) for core in checked if core.exact)
    wrong = [core for core in checked if not core.exact]
    print(f"{len(checked) - len(wrong)} of {count} configurations exact in {maps} maps")
    if wrong:
        raise FlowError(f"{len(wrong)} of {count} cores differ from the definition; again with --family {family} --count {count} --seed {seed}", EXIT_MISMATCH)
    return EXIT_OK
