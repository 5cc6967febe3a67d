# SPDX-License-Identifier: Apache-2.0
"""All VHDL that goes into a user's design, and the tools that take it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ..base import committed, ghdl, nvc, rtl
from ..base.errors import FlowError
from ..base.farm import Farm
from ..base.progress import bar
from ..base.tools import find_ghdl, run
from ..shell import board_vhdl, design, template
from ..synthesis import manifest
from ..system import template as systems

# Of those whose generics have no default.
GENERICS: dict[str, ghdl.Generics] = {"stereo_joiner": {"width_px": 640, "height_px": 480, "depth": 1024}}


def with_shell(names: Iterable[str]) -> list[str]:
    """Those of matching cores; a stage has none."""
    return [name for name in names if committed.folder(name).parent.name not in rtl.STAGES]


def files(names: Iterable[str]) -> list[Path]:
    """Those of these configurations, of the shell, the camera systems and the boards: in compile order, each once."""
    names = list(names)
    cores = [file for name in names for file in manifest.core_files(name)]
    shells = [template.path(name) for name in with_shell(names)]
    cameras = [file for system in _systems(names) for file in systems.own_files(system)]
    by_hand = [*design.shell_files(), *design.joiner_files()]
    boards = board_vhdl.COMMITTED if board_vhdl.CONFIG in names else []
    return list(dict.fromkeys([*cores, *by_hand, *shells, *cameras, *boards]))


def tops(names: Iterable[str]) -> list[str]:
    """All that stands on its own: the other files are parts of these."""
    names = list(names)
    cores = [committed.entity(name) for name in names]
    shells = [rtl.ip_entity(name) for name in with_shell(names)]
    board_top = [board_vhdl.TOP] if board_vhdl.CONFIG in names else []
    return [*cores, *shells, *(system.entity for system in _systems(names)), "stereo_joiner", *board_top]


def _systems(names: list[str]) -> list[systems.System]:
    """Those of which both parts are there."""
    return [one for one in systems.SYSTEMS.values() if {one.rectification, one.matching} <= set(names)]


class Way:
    """One way in which a tool takes designs."""

    does = "elaborates"

    def __init__(self, standard: str) -> None:
        self.standard = standard

    def __str__(self) -> str:
        return f"{self.tool()} {self.does} {self.standard}"

    @staticmethod
    def tool() -> str:
        """Its name and version."""
        raise NotImplementedError

    def analyse(self, files: list[Path], work: Path) -> None:
        """Those of all designs, in the folder `work`."""
        raise NotImplementedError

    def take(self, top: str, work: Path) -> None:
        """One design of what was analysed in `work`."""
        raise NotImplementedError


class Elaborated(Way):
    @staticmethod
    def tool() -> str:
        return ghdl.version()

    def analyse(self, files: list[Path], work: Path) -> None:
        ghdl.analyse(files, work, standard=self.standard)

    def take(self, top: str, work: Path) -> None:
        ghdl.elaborate(work, top, self.standard, f"{top}.log")


class Synthesised(Elaborated):
    does = "synthesises"

    def take(self, top: str, work: Path) -> None:
        options = [self.standard, *ghdl.options_of(GENERICS.get(top)), "--out=none"]
        run([find_ghdl(), "--synth", *options, top], cwd=work, log=work / f"{top}.log")


class Nvc(Way):
    @staticmethod
    def tool() -> str:
        return nvc.version().partition(" (")[0]

    def analyse(self, files: list[Path], work: Path) -> None:
        run([*nvc.start(self.standard), "-a", *files], cwd=work, log=work / "analyse.log")

    def take(self, top: str, work: Path) -> None:
        options = ["--jit", "--no-save", *ghdl.options_of(GENERICS.get(top))]
        run([*nvc.start(self.standard), "-e", *options, top], cwd=work, log=work / f"{top}.log")


WAYS: dict[str, list[Way]] = {
    "ghdl": [Elaborated("--std=93"), Elaborated("--std=08"), Synthesised("--std=08")],
    "nvc": [Nvc("--std=1993"), Nvc("--std=2008")],
}


def refusals(way: Way, names: list[str], work: Path, jobs: int) -> dict[str, str]:
    """{design: why the tool does not take it}. A file that cannot be analysed is an error."""
    work.mkdir(parents=True)
    way.analyse(files(names), work)
    wanted, found = tops(names), {}
    with Farm(jobs) as workers, bar(str(way), len(wanted)) as shown:
        taken = [(top, workers.submit(way.take, top, work)) for top in wanted]
        for done, (top, job) in enumerate(taken, 1):
            try:
                job.result()
            except FlowError as error:
                found[top] = str(error)
            shown.show(done)
    return found
