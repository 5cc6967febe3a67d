#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the bit stream of examples/ecp5 for the ULX3S board: the core of configuration tiny between AXI4-Streams."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.shell import example


def main() -> int:
    parser = ArgumentParser(prog="build_example.py", description=__doc__)
    parser.add_argument("--seed", type=int, default=1, help="seed of place and route (default 1)")
    parser.add_argument(
        "--out",
        type=a_path,
        default=ROOT / "build" / "example",
        help="folder of everything that is made (default build/example)",
    )
    options = parser.parse_args()
    result = example.build(options.out.resolve(), options.seed)
    print(
        f"{result['luts']} LUT sites, {result['flip_flops']} flip-flops, "
        f"{result['fmax_mhz']} MHz routed where {example.CLOCK_MHZ} are needed"
    )
    print(f"bit stream: {result['bit_stream']} ({result['bit_stream'].stat().st_size} bytes)")
    return EXIT_OK if result["fmax_mhz"] >= example.CLOCK_MHZ else EXIT_MISMATCH


if __name__ == "__main__":
    run_command(main)
