# SPDX-License-Identifier: Apache-2.0
"""Where the commands put what they make: build/ of the project, or, where its user may not write that, a folder of this
project's own in the user's cache."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from .errors import FlowError
from .tools import ROOT

# Files that say of a folder: results in it are of this project, beside files of the user; or all of it is.
MARK, MARK_OF_ALL = ".stereo_hls_results", ".stereo_hls_work"


def build_folder() -> Path:
    here = ROOT / "build"
    if os.access(here if here.exists() else ROOT, os.W_OK):
        return here
    return _cached(here, os.environ.get("XDG_CACHE_HOME", ""))


@cache
def _cached(here: Path, named: str) -> Path:
    """`named`: the variable XDG_CACHE_HOME, which counts where it is a whole path."""
    try:
        root = Path(named) if os.path.isabs(named) else Path.home() / ".cache"
        folder = root / "stereo_hls" / hashlib.sha256(str(ROOT).encode()).hexdigest()[:12]
        folder.mkdir(parents=True, exist_ok=True)
        usable = os.access(folder, os.W_OK)
    except (OSError, RuntimeError):  # no home, or one that cannot be written either
        usable = False
    if not usable:
        raise FlowError(f"{here} cannot be written, nor a folder in ~/.cache; name one in the variable XDG_CACHE_HOME")
    return folder


def results_folder(folder: Path, names: Iterable[str]) -> Path:
    """Makes the folder of a command's results. Raises FlowError where one of the names is there that a command would
    replace and no command has made."""
    if not _has(folder, MARK) and (found := [name for name in names if os.path.lexists(folder / name)]):
        raise FlowError(
            f"{folder / found[0]} is no result of an earlier run, and would be replaced: name another folder"
        )
    return _marked(folder, MARK)


def emptied_folder(folder: Path) -> Path:
    """Makes the folder, empty. Raises FlowError where there are files in it, unless it was empty when it was first
    given."""
    if folder.is_dir():
        if not _has(folder, MARK_OF_ALL) and any(folder.iterdir()):
            raise FlowError(f"{folder} is not empty, and not of an earlier run: name another folder")
        shutil.rmtree(folder.resolve(), ignore_errors=True)
    return _marked(folder, MARK_OF_ALL)


def _has(folder: Path, mark: str) -> bool:
    return (folder / mark).is_file() or folder.resolve().is_relative_to(ROOT / "build")


def _marked(folder: Path, mark: str) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / mark).touch()
    except OSError as error:
        raise FlowError(f"cannot create {folder}: {error.strerror}") from None
    return folder
