#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the VHDL of configurations, of matching cores and of stages, from the C++ with Bambu, into
generated_rtl/FAMILY/NAME/."""

import sys
from collections.abc import Iterable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import rtl
from flow.base.configurations import PLANNED, Configuration, configuration, designs
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import find_bambu
from flow.shell import template
from flow.synthesis.generate import generate
from flow.synthesis.manifest import check_program, freshness, refresh as keep_sources


def check(names: Iterable[str], table: dict[str, Configuration]) -> int:
    """Says for each configuration whether its committed VHDL follows from the sources. Needs no Bambu."""
    check_program(table)
    found = {name: freshness(name, table[name]) for name in names}
    for name, (reasons, by_code) in found.items():
        fresh = "up to date" + (", as clang makes the same code of the changed sources" if by_code else "")
        print(f"{name}: {'stale: ' + '; '.join(reasons) if reasons else fresh}")
    again = " ".join(f"--config {name}" for name, (reasons, _) in found.items() if reasons)
    if again:
        raise FlowError(
            f"the generated VHDL is not what its sources give; run scripts/synthesize.py {again}", EXIT_MISMATCH
        )
    return EXIT_OK


def refresh(names: Iterable[str], table: dict[str, Configuration]) -> int:
    """Lets the manifests name the sources as they are now where clang makes the same code of them."""
    check_program(table)
    for name in names:
        reasons, by_code = freshness(name, table[name])
        if by_code and not reasons:
            keep_sources(name, table[name])
            print(f"{name}: refreshed, clang makes the same code of the changed sources")
        else:
            print(f"{name}: {'stale: ' + '; '.join(reasons) if reasons else 'up to date'}")
    return EXIT_OK


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
        help="let manifests name the sources as they are now where clang makes the same code of them; needs no Bambu",
    )
    parser.add_argument(
        "--out", type=a_path, help="another folder than generated_rtl, one subfolder for each configuration"
    )
    options = parser.parse_args()
    table = designs()
    names = options.config or sorted(name for name, row in table.items() if row["use"] != PLANNED)
    for name in names:
        configuration(name, table)
    if options.check:
        return check(names, table)
    if options.refresh:
        return refresh(names, table)
    check_program(table)
    find_bambu()
    for name in names:
        report = generate(name, out=options.out / name if options.out else None)["tool_report"]
        if options.out is None and not rtl.is_stage(table[name]):
            template.write(name)
        print(
            f"{name}: {report['states']} states ({report['loop_states']} in the loop), "
            f"{report['registers']} registers ({report['registers_named']} named as in C++), "
            f"{report['memory_bits']} memory bits, "
            f"Bambu estimates {report['flip_flops']} flip-flops and {report['mhz']} MHz"
        )
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
