# SPDX-License-Identifier: Apache-2.0
"""Random configurations of a family: rows from random_rows, a module of each core, the verdict of check_cores
(hls_tb/random_cores/)."""

import re
import secrets
import subprocess
import tempfile
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base import progress
from ..base.configurations import configurations, options
from ..base.errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.farm import Farm, result_of
from ..base.places import build_folder
from ..base.tools import ROOT, Word, find_native, find_tool, run, tool_version


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


def source_folder(family: str) -> str:
    """The folder of the family's core, from the project's root: its named configurations have it, too."""
    folders = {row["family"]: row["source_folder"] for row in configurations().values()}
    if family not in folders:
        raise FlowError(f"there is no family '{family}'; known are: {', '.join(sorted(folders))}")
    return folders[family]


MOST_DRAWN = 100_000


def draw(family: str, count: int, seed: int, differing: Collection[str] = ()) -> list[Core]:
    """The first `count` of the seed in whose rows each option of `differing` is not its default."""
    known = options()[family]
    for name in differing:
        if name not in known:
            raise FlowError(f"{family} has no option '{name}'; docs/options.md lists all")
    drawn = count
    while True:
        text = run([find_native("random_cores/random_rows"), family, seed, drawn])
        found = [row for row in text.splitlines() if all(_differs(row, name, known[name]) for name in differing)]
        if len(found) >= count:
            return [core_of(row) for row in found[:count]]
        if drawn >= MOST_DRAWN:
            raise FlowError(f"only {len(found)} of {drawn} rows differ from the defaults in {' and '.join(differing)}")
        drawn = min(MOST_DRAWN, 4 * drawn)


def _differs(row: str, name: str, option: Mapping[str, Any]) -> bool:
    said = re.search(rf"\b{name} = (?:\w+::)?([\w-]+)", row)
    return said is not None and said[1] != str(option["default"]).lower()


def core_of(row: str) -> Core:
    """`row`: as in a family's configurations.hpp."""
    name = re.match(r"STEREO_ROW\((\w+),", row)
    if name is None:
        raise FlowError(f"'{row}' is no row of a configuration, STEREO_ROW(name, use, base, what differs);")
    return Core(name[1], row)


class Checker:
    """Builds and checks cores of one family. `checkout`: the folder with hls/ and hls_tb/."""

    def __init__(self, family: str, seed: int, folder: Path, checkout: Path = ROOT) -> None:
        self.family, self.seed, self.folder, self.checkout = family, seed, folder, checkout
        self.program = find_native("random_cores/check_cores")
        self.source_folder = source_folder(family)
        self.interface = run([self.program, "--interface"]).strip()
        self.clocked = checkout / "hls_tb" / "engines" / "clocked"
        folders = [checkout / name for name in dict.fromkeys((self.source_folder, "hls", "hls_tb"))]
        self.compiler: list[Word] = [find_tool("c++", "CXX", "on Debian: apt-get install g++"), "-std=c++20", "-O1"]
        self.compiler += ["-fPIC", *(f"-I{path}" for path in folders)]
        # The same in every module, as it knows nothing of the core.
        self.register_list = folder / "register_list.o"
        run([*self.compiler, "-c", self.clocked / "register_list.cpp", "-o", self.register_list])

    def build(self, core: Core) -> Path:
        """The module of one core."""
        rows, module = self.folder / f"{core.name}.hpp", self.folder / f"{core.name}.so"
        rows.write_text(core.row + "\n")
        macros = {
            "FAMILY": self.family,
            "CONFIGURATION": core.name,
            "ROWS": f'"{rows}"',
            "CORE_INTERFACE": f'"{self.interface}"',
        }
        command = [*self.compiler, "-shared", *(f"-DSTEREO_{name}={value}" for name, value in macros.items())]
        run([*command, self.clocked / "core_module.cpp", self.register_list, "-o", module])
        return module

    def check(self, core: Core) -> Core:
        module = self.build(core)
        result = subprocess.run([self.program, str(self.seed), str(module)], capture_output=True, text=True)
        module.unlink()
        if result.returncode not in (EXIT_OK, EXIT_MISMATCH) or not result.stdout.startswith(f"{core.name}: "):
            raise FlowError(
                f"check_cores failed on {core.row}: exit code {result.returncode} {result.stderr.strip()}",
                EXIT_TOOL_FAILED,
            )
        return Core(core.name, core.row, result.stdout.removeprefix(f"{core.name}: ").strip())


def tools() -> dict[str, str]:
    """{name: version}"""
    return {"c++": tool_version(find_tool("c++", "CXX"))}


def run_all(cores: list[Core], family: str, seed: int, workers: Farm) -> list[Core]:
    checked = []
    root = build_folder() / "random_cores"  # which all workers see
    root.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=root) as folder, progress.bar("cores", len(cores)) as bar:
        checker = Checker(family, seed, Path(folder))
        for future in [workers.submit(checker.check, core) for core in cores]:
            core = result_of(future)
            checked.append(core)
            bar.show(len(checked))
            if not core.exact:
                bar.say(f"{core.name}: {core.verdict}\n  {core.row}")
    return checked


def run_family(family: str, cores: list[Core], seed: int, workers: Farm, differing: Collection[str] = ()) -> int:
    """Returns the exit code."""
    print(f"{len(cores)} configurations of {family}, seed {seed}", flush=True)
    checked = run_all(cores, family, seed, workers)
    maps = sum(int(core.verdict.split()[1]) for core in checked if core.exact)
    wrong = [core for core in checked if not core.exact]
    print(f"{len(checked) - len(wrong)} of {len(checked)} configurations exact in {maps} maps")
    if wrong:
        raise FlowError(
            f"{len(wrong)} of {len(checked)} cores differ from the definition; "
            f"again with --family {family} --count {len(checked)} --seed {seed}"
            + "".join(f" --differs {name}" for name in differing),
            EXIT_MISMATCH,
        )
    return EXIT_OK
