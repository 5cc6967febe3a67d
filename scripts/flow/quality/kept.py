# SPDX-License-Identifier: Apache-2.0
"""Evaluations that are done, one a line: a study that breaks off, or the next one over the same pairs, goes on from
them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import cast

from ..base import json_lines
from ..base.errors import FlowError
from ..base.tools import Word, find_stereo_hls
from .evaluation import Method


@cache
def _digest(path: str) -> str:
    try:
        return hashlib.sha256(Path(path).read_bytes()).hexdigest()
    except OSError as error:
        raise FlowError(f"{path}: cannot be read: {error.strerror}") from None


def key(words: Iterable[Word]) -> str:
    """Stands for a call of `stereo_hls evaluate`: the program, its words, and what is in the files among them."""
    parts = [
        _digest(find_stereo_hls()),
        *(_digest(str(word)) if isinstance(word, Path) else str(word) for word in words),
    ]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()


class Kept:
    def __init__(self, path: Path) -> None:
        self.path = path
        self._methods: dict[str, Method] = {}
        for entry in json_lines.read(path):
            if isinstance(entry.get("key"), str) and isinstance(entry.get("method"), dict):
                self._methods[entry["key"]] = cast(Method, entry["method"])

    def find(self, words: Iterable[Word]) -> Method | None:
        return self._methods.get(key(words))

    def add(self, words: Iterable[Word], method: Method) -> None:
        json_lines.append(self.path, {"key": key(words), "method": method})
