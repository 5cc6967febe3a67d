# SPDX-License-Identifier: Apache-2.0
"""Where and with what a result was made."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from functools import cache
from typing import TypedDict

from .errors import FlowError
from .tools import ROOT


class Facts(TypedDict):
    commit: str  # of the project, with "+changes" where files differ from it, or "unknown: " and why
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


def _commit() -> str:
    try:
        head = _git("rev-parse", "HEAD")
        changes = _git("status", "--porcelain", "--untracked-files=no")
    except FlowError as error:
        return f"unknown: {error}"
    return head + ("+changes" if changes else "")


def _git(*words: str) -> str:
    """Refused, for example, by git itself in a checkout that another user owns, as in a container."""
    if shutil.which("git") is None:
        raise FlowError("git is not installed")
    result = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        said = result.stderr.strip().splitlines() or ["no message"]
        raise FlowError(f"git says: {said[0].removeprefix('fatal: ')}")
    return result.stdout.strip()
