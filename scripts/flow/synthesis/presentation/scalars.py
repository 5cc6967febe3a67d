# SPDX-License-Identifier: Apache-2.0
"""Cores with a signal for each register, for tools that name registers, show lines of the lowering or change single
statements."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

from ...base import files as written
from ...base.errors import FlowError
from ...base.places import build_folder
from .present import expand, is_presented


def files(paths: Iterable[Path]) -> list[Path]:
    """The same files, those of presented cores as copies of the same name. What cannot be expanded, as somebody has
    edited it, stays as it is."""
    return [_of(path) for path in paths]


def _of(path: Path) -> Path:
    try:
        text = path.read_text()
        if not is_presented(text):
            return path
        copy = build_folder() / "scalars" / hashlib.sha256(text.encode()).hexdigest()[:20] / path.name
        if not copy.is_file():
            written.write(copy, expand(text))
    except (OSError, UnicodeDecodeError, FlowError):
        return path
    return copy
