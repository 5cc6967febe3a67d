# SPDX-License-Identifier: Apache-2.0
"""A bar that shows how far a command is, where somebody watches. Loading what draws it takes a fifth of a second, which
a command that a script starts can save."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID


class Bar:
    """Shows nothing: the output is no terminal."""

    def show(self, done: int, title: str | None = None) -> None:
        """How much of the total is done, perhaps under another title."""

    def say(self, text: str) -> None:
        print(text, flush=True)


class _Drawn(Bar):
    def __init__(self, progress: Progress, task: TaskID) -> None:
        self._progress, self._task = progress, task

    def show(self, done: int, title: str | None = None) -> None:
        self._progress.update(self._task, completed=done, description=title)

    def say(self, text: str) -> None:
        self._progress.console.print(text, highlight=False, soft_wrap=True)


@contextmanager
def bar(title: str, total: int, unit: str = "") -> Iterator[Bar]:
    if not sys.stdout.isatty():
        yield Bar()
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TextColumn(unit))
    with Progress(*columns, TimeElapsedColumn()) as progress:
        yield _Drawn(progress, progress.add_task(title, total=total))
