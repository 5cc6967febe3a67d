#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the committed VHDL with that of an earlier commit: the same netlist under other names, or another one."""

import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import archive, committed, rtl
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.tools import ROOT, find_tool, run
from flow.synthesis.structure import structure_digest

PLACES = [place.relative_to(ROOT).as_posix() for place in (committed.GENERATED_RTL, committed.EVIDENCE)]


def cores_of(commit: str) -> dict[str, str]:
    """{configuration: its VHDL in that commit}"""
    try:
        listed = run([find_tool("git"), "ls-tree", "-r", "--name-only", commit, *PLACES], cwd=ROOT)
    except FlowError:
        raise FlowError(f"{commit} is no commit of this repository") from None
    found: dict[Path, bytes] = {}
    for path in map(Path, listed.splitlines()):
        if path.name.endswith(archive.SUFFIX):
            try:
                members = archive.content(shown(commit, path))
            except ValueError as error:
                raise FlowError(f"damaged {path} in {commit}: {error}") from None
            found |= {Path(name): text for name, text in members.items()}
        elif path.suffix == ".vhd":
            found[path] = shown(commit, path)
    made = [path for path in found if path.suffix == ".vhd" and path != shell_of(path)]
    return {path.parent.name: found[path].decode() for path in made}


def shown(commit: str, path: Path) -> bytes:
    """A file of a commit."""
    command = [find_tool("git"), "show", f"{commit}:{path.as_posix()}"]
    return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout


def shell_of(path: Path) -> Path:
    """The AXI shell beside a file of VHDL."""
    return path.with_name(f"{rtl.ip_entity(path.parent.name)}.vhd")


def verdict(before: str, after: str) -> str:
    if before == after:
        return "the same text"
    try:
        is_same = structure_digest(before) == structure_digest(after)
    except FlowError as error:
        return f"another netlist ({error})"
    if is_same:
        return "the same netlist; names, comments or order differ"
    return "another netlist"


def main() -> int:
    parser = ArgumentParser(prog="compare_rtl.py", description=__doc__)
    parser.add_argument("--against", required=True, metavar="COMMIT", help="of this repository, such as HEAD~1")
    parser.add_argument(
        "--config", action="append", metavar="NAME", help="configuration, may be repeated (default: all of both)"
    )
    options = parser.parse_args()
    earlier = cores_of(options.against)
    names = options.config or sorted(set(earlier) & set(committed.known_designs()))
    for name in names:
        if name not in earlier:
            raise FlowError(f"{options.against} has no VHDL of '{name}'")
    changed = []
    for name in names:
        path = committed.folder(name) / f"{committed.entity(name)}.vhd"
        try:
            said = verdict(earlier[name], path.read_text())
        except UnicodeDecodeError:
            raise FlowError(f"damaged {path}: it is no text") from None
        print(f"{name}: {said}", flush=True)
        changed += [name] if said.startswith("another netlist") else []
    print(f"{len(names) - len(changed)} of {len(names)} cores have the netlist of {options.against}")
    if changed:
        raise FlowError(f"another netlist: {', '.join(changed)}", EXIT_MISMATCH)
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
