#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/options.md and docs/configurations.md, every option and every configuration, from their declarations in
the C++ as stereo_hls knows them, and from the committed manifests."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, run_command
from flow.pages import reference


def main() -> int:
    parser = ArgumentParser(prog="reference.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the pages are up to date")
    options = parser.parse_args()
    return files.update(reference.pages(), options.check, "scripts/reference.py")


if __name__ == "__main__":
    run_command(main)
