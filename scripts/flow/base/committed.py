# SPDX-License-Identifier: Apache-2.0
"""Where the VHDL of each configuration stands, with its manifest and its records: generated_rtl/FAMILY/NAME/ where
people take it into designs; where only tests and studies need it, an archive for each family,
hls_tb/evidence/FAMILY.tar.xz, which is unpacked into build/ when somebody asks for it. The `use` of a configuration
decides. Configurations of the user's own stand in their folder: nothing that lists what is committed knows them."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterable, Mapping
from itertools import groupby
from pathlib import Path
from typing import NamedTuple, Union

from . import archive, files
from .builds import Build, build_once
from .errors import FlowError, alike
from .locks import exclusive
from .places import build_folder
from .rtl import CORE, STAGES
from .tools import ROOT, find_stereo_hls

GENERATED_RTL = ROOT / "generated_rtl"
EVIDENCE = ROOT / "hls_tb" / "evidence"
TAKEN = ("paper", "system", "tiny")  # the uses of what people take
OWN = "own"  # the use of configurations of the user's own
MANIFEST = "manifest.json"

Contents = Mapping[str, Union[str, bytes]]  # {file: content}


class Change(NamedTuple):
    """Files of one configuration, new ones or in place of those of their names."""

    family: str
    config: str
    use: str
    contents: Contents


def known_designs() -> list[str]:
    """All whose VHDL was made: matching cores and stages."""
    return sorted(path.name for path in _folders())


def known_configurations() -> list[str]:
    """Those of matching cores."""
    return sorted(path.name for path in _folders() if path.parent.name not in STAGES)


def _folders() -> list[Path]:
    roots = [*GENERATED_RTL.glob("*"), *_unpacked()]
    return [path.parent for root in roots for path in root.glob(f"*/{MANIFEST}")]


def folder(config: str) -> Path:
    """FAMILY/NAME of a configuration whose VHDL was made, to be read: `keep` changes what is in it."""
    if not re.fullmatch(r"\w+", config):  # no pattern, and no path
        raise FlowError(f"'{config}' is no name of a configuration")
    found = [path.parent for path in GENERATED_RTL.glob(f"*/{config}/{MANIFEST}")]
    found = found or [root / config for root in _unpacked() if (root / config / MANIFEST).is_file()]
    found = found or [path.parent for path in _own().glob(f"*/{config}/{MANIFEST}")]
    if len(found) != 1:
        meant = alike(config, known_designs())
        raise FlowError(f"no generated VHDL for '{config}'; {meant or f'run scripts/synthesize.py --config {config}'}")
    return found[0]


def _own() -> Path:
    """FAMILY/NAME of the configurations of the user's own that the program knows: CMake makes it a link to their
    folder."""
    try:
        return Path(find_stereo_hls()).resolve().parent / "own" / "rtl"
    except FlowError:
        return Path(os.devnull)


def entity(config: str) -> str:
    """Of a core or a stage whose VHDL was made."""
    return STAGES.get(folder(config).parent.name, CORE).entity(config)


def keep(changes: Iterable[Change]) -> None:
    """Writes files where they belong, each archive once. What of these configurations stands in the other place, as
    their use was another one, moves along. Those of the user's own go to their folder."""

    def family_of(change: Change) -> str:
        return change.family

    ours = []
    for change in changes:
        if change.use == OWN:
            _write(_own() / change.family / change.config, _as_bytes(change.contents))
        else:
            ours.append(change)
    for family, of_family in groupby(sorted(ours, key=family_of), family_of):
        EVIDENCE.mkdir(parents=True, exist_ok=True)
        with exclusive(EVIDENCE):  # two runs that read the same archive would lose what the first one writes
            _keep(GENERATED_RTL / family, EVIDENCE / f"{family}{archive.SUFFIX}", list(of_family))


def _as_bytes(contents: Contents) -> dict[str, bytes]:
    return {name: text.encode() if isinstance(text, str) else text for name, text in contents.items()}


def _write(folder: Path, contents: Mapping[str, bytes]) -> None:
    for name, content in contents.items():
        files.write(folder / name, content)


def _keep(taken: Path, archived: Path, changes: Iterable[Change]) -> None:
    before = archive.read(archived) if archived.is_file() else {}
    after, left = dict(before), []
    for change in changes:
        folder = taken / change.config
        contents = _as_bytes(change.contents)
        if change.use in TAKEN:
            moved = [name for name in after if name.startswith(f"{change.config}/")]
            contents = {name.partition("/")[2]: after.pop(name) for name in moved} | contents
            _write(folder, contents)
        else:
            if folder.is_dir():
                contents = {path.name: path.read_bytes() for path in folder.iterdir()} | contents
                left.append(folder)
            after |= {f"{change.config}/{name}": content for name, content in contents.items()}
    if after != before:
        archive.write(archived, after)
    for folder in left:
        shutil.rmtree(folder)


_builds: dict[Path, tuple[tuple[int, int], Build]] = {}  # of archives as they are now; held until the process ends


def _unpacked() -> Iterable[Path]:
    """A folder for each archive, with a folder for each of its configurations."""
    for path in sorted(EVIDENCE.glob(f"*{archive.SUFFIX}")):
        state = path.stat().st_mtime_ns, path.stat().st_size
        if path not in _builds or _builds[path][0] != state:
            root = build_folder() / "evidence" / _family(path)
            _builds[path] = state, build_once(root, [path], [], "", _unpack)
        yield _builds[path][1].folder / _family(path)


def _unpack(folder: Path, archives: list[Path]) -> None:
    for path in archives:
        archive.unpack(path, folder / _family(path))


def _family(path: Path) -> str:
    return path.name[: -len(archive.SUFFIX)]
