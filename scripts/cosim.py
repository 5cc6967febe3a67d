#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates the generated VHDL of a configuration against the C++ core on a stereo pair, to the last bit and
clock."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.cosim import job, record
from flow.cosim.simulators import SIMULATORS

MOST_SECONDS = 1e6


def main() -> int:
    parser = ArgumentParser(prog="cosim.py", description=__doc__)
    parser.add_argument("--config", required=True, help="named configuration (see stereo_hls configurations)")
    parser.add_argument("--left", required=True, type=Path, help="left image of the rectified pair")
    parser.add_argument("--right", required=True, type=Path, help="right image")
    parser.add_argument(
        "--rows",
        metavar="A:B|N",
        help="send only image rows A ... B-1, as the top of a frame; or the middle N rows, more where an output needs "
        "them",
    )
    parser.add_argument(
        "--frames", type=int, default=1, help="frames back to back; every second one upside down (default 1)"
    )
    parser.add_argument(
        "--broken",
        type=int,
        default=0,
        metavar="N",
        help="instead of frames, N faults of a stream: frames broken off, records without a start of frame, resets",
    )
    parser.add_argument(
        "--stall-percent", type=int, default=0, help="random bubbles in the input, 0 ... 95 %% (default 0)"
    )
    parser.add_argument("--seed", type=int, default=1, help="of bubbles and filler pixels (default 1)")
    parser.add_argument(
        "--fit", choices=("none", "crop", "resize"), default="none", help="how images of another size are made to fit"
    )
    parser.add_argument("--simulator", choices=sorted(SIMULATORS), default="ghdl")
    parser.add_argument("--rtl", type=Path, help="folder with manifest.json and VHDL (default generated_rtl/*/CONFIG)")
    parser.add_argument("--out", type=Path, help="where reports go (default build/cosim/CONFIG-SIMULATOR)")
    parser.add_argument(
        "--wave",
        type=Path,
        metavar="FILE",
        help=".ghw, .fst or .vcd (ghdl), .fst (verilator) around the first mismatch",
    )
    parser.add_argument(
        "--watchdog",
        dest="watchdog_seconds",
        type=float,
        default=300.0,
        metavar="SECONDS",
        help="stop a simulation that makes no progress for so long (default 300)",
    )
    parser.add_argument(
        "--record",
        action="store_true",
        help="keep the result beside the VHDL, in cosimulation.json, for docs/performance.md",
    )
    options = parser.parse_args()
    if options.record and (options.rtl or options.simulator == "original"):
        raise FlowError("--record keeps results of the VHDL in generated_rtl: no --rtl, no --simulator original")
    if options.record and options.broken:
        raise FlowError("--record keeps results of whole frames and rows: no --broken")
    if options.frames < 1:
        raise FlowError("--frames must be at least 1")
    if options.broken < 0:
        raise FlowError("--broken must be at least 0")
    if options.broken and (options.frames != 1 or options.rows):
        raise FlowError("--broken takes the place of --frames and --rows")
    if not 0 < options.watchdog_seconds < MOST_SECONDS:
        raise FlowError(f"--watchdog must be above 0 and below {MOST_SECONDS:g} seconds")
    is_kept = vars(options).pop("record")
    report = job.run_job(job.Job(**vars(options)))
    if is_kept:
        record.keep(report)
    return job.exit_code(report)


if __name__ == "__main__":
    run_command(main)
