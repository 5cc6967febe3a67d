#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/performance.md, its plot, the camera's table of docs/integration.md and the table of README.md from the
committed manifests, implementation results and docs/quality.md, and prints the evaluations a second per LUT of each
routed configuration. Runs no tool."""

import sys
from pathlib import Path
from typing import Optional

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, files
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import megahertz
from flow.implementation.results import Configuration
from flow.pages import camera, clock_logic, performance, products


def main() -> int:
    parser = ArgumentParser(prog="performance.py", description=__doc__)
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--check", action="store_true", help="only say whether the pages are up to date")
    chosen.add_argument("--config", metavar="NAME", help="only print the recorded numbers of one configuration")
    parser.add_argument("--mhz", type=megahertz, help="with --config: what it does at a camera's clock")
    options = parser.parse_args()
    if options.config:
        return show(options.config, options.mhz)
    if options.mhz:
        raise FlowError("--mhz needs --config")
    routed = performance.routed_configurations()
    texts = {
        performance.PAGE: performance.page(),
        clock_logic.PICTURE: clock_logic.picture(clock_logic.points(routed)),
        camera.PAGE: camera.page(),
        products.PAGE: products.page(),
    }
    code = files.update(texts, options.check, "scripts/performance.py")
    if not options.check:
        print(performance.one_number_table(routed))
    return code


def show(name: str, mhz: Optional[float]) -> int:
    if name not in committed.known_configurations():
        raise FlowError(f"unknown configuration '{name}'; known are: {', '.join(committed.known_configurations())}")
    if mhz:
        print(camera.camera_table([Configuration(name, stale_is_none=True)], mhz))
        return EXIT_OK
    configuration = Configuration(name)
    tables = [performance.per_clock_table, performance.speed_table, performance.device_table, performance.shell_table]
    tables.append(performance.area_table)
    for make in tables:
        print(make([configuration]), end="\n\n")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
