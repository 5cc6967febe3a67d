# SPDX-License-Identifier: Apache-2.0
"""Where the commands put what they make: build/ of the project, or, where its user may not write that, a folder of this
project's own in the user's cache."""

from __future__ import annotations

import hashlib
import os
from functools import cache
from pathlib import Path

from .errors import FlowError
from .tools import ROOT


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
