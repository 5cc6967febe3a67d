#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Takes all VHDL that goes into users' designs through the releases of GHDL and NVC on this machine: every core, every
stereo_ip, joiner, rectification, camera system and the example are analysed as VHDL-93 and VHDL-2008 and elaborated, by
GHDL synthesised too. GHDL and NVC in the environment name other releases than those in PATH."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, places
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, run_command
from flow.base.options import a_path, one_or_more
from flow.base.tools import ROOT
from flow.release import user_vhdl


def main() -> int:
    parser = ArgumentParser(prog="try_tools.py", description=__doc__)
    parser.add_argument("--tool", choices=[*user_vhdl.WAYS], action="append", help="may be given twice (default ghdl)")
    parser.add_argument("--config", action="append", metavar="NAME", help="its designs only (default: of all)")
    parser.add_argument("--jobs", type=one_or_more, default=2, metavar="N", help="designs at a time (default 2)")
    parser.add_argument("--out", type=a_path, default=ROOT / "build" / "tools", help="folder (default build/tools)")
    options = parser.parse_args()
    names = options.config or committed.known_designs()
    for name in names:
        committed.folder(name)  # refuses one without VHDL
    places.emptied_folder(options.out)
    designs, refused = user_vhdl.tops(names), 0
    for tool in options.tool or ["ghdl"]:
        for number, way in enumerate(user_vhdl.WAYS[tool]):
            found = user_vhdl.refusals(way, names, options.out / f"{tool}_{number}", options.jobs)
            for top, reason in found.items():
                print(f"{top}: {reason}")
            print(f"{way}: {len(designs) - len(found)} of {len(designs)} designs", flush=True)
            refused += len(found)
    return EXIT_MISMATCH if refused else EXIT_OK


if __name__ == "__main__":
    run_command(main)
