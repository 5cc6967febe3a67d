# SPDX-License-Identifier: Apache-2.0
"""Cores with a signal for each register, for tools that name registers, show lines of the lowering or change single
statements."""

from __future__ import annotations

import functools
import hashlib
from collections.abc import Iterable
from pathlib import Path

from ...base import files as written
from ...base.errors import FlowError
from ...base.places import build_folder
from .present import expand, is_presented


@functools.cache
def _expansion() -> str:
    """Another one where the code that expands is another."""
    return "".join(source.read_text() for source in sorted(Path(__file__).parent.glob("*.py")))


def files(paths: Iterable[Path]) -> list[Path]:
    """The same files, those of presented cores as copies of the same name. What cannot be expanded, as somebody has
    edited it, stays as it is."""
    return [_of(path) for path in paths]


def _of(path: Path) -> Path:
    try:
        text = path.read_text()
        if not is_presented(text):
            return path
        key = hashlib.sha256(_expansion().encode() + text.encode()).hexdigest()[:20]
        copy = build_folder() / "scalars" / key / path.name
        if not copy.is_file():
            written.write(copy, expand(text))
    except (OSError, UnicodeDecodeError, FlowError):
        return path
    return copy
