# SPDX-License-Identifier: Apache-2.0
"""Where and with what a result was made."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from functools import cache
from typing import TypedDict

from .tools import ROOT


class Facts(TypedDict):
    commit: str | None  # of the project, with "+changes" where files differ from it; None outside of a checkout
    system: str
    processor: str
    processors: int
    python: str


@cache
def facts() -> Facts:
    return {
        "commit": _commit(),
        "system": platform.platform(),
        "processor": platform.machine(),
        "processors": os.cpu_count() or 1,
        "python": platform.python_version(),
    }


def _commit() -> str | None:
    head = _git("rev-parse", "HEAD")
    if head is None:
        return None
    changes = _git("status", "--porcelain", "--untracked-files=no")
    return head + ("+changes" if changes else "")


def _git(*words: str) -> str | None:
    if shutil.which("git") is None:
        return None
    result = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return result.stdout.strip() if result.returncode == 0 else None
