# SPDX-License-Identifier: Apache-2.0
"""Folders of small files in one compressed archive, FOLDER/FILE: the same bytes for the same files."""

from __future__ import annotations

import io
import lzma
import re
import tarfile
from collections.abc import Mapping
from pathlib import Path

from . import files
from .errors import FlowError

SUFFIX = ".tar.xz"
_PRESET = 6
_NAME = re.compile(r"\w+/\w[\w.]*")
Files = Mapping[str, bytes]  # {FOLDER/FILE: its content}


def read(path: Path) -> dict[str, bytes]:
    """All files of an archive."""
    try:
        return content(path.read_bytes())
    except OSError as error:
        raise FlowError(f"cannot read {path}: {error.strerror}") from None
    except ValueError as error:
        raise FlowError(f"damaged {path}: {error}") from None


def content(data: bytes) -> dict[str, bytes]:
    """Of an archive's bytes. Raises ValueError where they are none of ours."""
    found: dict[str, bytes] = {}
    try:
        with tarfile.open(fileobj=io.BytesIO(lzma.decompress(data))) as archive:
            for member in archive:
                file = archive.extractfile(member) if member.isreg() and _NAME.fullmatch(member.name) else None
                if file is None:
                    raise ValueError(f"it has something other than FOLDER/FILE: {member.name!r}")
                found[member.name] = file.read()
    except (lzma.LZMAError, tarfile.TarError, EOFError, OSError) as error:
        raise ValueError(str(error) or "it is broken off") from None
    return found


def write(path: Path, members: Files) -> None:
    """The whole archive or none."""
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(members):
            member = tarfile.TarInfo(name)
            member.size, member.mode = len(members[name]), 0o644
            archive.addfile(member, io.BytesIO(members[name]))
    files.write(path, lzma.compress(data.getvalue(), preset=_PRESET))


def unpack(path: Path, folder: Path) -> None:
    for name, data in read(path).items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
