# SPDX-License-Identifier: Apache-2.0
"""generated_rtl/NAME/manifest.json: what the committed VHDL was made from, so that anyone can tell whether it still
fits."""

import hashlib
import json
import re
from collections.abc import Iterable
from pathlib import Path
from typing import TypedDict

from ..base import json_files
from ..base.configurations import Parameters
from ..base.errors import FlowError
from ..base.families import keeps_vhdl
from ..base.tools import GENERATED_RTL, ROOT

FORMAT = "stereo-hls manifest 1"
KEYS = {
    "format": str,
    "configuration": str,
    "parameters": dict,
    "sources": dict,
    "files": dict,
    "tool": str,
    "command": str,
    "tool_report": dict,
}
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
    parameters: Parameters
    sources: Digests
    files: Digests
    tool: str
    command: str
    tool_report: ToolReport


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _digests(paths: Iterable[Path]) -> Digests:
    return {path.relative_to(ROOT).as_posix(): digest(path) for path in paths}


def hardware_digests() -> Digests:
    """The C++ of the core. The table of configurations is left out: a manifest holds the one row that counts, so that a
    new configuration does not make the others stale."""
    return _digests(path for path in sorted((ROOT / "hls").glob("*.[hc]pp")) if path.name != "configurations.hpp")


def source_digests() -> Digests:
    """Every file that decides what the VHDL looks like: the core, its memory cell, the names of its registers and the
    steps that write the VHDL."""
    synthesis, names = ROOT / "scripts" / "flow" / "synthesis", ROOT / "hls_tb" / "vectors"
    return hardware_digests() | _digests(
        [
            ROOT / "hls" / "rtl" / "line_memory.vhd",
            names / "register_names.hpp",
            names / "slice_register_names.hpp",
            synthesis / "bambu.py",
            synthesis / "generate.py",
            *sorted((synthesis / "lowering").rglob("*.py")),
        ]
    )


def known_configurations() -> list[str]:
    """The folders with a manifest. Some may lack the VHDL, which the repository does not keep of all."""
    return sorted(path.parent.name for path in GENERATED_RTL.glob("*/manifest.json"))


def has_vhdl(name: str) -> bool:
    return all((GENERATED_RTL / name / file).is_file() for file in read(GENERATED_RTL / name)["files"])


def write(directory: Path, manifest: Manifest) -> None:
    (directory / "manifest.json").write_text(json.dumps(manifest, indent=2, sort_keys=True) + "\n")


def read(directory: Path) -> Manifest:
    """The manifest of one generated_rtl/ folder, checked for its keys."""
    path, name = directory / "manifest.json", directory.name
    try:
        manifest = json_files.load(path)
    except FileNotFoundError:
        raise FlowError(
            f"no generated VHDL for '{name}': {path} is missing; run scripts/synthesize.py --config {name}"
        ) from None
    except (OSError, ValueError) as error:
        raise FlowError(f"damaged manifest {path}: {getattr(error, 'strerror', None) or error}") from None
    missing = [key for key in KEYS if not isinstance(manifest, dict) or key not in manifest]
    if missing:
        raise FlowError(f"damaged manifest {path}: no {', '.join(missing)}")
    if manifest["format"] != FORMAT:
        raise FlowError(f"damaged manifest {path}: format {manifest['format']!r} instead of '{FORMAT}'")
    unusable = [key for key, kind in KEYS.items() if not isinstance(manifest[key], kind)]
    unusable += [key for key in ("sources", "files") if key not in unusable and not _are_digests(manifest[key])]
    if unusable:
        raise FlowError(f"damaged manifest {path}: unusable {', '.join(unusable)}")
    checked: Manifest = manifest
    return checked


def _are_digests(entries: dict[str, object]) -> bool:
    return all(re.fullmatch(r"[\w./-]{1,200}", name) and isinstance(value, str) for name, value in entries.items())


def vhdl_files(directory: Path) -> list[Path]:
    """The VHDL of one folder in compile order, each checked against its digest."""
    entry = read(directory)
    config = entry["configuration"]
    paths = []
    for name, expected in entry["files"].items():
        path = directory / name
        if not path.is_file() and not keeps_vhdl(config):
            raise FlowError(
                f"the repository does not keep the VHDL of {config}; make it with "
                f"scripts/synthesize.py --config {config}, which needs Bambu"
            )
        if not path.is_file():
            raise FlowError(f"{path} is named by the manifest but missing")
        if digest(path) != expected:
            raise FlowError(f"{path} differs from its manifest; it was edited by hand, or the manifest is damaged")
        paths.append(path)
    if not paths:
        raise FlowError(f"damaged manifest {directory / 'manifest.json'}: it names no VHDL file")
    return paths


def stale_reasons(name: str, parameters: Parameters) -> list[str]:
    """Why the VHDL of a configuration no longer follows from the sources, or is not what was made; empty when all is
    well."""
    manifest = read(GENERATED_RTL / name)
    reasons = []
    for file, expected in manifest["files"].items():
        path = GENERATED_RTL / name / file
        if not path.is_file():
            reasons += [f"{file} is missing"] if keeps_vhdl(name) else []
        elif digest(path) != expected:
            reasons.append(f"{file} was edited")
    if manifest["parameters"] != parameters:
        reasons.append("its row in hls/configurations.hpp changed")
    now, then = source_digests(), manifest["sources"]
    for path_text in sorted(set(now) | set(then)):
        if now.get(path_text) != then.get(path_text):
            change = (
                "changed" if path_text in now and path_text in then else "is new" if path_text in now else "is gone"
            )
            reasons.append(f"{path_text} {change}")
    return reasons
