# SPDX-License-Identifier: Apache-2.0
"""Things that are built once for each content of their files: a folder a digest, which no two runs fill at once, and
which nobody removes while a run uses it."""

import hashlib
import json
import os
import shutil
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

from .errors import FlowError
from .locks import EXCLUSIVE, SHARED, Lock

KEPT = 4  # folders of one root that no run uses; older ones are removed
_STAMP = "built"  # {file: [size, mode]} of all that was made


class Build(NamedTuple):
    folder: Path
    is_new: bool  # built by this call
    lock: Lock  # nobody removes the folder while this Build is held


def build_once(
    root: Path,
    files: Iterable[Path],
    makers: Iterable[Path],
    options: object,
    make: Callable[[Path, list[Path]], object],
) -> Build:
    """The folder of `root` for these contents. `make(folder, sources)` fills it, unless that was done before.

    What is made reads the copies only: files that change or go later change nothing. `makers`: files that decide how,
    and are not copied."""
    contents = [(path, path.read_bytes()) for path in files]
    key = hashlib.sha256(repr(options).encode())
    for name, data in [(path.name, data) for path, data in contents] + [("", path.read_bytes()) for path in makers]:
        key.update(f"{name} {len(data)} ".encode() + data)
    folder = root.resolve() / key.hexdigest()[:20]
    folder.parent.mkdir(parents=True, exist_ok=True)
    sources = [folder / "sources" / path.name for path, _ in contents]
    if len(set(sources)) != len(sources):
        raise FlowError(f"two source files of one name: {', '.join(str(path) for path, _ in contents)}")
    is_new = False
    with ExitStack() as held:
        lock = held.enter_context(_locked(folder, SHARED))
        while not _is_whole(folder):
            held.close()  # two runs that hold it would wait for each other
            lock = held.enter_context(_locked(folder, EXCLUSIVE))
            if not _is_whole(folder):
                shutil.rmtree(folder, ignore_errors=True)
                (folder / "sources").mkdir(parents=True)
                for path, (_, data) in zip(sources, contents):
                    path.write_bytes(data)
                _make(make, folder, sources, [path for path, _ in contents])
                (folder / _STAMP).write_text(json.dumps(_made(folder)))
                is_new = True
            lock.take(SHARED)  # not at one go: another run may remove the folder in between
        os.utime(folder)
        _remove_old(root.resolve(), folder)
        held.pop_all()  # whoever holds the Build holds the lock
        return Build(folder, is_new, lock)


def _made(folder: Path) -> dict[str, list[int]]:
    found = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): [path.stat().st_size, path.stat().st_mode] for path in found}


def _is_whole(folder: Path) -> bool:
    """Whether all that was made is there as it was: a program that has lost its content or its x bit would stay so for
    ever, as the folder's name says only what it was made of."""
    try:
        made = json.loads((folder / _STAMP).read_text())
        stats = {name: (folder / name).stat() for name in made}
        return bool(made) and all(made[name] == [stat.st_size, stat.st_mode] for name, stat in stats.items())
    except (OSError, ValueError, AttributeError):
        return False


def _make(make: Callable[[Path, list[Path]], object], folder: Path, copies: list[Path], files: list[Path]) -> None:
    try:
        make(folder, copies)
    except FlowError as error:
        message = str(error)
        for copy, path in zip(copies, files):
            message = message.replace(str(copy), str(path))  # the user's file, not our copy of it
        raise FlowError(message, error.exit_code) from None


def _lock_file(folder: Path) -> Path:
    return folder.with_suffix(".lock")


def _locked(folder: Path, kind: int) -> Lock:
    """Of the folder's lock file. Who removes a folder removes that file, too: then it is another one."""
    while True:
        with ExitStack() as held:
            lock = held.enter_context(Lock(_lock_file(folder)))
            lock.take(kind)
            if lock.is_still():
                held.pop_all()
                return lock


def _remove_old(root: Path, used: Path) -> None:
    """All but the latest folders that no run uses."""
    stamps = {path.parent: _time(path.parent) for path in root.glob(f"*/{_STAMP}")}
    for folder in sorted(stamps, key=lambda one: stamps[one], reverse=True)[KEPT:]:
        if folder == used:
            continue
        with Lock(_lock_file(folder)) as lock:
            if lock.take_at_once() and lock.is_still():  # else it is in use
                shutil.rmtree(folder, ignore_errors=True)
                _lock_file(folder).unlink(missing_ok=True)


def _time(folder: Path) -> float:
    try:
        return folder.stat().st_mtime
    except FileNotFoundError:  # another run has removed it
        return 0
