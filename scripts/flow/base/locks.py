# SPDX-License-Identifier: Apache-2.0
"""Locks of files and folders between processes. Each is given back on every way out of its `with`; a wait that lasts is
told, with who is waited for."""

from __future__ import annotations

import fcntl
import os
import sys
import threading
from pathlib import Path
from types import TracebackType

PATIENCE_SECONDS = 5.0  # before a wait is told
NOTICE = "waiting for "  # a line on stderr that begins so tells of a wait, not of a fault
SHARED, EXCLUSIVE = fcntl.LOCK_SH, fcntl.LOCK_EX


class Lock:
    """Of a file, which is made where there is none, or of a folder. Held from the call of `take` on."""

    def __init__(self, path: Path) -> None:
        self.path = path
        folder = path.is_dir()
        self._descriptor: int | None = os.open(path, os.O_RDONLY if folder else os.O_RDWR | os.O_CREAT, 0o644)

    def take(self, kind: int = EXCLUSIVE) -> None:
        """Waits for it. One that is held changes its kind, perhaps not at one go."""
        if self.take_at_once(kind):
            return
        told = threading.Timer(PATIENCE_SECONDS, self._tell)
        told.daemon = True
        told.start()
        try:
            fcntl.flock(self._open(), kind)
        finally:
            told.cancel()

    def take_at_once(self, kind: int = EXCLUSIVE) -> bool:
        """Whether nobody had it."""
        try:
            fcntl.flock(self._open(), kind | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True

    def is_still(self) -> bool:
        """Whether the file of this name is the one that was opened."""
        try:
            return os.fstat(self._open()).st_ino == self.path.stat().st_ino
        except FileNotFoundError:
            return False

    def release(self) -> None:
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    def _open(self) -> int:
        assert self._descriptor is not None, f"the lock {self.path} was given back"
        return self._descriptor

    def _tell(self) -> None:
        held_by = ", ".join(_holders(self._open())) or "another process"
        print(f"{NOTICE}{self.path}, which {held_by} holds", file=sys.stderr, flush=True)

    def __enter__(self) -> Lock:
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.release()

    def __del__(self) -> None:  # of a lock that is held as long as an object
        self.release()


def exclusive(path: Path) -> Lock:
    """One that is held already: `with exclusive(path):`."""
    lock = Lock(path)
    try:
        lock.take()
    except BaseException:
        lock.release()
        raise
    return lock


def _holders(descriptor: int) -> list[str]:
    """Who holds a lock of this file, as Linux tells it: "process 12 (scripts/cosim.py --config tiny)"."""
    inode = os.fstat(descriptor).st_ino
    try:
        lines = [line.split() for line in Path("/proc/locks").read_text().splitlines()]
    except OSError:
        return []
    # "1: FLOCK  ADVISORY  WRITE 12 08:01:345 0 EOF"; one that waits has "->" behind the number
    found = [words[4] for words in lines if words[1] == "FLOCK" and words[5].rpartition(":")[2] == str(inode)]
    return [_named(int(number)) for number in dict.fromkeys(found)]


def _named(process: int) -> str:
    if process == os.getpid():
        return "this process itself"
    try:
        words = Path(f"/proc/{process}/cmdline").read_bytes().rstrip(b"\0").split(b"\0")
    except OSError:
        return f"process {process}"
    return f"process {process} ({b' '.join(words).decode(errors='replace')[:200]})"
