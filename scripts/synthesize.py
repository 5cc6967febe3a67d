#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the VHDL of configurations, of matching cores and of stages, from the C++ with Bambu: what people take into
generated_rtl/FAMILY/NAME/, what only tests and studies need into hls_tb/evidence/FAMILY.tar.xz."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, farm, files, rtl
from flow.base.configurations import PLANNED, Configuration, configuration, designs
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import find_bambu, require_core
from flow.shell import template
from flow.synthesis import bambu, manifest
from flow.synthesis.generate import generate
from flow.synthesis.manifest import check_program
from flow.synthesis.presentation.present import present
from flow.synthesis.versions import versions


def check(names: Iterable[str], table: dict[str, Configuration]) -> int:
    """Says for each configuration whether its committed VHDL follows from the sources. Needs no Bambu."""
    check_program(table)
    found = {name: manifest.freshness(name, table[name]) for name in names}
    for name, (reasons, by_code) in found.items():
        fresh = "up to date" + (", as clang makes the same code of the changed sources" if by_code else "")
        print(f"{name}: {'stale: ' + '; '.join(reasons) if reasons else fresh}")
    again = " ".join(f"--config {name}" for name, (reasons, _) in found.items() if reasons)
    if again:
        raise FlowError(
            f"the generated VHDL is stale, its sources have changed; run scripts/synthesize.py {again}", EXIT_MISMATCH
        )
    return EXIT_OK


def presented(config: str, folder: Path, entry: manifest.Manifest) -> dict[str, str]:
    """{file: content} of VHDL and manifest that are to stand in place of those of `folder`, as a person reads them;
    empty where that is so already."""
    file = f"{rtl.kind_of(entry['parameters']).entity(config)}.vhd"
    before = (folder / file).read_text()
    text = present(before)
    if text == before:
        return {}
    now: manifest.Manifest = {**entry, "files": {file: manifest.digest_of(text.encode())}}
    return {file: text, committed.MANIFEST: manifest.text(now)}


def refresh(names: Iterable[str], table: dict[str, Configuration]) -> int:
    """Lets the manifests name the sources as they are now where clang makes the same code of them, and writes the
    shells again that no longer follow from the manifests, and VHDL that is not presented as it is now done."""
    check_program(table)
    changes = []
    for name in names:
        folder = committed.folder(name)
        entry, contents, said = manifest.read(folder), {}, []
        reasons, by_code = manifest.freshness(name, table[name])
        if by_code and not reasons:
            entry = manifest.refreshed(name, table[name])
            contents[committed.MANIFEST] = manifest.text(entry)
            said.append("refreshed, clang makes the same code of the changed sources")
        if not rtl.is_stage(table[name]) and not template.is_fresh(name, entry):
            contents |= template.file(name, entry)
            said.append("its shell is written again")
        if not reasons and (again := presented(name, folder, entry)):
            contents |= again
            said.append("its VHDL is presented anew")
        if contents:
            changes.append(manifest.change(entry, contents))
        said += [f"stale: {'; '.join(reasons)}"] if reasons else []
        print(f"{name}: {'; '.join(said) or 'up to date'}")
    committed.keep(changes)
    return EXIT_OK


def make(name: str, row: Configuration, out: Path | None) -> manifest.ToolReport:
    """The VHDL of one configuration, into OUT/NAME or to where it belongs, there with its shell."""
    if out is not None:
        entry = generate(name, out / name)
        for file, text in presented(name, out / name, entry).items():
            files.write(out / name / file, text)
        return entry["tool_report"]
    with tempfile.TemporaryDirectory() as work:
        folder = Path(work) / name
        entry = generate(name, folder)
        contents = {path.name: path.read_text() for path in folder.iterdir()} | presented(name, folder, entry)
        contents |= {} if rtl.is_stage(row) else template.file(name, entry)
        committed.keep([manifest.change(entry, contents)])
    return entry["tool_report"]


def main() -> int:
    parser = ArgumentParser(prog="synthesize.py", description=__doc__)
    parser.add_argument(
        "--config",
        action="append",
        metavar="NAME",
        help="configuration, may be repeated (default: all but planned ones)",
    )
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--check", action="store_true", help="only say whether the committed VHDL is up to date; needs no Bambu"
    )
    what.add_argument(
        "--refresh",
        action="store_true",
        help="update the manifests of cores whose changed sources compile to the same code in clang, write stale "
        "shells again, and present VHDL anew; needs no Bambu",
    )
    parser.add_argument(
        "--out",
        type=a_path,
        help="another folder, with a subfolder for each configuration; changes no committed file",
    )
    farm.add_options(parser, 1, "configurations in Bambu")
    options = parser.parse_args()
    table = designs()
    names = options.config or sorted(name for name, row in table.items() if row["use"] != PLANNED)
    for name in names:
        configuration(name, table)
    if options.check or options.refresh:
        parser.refuse_beside("--check" if options.check else "--refresh", "--config")
    if options.check:
        return check(names, table)
    if options.refresh:
        return refresh(names, table)
    check_program(table)
    find_bambu()
    for name in names:
        require_core(name)
    if options.scheduler or (len(names) > 1 and options.jobs != 1):
        words = ["--out", str(options.out.resolve())] if options.out else []
        with farm.of(options, versions) as workers:
            commands = {name: ["--config", name, *words] for name in names}
            return farm.run_each(workers, "synthesize.py", commands, bambu.WORK / "logs")
    for name in names:
        report = make(name, table[name], options.out)
        print(
            f"{name}: {report['states']} states ({report['loop_states']} in the loop), "
            f"{report['registers']} registers ({report['registers_named']} named as in C++), "
            f"{report['memory_bits']} memory bits, "
            f"Bambu estimates {report['flip_flops']} flip-flops and {report['mhz']} MHz"
        )
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
