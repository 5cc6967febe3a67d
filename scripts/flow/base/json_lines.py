# SPDX-License-Identifier: Apache-2.0
"""Files with a JSON object a line, to which long runs append what is done: one that breaks off goes on from there."""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from .errors import FlowError


def read(path: Path) -> Iterator[dict[str, Any]]:
    """The objects of a file, none where there is no file. A line that was broken off counts as not there."""
    for line in path.read_text(errors="replace").splitlines() if path.is_file() else ():
        try:
            entry = json.loads(line)
        except ValueError:
            continue
        if isinstance(entry, dict):
            yield entry


def append(path: Path, entry: Mapping[str, Any]) -> None:
    # The line begins with its end: what was broken off before does not spoil it.
    try:
        with path.open("a") as file:
            file.write("\n" + json.dumps(entry) + "\n")
    except OSError as error:
        if path.is_file() and path.stat().st_size == 0:
            path.unlink()  # on a full disk
        raise FlowError(f"cannot write {path}: {error.strerror}") from None
