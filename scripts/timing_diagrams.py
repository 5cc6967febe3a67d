#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the timing diagrams of docs/integration.md from a simulation of stereo_ip, configuration tiny."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, run_command
from flow.shell import timing_diagrams


def main() -> int:
    parser = ArgumentParser(prog="timing_diagrams.py", description=__doc__)
    parser.add_argument(
        "--check",
        action="store_true",
        help="write nothing; exit code 1 when a picture is not what the simulation gives",
    )
    check = parser.parse_args().check
    return files.update(timing_diagrams.made_files(), check, "scripts/timing_diagrams.py")


if __name__ == "__main__":
    run_command(main)
