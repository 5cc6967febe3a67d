#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/features.md, what each option costs, from the committed manifests and implementation results. Runs no
tool."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, run_command
from flow.pages import features


def main() -> int:
    parser = ArgumentParser(prog="features.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    options = parser.parse_args()
    return files.update({features.PAGE: features.page()}, options.check, "scripts/features.py")


if __name__ == "__main__":
    run_command(main)
