#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/performance.md from the committed manifests and implementation results. Runs no tool."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files, rtl
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.implementation.results import Configuration
from flow.pages import performance


def main() -> int:
    parser = ArgumentParser(prog="performance.py", description=__doc__)
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    chosen.add_argument("--config", metavar="NAME", help="only print the recorded numbers of one configuration")
    options = parser.parse_args()
    if options.config:
        return show(options.config)
    return files.update({performance.PAGE: performance.page()}, options.check, "scripts/performance.py")


def show(name: str) -> int:
    if name not in rtl.known_configurations():
        raise FlowError(f"unknown configuration '{name}'; known are: {', '.join(rtl.known_configurations())}")
    configuration = Configuration(name)
    for make in (performance.per_clock_table, performance.speed_table, performance.area_table):
        print(make([configuration]), end="\n\n")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
