# SPDX-License-Identifier: Apache-2.0
"""generated_rtl/NAME/manifest.json: what the committed VHDL was made from, so that anyone can tell whether it still fits."""

import hashlib
import json
import re
from pathlib import Path

from ..base import json_files
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


def digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def _digests(paths):
    return {path.relative_to(ROOT).as_posix(): digest(path) for path in paths}


def hardware_digests():
    """The C++ of the core. The table of configurations is left out: a manifest holds the one row that counts, so that a new
    configuration does not make the others stale."""
    return _digests(path for path in sorted((ROOT / "hls").glob("*.[hc]pp")) if path.name != "configurations.hpp")


def source_digests():
    """Every file that decides what the VHDL looks like: the core, its memory cell, the names of its registers and the steps
    that write the VHDL."""
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


def write(directory, manifest):
    (Path(directory) / "manifest.json").write_text(json.dumps(manifest, indent=2, sort_keys=True) + "\n")


def read(directory):
    """The manifest of one generated_rtl/ folder, checked for its keys."""
    path = Path(directory) / "manifest.json"
    name = Path(directory).name
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
    return manifest


def _are_digests(entries):
    return all(re.fullmatch(r"[\w./-]{1,200}", name) and isinstance(value, str) for name, value in entries.items())


def vhdl_files(directory):
    """The VHDL of one folder in compile order, each checked against its digest."""
    directory = Path(directory)
    paths = []
    entry = read(directory)
    config = entry["configuration"]
    for name, expected in entry["files"].items():
        path = directory / name
        if not path.is_file() and not keeps_vhdl(config):
            raise FlowError(
                f"the repository does not keep the VHDL of {config}; make it with scripts/synthesize.py --config {config}, which needs Bambu"
            )
        if not path.is_file():
            raise FlowError(f"{path} is named by the manifest but missing")
        if digest(path) != expected:
            raise FlowError(f"{path} differs from its manifest; it was edited by hand, or the manifest is damaged")
        paths.append(path)
    if not paths:
        raise FlowError(f"damaged manifest {directory / 'manifest.json'}: it names no VHDL file")
    return paths


def stale_reasons(name, parameters):
    """Why the VHDL of a configuration no longer follows from the sources, or is not what was made; empty when all is well."""
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
    now = source_digests()
    for path in sorted(set(now) | set(manifest["sources"])):
        if now.get(path) != manifest["sources"].get(path):
            reasons.append(
                f"{path} {'changed' if path in now and path in manifest['sources'] else 'is new' if path in now else 'is gone'}"
            )
    return reasons
