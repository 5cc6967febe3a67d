# SPDX-License-Identifier: Apache-2.0
"""A design in a simulator: built once for what it is made of, run any number of times."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..base import builds, ghdl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Word, run_with_progress
from . import simulators
from .simulators import Design, Simulator

_MAKERS = [Path(module) for module in (__file__, simulators.__file__, ghdl.__file__)]  # with a simulator's own module


class Simulation:
    """In a folder of `root` for each content."""

    def __init__(self, simulator: Simulator, design: Design, root: Path) -> None:
        self.simulator, self.design, self.root = simulator, design, root
        self._built: builds.Build | None = None

    def build(self) -> bool:
        """Whether it had to be built; not, where the same was built before."""
        design, simulator = self.design, self.simulator

        def make(work: Path, files: list[Path]) -> None:
            simulator.build(work, replace(design, files=files))

        made_of = (type(simulator).__name__, vars(simulator), simulator.tools())
        options = (made_of, design.top, dict(design.texts), list(design.options))
        makers = [*design.bench_files, *_MAKERS, Path(inspect.getfile(type(simulator)))]
        self._built = builds.build_once(self.root, design.files, makers, options, make)
        return self._built.is_new

    @property
    def work(self) -> Path:
        """Its folder, once it is built."""
        assert self._built is not None
        return self._built.folder

    def run_bench(
        self,
        given: Mapping[str, Word],
        watchdog_seconds: float,
        on_line: Callable[[str], object] = lambda line: None,
        options: Sequence[Word] = (),
        writes: Path | None = None,
        environment: Mapping[str, str] | None = None,
    ) -> float:
        """Returns the seconds it took. `given`: what the bench is told; `options`: of the simulator; `writes`: a file
        that must be there in the end; `environment`: variables beside those of this process."""
        if writes is not None:
            writes.unlink(missing_ok=True)
        command = self.simulator.command(self.work, self.design.top, given, options)
        if environment:
            command = ["env", *(f"{name}={value}" for name, value in environment.items()), *command]
        seconds = run_with_progress(command, on_line, watchdog_seconds, cwd=self.work)
        if writes is not None and not writes.is_file():
            raise FlowError(f"{self.simulator.name} ended with exit code 0 but has simulated nothing", EXIT_TOOL_FAILED)
        return seconds
