#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Verifies stereo_ip, the core between AXI4-Streams: random stalls, gaps, resets and broken streams, every frame
compared with the C++ core. Thousands of frames in Verilator, all scenarios under cocotb in GHDL."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.configurations import configuration
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import require_core
from flow.shell import verify


def main() -> int:
    parser = ArgumentParser(prog="verify_axi.py", description=__doc__)
    parser.add_argument(
        "--config", action="append", metavar="NAME", help="only this configuration, in Verilator; may be repeated"
    )
    parser.add_argument(
        "--frames", type=int, help="correct frames of each --config (default: those of the whole run, or 100)"
    )
    parser.add_argument("--seed", type=int, default=1, help="seed of everything random; printed at the end (default 1)")
    parser.add_argument(
        "--chunk", type=int, metavar="N", help="with one --config: only its simulation 'mixture N', to replay it"
    )
    parser.add_argument(
        "--short", action="store_true", help="the selection that the tests run: about a minute and a half"
    )
    parser.add_argument("--simulator", choices=("ghdl", "verilator"), help="only what runs in this one")
    parser.add_argument(
        "--out",
        type=a_path,
        default=verify.WORK / "verify",
        help="report.json, junit.xml, streams (default build/axi/verify)",
    )
    options = parser.parse_args()
    if options.frames is not None and (options.frames < 1 or not options.config):
        raise FlowError("--frames must be at least 1 and needs --config")
    if options.chunk is not None and len(options.config or ()) != 1:
        raise FlowError("--chunk needs one --config")
    if options.seed < 0:
        raise FlowError("--seed must be 0 or more")
    if options.config and options.simulator == "ghdl":
        raise FlowError("--config is for the frames in Verilator, so it does not go with --simulator ghdl")
    for name in options.config or ():
        configuration(name)

    frames = verify.SHORT_FRAMES if options.short else verify.FRAMES
    if options.config:
        frames = {name: options.frames or verify.FRAMES.get(name, 100) for name in options.config}
    if options.chunk is not None:
        chunks = verify.chunks_of(frames[options.config[0]])
        if options.chunk not in chunks:
            raise FlowError(f"--chunk must be 0 ... {chunks[-1]}")
    if options.simulator != "ghdl":
        for name in frames:
            require_core(name)
    run = verify.Verification(options.seed, options.out.resolve())
    if options.simulator != "ghdl":
        for name, count in frames.items():
            run.run_verilator(name, count, options.chunk)
    if options.simulator != "verilator" and not options.config:
        run.run_cocotb(verify.selections(options.short))
    return run.report()


if __name__ == "__main__":
    run_command(main)
