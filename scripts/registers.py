#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the VHDL package and the documentation table of the registers from hls/rtl/registers.json."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, run_command
from flow.shell import registers


def main() -> int:
    parser = ArgumentParser(prog="registers.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit code 1 when a file is not up to date")
    return files.update(registers.made_files(), parser.parse_args().check, "scripts/registers.py")


if __name__ == "__main__":
    run_command(main)
