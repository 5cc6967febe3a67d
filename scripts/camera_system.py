#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the VHDL of examples/camera_system, two cameras to depths in one design, or lists what to compile."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.tools import ROOT
from flow.system.template import SYSTEMS, text, vhdl_files


def main() -> int:
    parser = ArgumentParser(prog="camera_system.py", description=__doc__)
    parser.add_argument("--system", action="append", metavar="NAME", help=f"{', '.join(SYSTEMS)} (default: all)")
    parser.add_argument("--write", action="store_true", help="write camera_system_NAME.vhd again")
    parser.add_argument("--check", action="store_true", help="refuse where that would change it")
    options = parser.parse_args()
    names = options.system or list(SYSTEMS)
    for name in names:
        if name not in SYSTEMS:
            raise FlowError(f"unknown system '{name}'; known are: {', '.join(SYSTEMS)}")
    if options.write or options.check:
        texts = {SYSTEMS[name].path: text(SYSTEMS[name]) for name in names}
        return files.update(texts, options.check, "scripts/camera_system.py --write")
    for name in names:
        for path in vhdl_files(SYSTEMS[name]):
            print(path.relative_to(ROOT))
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
