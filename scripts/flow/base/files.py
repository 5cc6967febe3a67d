# SPDX-License-Identifier: Apache-2.0
"""Files that are there whole or as they were before."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from .errors import EXIT_MISMATCH, EXIT_OK, FlowError
from .tools import ROOT


def write(path: Path, content: str | bytes) -> None:
    """The whole file or none. A device, a pipe or a link that has the name stays."""
    if path.is_symlink() or (path.exists() and not path.is_file() and not path.is_dir()):
        raise FlowError(f"cannot write {path}: it is no regular file")
    temporary: Path | None = None
    data = content.encode(errors="surrogateescape") if isinstance(content, str) else content
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("wb", dir=path.parent, prefix=f".{path.name}.", delete=False) as file:
            temporary = Path(file.name)
            file.write(data)
        temporary.chmod(0o644)
        os.replace(temporary, path)
        temporary = None
    except OSError as error:
        raise FlowError(f"cannot write {path}: {error.strerror}") from None
    finally:  # of an interruption, too
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def refuse_input(out: Path, inputs: Iterable[Path]) -> None:
    """Raises FlowError where a file that is to be written is one of a command's inputs, by whatever name."""
    for path in inputs:
        if out.resolve() == path.resolve():
            raise FlowError(f"{out} is an input of this command, and would be replaced: name another file")


def shown(path: Path) -> str:
    """As it is told to people: from the project's root where it lies below it."""
    return path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else str(path)


def pgm(width: int, height: int, pixels: bytes) -> bytes:
    """A grey image as a file."""
    return b"P5 %d %d 255\n" % (width, height) + pixels


def deep_pgm(width: int, height: int, pixels: Sequence[int]) -> bytes:
    """The same with 16 bits a pixel."""
    return b"P5 %d %d 65535\n" % (width, height) + b"".join(pixel.to_bytes(2, "big") for pixel in pixels)


def drawn_from(data: str) -> str:
    """The line of a picture that says what it shows."""
    return f"<!-- drawn from: {data} -->"


def _says(text: str) -> str:
    """What is compared of a file: of a picture its data, as its curves depend on the version of what draws it."""
    data = re.search(f"^{drawn_from('.*')}$", text, re.MULTILINE)
    return data.group() if data else text


def update(texts: Mapping[Path, str], check: bool, command: str) -> int:
    """For a command that makes committed files. Writes those of {path: text} that differ, or with `check` refuses those
    that say something else; returns the exit code. `command` makes them again."""

    def same(old: str, new: str) -> bool:
        return _says(old) == _says(new) if check else old == new

    stale = [path for path, text in texts.items() if not path.is_file() or not same(path.read_text(), text)]
    names = {path: shown(path) for path in texts}
    if check and stale:
        raise FlowError(f"not up to date: {', '.join(names[path] for path in stale)}; run {command}", EXIT_MISMATCH)
    for path, text in texts.items():
        if path in stale:
            write(path, text)
        print(f"wrote {names[path]}" if path in stale else f"{names[path]} is up to date")
    return EXIT_OK
