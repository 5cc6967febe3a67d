#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the table of docs/dynamic_range.md and its picture: bad pixels of each frame of moving scenes in which new
objects appear, with search windows that follow the scene and with the whole range."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, run_command
from flow.quality import recovery


def main() -> int:
    parser = ArgumentParser(prog="recovery.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    arguments = parser.parse_args()
    return files.update(recovery.pages(), arguments.check, "scripts/recovery.py")


if __name__ == "__main__":
    run_command(main)
