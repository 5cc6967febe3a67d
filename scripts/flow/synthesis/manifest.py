# SPDX-License-Identifier: Apache-2.0
"""manifest.json beside the VHDL of each configuration: what that was made from, so that anyone can tell whether it
still fits."""

import hashlib
import json
import os
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple, TypedDict, cast

from ..base import committed, files, json_files, rtl
from ..base.configurations import Configuration, Parameters, parameters_of
from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.tools import ROOT, find_stereo_hls, find_tool, run
from . import sources
from .structure import structure_digest

FORMAT = "stereo-hls manifest 3"
KEYS = {
    "format": str,
    "configuration": str,
    "use": str,
    "parameters": dict,
    "sources": dict,
    "code": dict,
    "cells": dict,
    "files": dict,
    "structure": str,
    "tool": str,
    "command": str,
    "tool_report": dict,
}
_DIGESTS = ("sources", "cells", "files")
Digests = dict[str, str]  # {file: SHA-256}


class Estimate(TypedDict):
    """What Bambu says of its own design."""

    states: int
    flip_flops: int
    mhz: float


class ToolReport(Estimate):
    """That, and what the netlist has."""

    loop_states: int
    registers: int
    registers_named: int  # after the C++
    register_bits: int
    memory_bits: int


class Manifest(TypedDict):
    format: str
    configuration: str
    use: str  # as in configurations.Configuration
    parameters: Parameters
    sources: Digests  # of the words of all that it was made from
    code: sources.Code  # that clang makes of the hardware top
    cells: Digests  # of the hand-written VHDL below it, from the project's root
    files: Digests  # of what was made
    structure: str  # structure.py: the same for VHDL that differs in names, comments and order only
    tool: str
    command: str
    tool_report: ToolReport


def digest(path: Path) -> str:
    return digest_of(path.read_bytes())


def digest_of(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _digests(paths: Iterable[Path], digest_of: Callable[[Path], str] = sources.words_digest) -> Digests:
    return {path.relative_to(ROOT).as_posix(): digest_of(path) for path in paths}


def top_options(config: str, family: str, source_folder: str, top: str, macros: Iterable[str] = ()) -> list[str]:
    """What a compiler needs to compile the hardware top, in the project's root."""
    folders = dict.fromkeys((source_folder, "hls"))
    defined = (f"STEREO_FAMILY={family}", f"STEREO_CONFIGURATION={config}", *macros)
    return [top, "--std=c++20", *(f"-I{folder}" for folder in folders), *(f"-D{macro}" for macro in defined)]


@cache
def _included(source_folder: str, family: str, top: str) -> tuple[Path, ...]:
    """The hardware top and all that it includes, as the compiler finds it: the same for every row of a family."""
    compiler = find_tool("c++", "CXX", "on Debian: apt-get install g++")
    rule = run([compiler, *top_options("any", family, source_folder, top), "-MM"], cwd=ROOT)
    names = rule.replace("\\\n", " ").split(":", 1)[1].split()
    return tuple(sorted({ROOT / os.path.normpath(name) for name in names}))


def compiler_options(config: str, row: Configuration) -> list[str]:
    """top_options of a configuration."""
    kind = rtl.kind_of(row)
    return top_options(config, row["family"], row["source_folder"], kind.top, kind.macros)


def hardware_digests(row: Configuration) -> Digests:
    """The C++ of the core. The family's tables of configurations are left out: a manifest holds the one row that
    counts, so that a new configuration does not make the others stale."""
    included = _included(row["source_folder"], row["family"], rtl.kind_of(row).top)
    return _digests(path for path in included if path.parts[-2:] != (row["family"], "configurations.hpp"))


def source_digests(row: Configuration) -> Digests:
    """Every file that decides what the VHDL looks like: the core and the steps that write the VHDL."""
    synthesis = ROOT / "scripts" / "flow" / "synthesis"
    steps = [synthesis / "bambu.py", synthesis / "generate.py", *sorted((synthesis / "lowering").rglob("*.py"))]
    return hardware_digests(row) | _digests([*steps, ROOT / "scripts" / "flow" / "base" / "rtl.py"])


def cell_digests() -> Digests:
    return _digests([rtl.MEMORY_CELL], digest)


def _seal(manifest: Mapping[str, object]) -> str:
    """Of all that a manifest says, so that an edit of it shows."""
    content = {key: value for key, value in manifest.items() if key != "seal"}
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def text(manifest: Manifest) -> str:
    """Of the file."""
    return json.dumps({**manifest, "seal": _seal(manifest)}, indent=2, sort_keys=True) + "\n"


def write(directory: Path, manifest: Manifest) -> None:
    files.write(directory / committed.MANIFEST, text(manifest))


def read(directory: Path) -> Manifest:
    """The manifest of one folder, checked for its keys."""
    path = directory / "manifest.json"
    try:
        manifest = json_files.load(path)
    except FileNotFoundError:
        raise FlowError(
            f"{directory} is no folder of generated VHDL: it has no {path.name}, which scripts/synthesize.py writes"
        ) from None
    except (OSError, ValueError) as error:
        raise FlowError(f"damaged manifest {path}: {getattr(error, 'strerror', None) or error}") from None
    missing = [key for key in KEYS if not isinstance(manifest, dict) or key not in manifest]
    if missing:
        raise FlowError(f"damaged manifest {path}: no {', '.join(missing)}")
    if manifest["format"] != FORMAT:
        raise FlowError(f"damaged manifest {path}: format {manifest['format']!r} instead of '{FORMAT}'")
    unusable = [key for key, kind in KEYS.items() if not isinstance(manifest[key], kind)]
    unusable += [key for key in _DIGESTS if key not in unusable and not _are_digests(manifest[key])]
    if unusable:
        raise FlowError(f"damaged manifest {path}: unusable {', '.join(unusable)}")
    checked: Manifest = manifest
    return checked


def _are_digests(entries: dict[str, object]) -> bool:
    return all(re.fullmatch(r"[\w./-]{1,200}", name) and isinstance(value, str) for name, value in entries.items())


def design(entry: Manifest) -> Digests:
    """What area, clock and behaviour depend on: not the names in the VHDL."""
    return entry["cells"] | {"structure": entry["structure"]}


def _named_files(directory: Path) -> Mapping[Path, str]:
    """{path: digest} in compile order."""
    entry = read(directory)
    if not entry["files"]:
        raise FlowError(f"damaged manifest {directory / 'manifest.json'}: it names no VHDL file")
    expected = {ROOT / name: value for name, value in entry["cells"].items()}
    return expected | {directory / name: value for name, value in entry["files"].items()}


def edited_files(directory: Path) -> list[str]:
    """VHDL that is not what the manifest says."""
    return [str(path) for path, value in _named_files(directory).items() if path.is_file() and digest(path) != value]


def vhdl_files(directory: Path, allow_edited: bool = False) -> list[Path]:
    """The VHDL of one core in compile order, each file checked against its digest. `directory`: that of a
    configuration, or a copy of it."""
    expected = _named_files(directory)
    for path, value in expected.items():
        if not path.is_file():
            raise FlowError(f"{path} is named by the manifest but missing")
        if digest(path) != value and not allow_edited:
            raise FlowError(f"{path} differs from its manifest; it was edited by hand, or the manifest is damaged")
    return list(expected)


def with_use(*uses: str) -> list[str]:
    """The configurations with VHDL that are there for one of these uses."""
    return [name for name in committed.known_configurations() if read(committed.folder(name))["use"] in uses]


def core_files(config: str) -> list[Path]:
    """The committed VHDL of one configuration, in compile order."""
    return vhdl_files(committed.folder(config))


def _has_structure(path: Path, structure: str) -> bool:
    try:
        return structure_digest(path.read_text()) == structure
    except (FlowError, UnicodeDecodeError):  # no VHDL of ours
        return False


def check_program(table: Mapping[str, Configuration]) -> None:
    """Refuses a program that is older than a table of configurations: what it says of a row may be of yesterday."""
    program = Path(find_stereo_hls())
    for family, folder in sorted({(row["family"], row["source_folder"]) for row in table.values()}):
        # The second one leads to rows of the user's own.
        for path in (ROOT / folder / family / name for name in ("configurations.hpp", "rows.hpp")):
            if path.is_file() and path.stat().st_mtime > program.stat().st_mtime:
                raise FlowError(
                    f"{program} is older than {path.relative_to(ROOT)}; build it again (scripts/setup.sh)",
                    EXIT_MISMATCH,
                )


def edit_reasons(directory: Path, reads_vhdl: bool = True) -> list[str]:
    """Why the VHDL of a folder is not what was made; empty when it is. Reading it, which takes most of the time, shows
    what was edited together with its digest and the seal."""
    manifest = read(directory)
    reasons = []
    if cast(dict[str, object], manifest).get("seal") != _seal(manifest):
        reasons.append("manifest.json was edited")
    for file, expected in manifest["files"].items():
        path = directory / file
        if not path.is_file():
            reasons.append(f"{file} is missing")
        elif digest(path) != expected:
            reasons.append(f"{file} was edited")
        elif reads_vhdl and not _has_structure(path, manifest["structure"]):
            reasons.append(f"{file} is not the design that was made")
    return reasons


def require_as_made(directory: Path) -> None:
    """Raises FlowError where the VHDL of a folder or its manifest was edited."""
    for reason in edit_reasons(directory, reads_vhdl=False):
        raise FlowError(f"{directory}: {reason}")


class Freshness(NamedTuple):
    """Whether the VHDL of a configuration follows from the sources, and is what was made."""

    reasons: list[str]  # why not; empty when all is well
    by_code: bool = False  # the words of sources differ, and clang makes the same of them


def stale_reasons(name: str, row: Configuration, reads_vhdl: bool = True) -> list[str]:
    return freshness(name, row, reads_vhdl).reasons


def change(entry: Manifest, contents: committed.Contents) -> committed.Change:
    """Of files beside a manifest that is committed."""
    return committed.Change(entry["parameters"]["family"], entry["configuration"], entry["use"], contents)


def refreshed(name: str, row: Configuration) -> Manifest:
    """With the row and the words of the sources as they are now, of which clang makes the same as before."""
    now: Manifest = {**read(committed.folder(name)), "sources": source_digests(row)}
    return {**now, "parameters": parameters_of(row), "use": row["use"]}


def freshness(name: str, row: Configuration, reads_vhdl: bool = True) -> Freshness:
    directory = committed.folder(name)
    manifest = read(directory)
    reasons, core = [], f"{rtl.kind_of(row).entity(name)}.vhd"
    if manifest["configuration"] != name or set(manifest["files"]) != {core}:
        reasons.append(f"its manifest does not name {core} as its VHDL")
    reasons += edit_reasons(directory, reads_vhdl)
    then, now = manifest["parameters"], parameters_of(row)
    row_text = f"its row in {row['family']}/configurations.hpp"
    if any(now.get(name) != value for name, value in then.items()) or manifest["use"] != row["use"]:
        reasons.append(f"{row_text} changed")
    gains = sorted(now.keys() - then.keys())  # options that came since then
    changes = _changes(manifest["sources"] | manifest["cells"], source_digests(row) | cell_digests())
    is_hardware = all(Path(path).suffix in (".cpp", ".hpp") for path in changes)
    if (changes or gains) and is_hardware and sources.is_same_code(manifest["code"], compiler_options(name, row)):
        return Freshness(reasons, by_code=True)
    if gains:
        reasons.append(f"{row_text} has {', '.join(gains)}")
    return Freshness(reasons + [f"{path} {change}" for path, change in changes.items()])


def _changes(then: Digests, now: Digests) -> dict[str, str]:
    """{file: what has become of it}"""
    found = {path: "is gone" for path in then if path not in now}
    found |= {path: "is new" for path in now if path not in then}
    found |= {path: "changed" for path in now if path in then and now[path] != then[path]}
    return dict(sorted(found.items()))
