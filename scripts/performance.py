#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/performance.md and its plot from the committed manifests and implementation results, and prints the
evaluations a second per LUT of each routed configuration. Runs no tool."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files, rtl
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.implementation.results import Configuration
from flow.pages import clock_logic, performance


def main() -> int:
    parser = ArgumentParser(prog="performance.py", description=__doc__)
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    chosen.add_argument("--config", metavar="NAME", help="only print the recorded numbers of one configuration")
    options = parser.parse_args()
    if options.config:
        return show(options.config)
    routed = performance.routed_configurations()
    texts = {performance.PAGE: performance.page(), clock_logic.PICTURE: clock_logic.picture(clock_logic.points(routed))}
    code = files.update(texts, options.check, "scripts/performance.py")
    if not options.check:
        print(performance.one_number_table(routed))
    return code


def show(name: str) -> int:
    if name not in rtl.known_configurations():
        raise FlowError(f"unknown configuration '{name}'; known are: {', '.join(rtl.known_configurations())}")
    configuration = Configuration(name)
    tables = [performance.per_clock_table, performance.speed_table, performance.shell_table, performance.area_table]
    for make in tables:
        print(make([configuration]), end="\n\n")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
