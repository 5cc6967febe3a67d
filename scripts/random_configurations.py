#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws configurations at random from the whole space of options, builds their clocked cores and compares these with
the definition: frames back to back, bubbles, resets, broken frames."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import farm
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import one_or_more
from flow.cosim import random_cores


def main() -> int:
    parser = ArgumentParser(prog="random_configurations.py", description=__doc__)
    parser.add_argument("--family", default="block_matching", help="algorithm family (default block_matching)")
    parser.add_argument("--count", type=one_or_more, default=20, help="how many configurations (default 20)")
    parser.add_argument(
        "--seed", type=int, help="seed of the configurations and their images; printed (default: another one each time)"
    )
    parser.add_argument(
        "--differs",
        action="append",
        default=[],
        metavar="OPTION",
        help="only configurations in which this option is not its default, may be repeated",
    )
    farm.add_options(parser, os.cpu_count() or 1, "cores")
    parser.add_argument(
        "--row", action="append", metavar="ROW", help="a given row, as in configurations.hpp, instead of random ones"
    )
    options = parser.parse_args()
    if options.seed is not None and not 0 <= options.seed < 1 << 64:
        raise FlowError("--seed must be 0 ... 2^64 - 1")
    seed = random_cores.new_seed() if options.seed is None else options.seed
    random_cores.source_folder(options.family)  # an unknown family is refused first
    if options.row:
        parser.refuse_beside("--row", "--family", "--seed", "--jobs", "--scheduler")
    if options.row:
        cores = [random_cores.core_of(row) for row in options.row]
    else:
        cores = random_cores.draw(options.family, options.count, seed, options.differs)
    with farm.of(options, random_cores.tools) as workers:
        return random_cores.run_family(options.family, cores, seed, workers, options.differs)


if __name__ == "__main__":
    run_command(main)
