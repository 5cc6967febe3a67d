# SPDX-License-Identifier: Apache-2.0
"""Writes a kit whole or not at all."""

import shutil
import tempfile
from pathlib import Path

from ..base.errors import FlowError
from . import contents


def write(kit: str, config: str, folder: Path, mhz: float, pads_map: bool = False) -> None:
    """Fills `folder`, which must be new or empty."""
    if folder.is_dir() and any(folder.iterdir()):
        raise FlowError(f"{folder} is not empty; name a new folder")
    if folder.exists() and not folder.is_dir():
        raise FlowError(f"{folder} is a file; name a new folder")
    files = contents.of(kit, config, mhz, pads_map)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}."))
    except OSError as error:
        raise FlowError(f"cannot write {folder}: {error.strerror}") from None
    try:
        for path, text in files.items():
            (beside / path).parent.mkdir(parents=True, exist_ok=True)
            (beside / path).write_text(text)
        beside.chmod(0o755)
        beside.rename(folder)  # also onto an empty folder
    except OSError as error:
        raise FlowError(f"cannot write {folder}: {error.strerror}") from None
    finally:  # of an interruption, too
        shutil.rmtree(beside, ignore_errors=True)
