#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the committed VHDL with that of an earlier commit: the same netlist under other names, or another one."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, rtl
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.tools import ROOT, find_tool, run
from flow.synthesis.structure import structure_digest


def cores_of(commit: str) -> dict[str, str]:
    """{configuration: path of its VHDL in that commit}"""
    git = find_tool("git")
    try:
        listed = run([git, "ls-tree", "-r", "--name-only", commit, "generated_rtl"], cwd=ROOT)
    except FlowError:
        raise FlowError(f"{commit} is no commit of this repository") from None
    files = [Path(line) for line in listed.splitlines()]
    made = (path for path in files if path.suffix == ".vhd" and path != shell_of(path))
    return {path.parent.name: path.as_posix() for path in made}


def shell_of(path: Path) -> Path:
    """The AXI shell beside a file of generated_rtl/."""
    return path.with_name(f"{rtl.ip_entity(path.parent.name)}.vhd")


def verdict(before: str, after: str) -> str:
    if before == after:
        return "the same text"
    if structure_digest(before) == structure_digest(after):
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
        before = run([find_tool("git"), "show", f"{options.against}:{earlier[name]}"], cwd=ROOT)
        said = verdict(before, (committed.folder(name) / f"{committed.entity(name)}.vhd").read_text())
        print(f"{name}: {said}", flush=True)
        changed += [name] if said == "another netlist" else []
    print(f"{len(names) - len(changed)} of {len(names)} cores have the netlist of {options.against}")
    if changed:
        raise FlowError(f"another netlist: {', '.join(changed)}", EXIT_MISMATCH)
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
