#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the hand-written VHDL in hls/rtl and examples: GHDL's warnings, latches and loops in the netlist, layout. Any
finding is an error."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.shell import lint


def main() -> int:
    parser = ArgumentParser(prog="lint.py", description=__doc__)
    parser.add_argument("--config", default="tiny", help="configuration whose core stands in the shell (default tiny)")
    parser.add_argument("--rtl", type=a_path, help="folder with the shell's VHDL (default hls/rtl)")
    options = parser.parse_args()
    found = lint.check(options.config, ROOT / "build" / "lint", options.rtl)
    print(f"{found} findings")
    return EXIT_MISMATCH if found else EXIT_OK


if __name__ == "__main__":
    run_command(main)
