#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Two cameras to depths in one design, examples/camera_system: lists what to compile, writes its VHDL, implements it,
and plays frames into it that must come out as those of the software pipeline."""

import sys
from argparse import Namespace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.implementation import nextpnr
from flow.implementation.targets import ROUTED
from flow.system import frame, implementation, record, streams, summary
from flow.system.play import WORK
from flow.system.template import SYSTEMS, System, text, vhdl_files


def parse() -> Namespace:
    parser = ArgumentParser(prog="camera_system.py", description=__doc__)
    parser.add_argument("--system", action="append", metavar="NAME", help=f"{', '.join(SYSTEMS)} (default: all)")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--write", action="store_true", help="write camera_system_NAME.vhd again")
    what.add_argument("--check", action="store_true", help="write nothing; exit code 1 if a file is not up to date")
    what.add_argument("--implement", action="store_true", help="area and clock on an FPGA, by yosys and nextpnr")
    what.add_argument(
        "--frame", action="store_true", help="one whole frame of 640x480 in Verilator, and the latency of its rows"
    )
    what.add_argument(
        "--streams", type=int, metavar="N", help="N or more frames of random streams, some broken, in Verilator"
    )
    what.add_argument("--show", action="store_true", help="print what camera_system_NAME.json says")
    parser.add_argument("--record", action="store_true", help="keep the result in camera_system_NAME.json")
    parser.add_argument(
        "--seeds", type=int, nargs="+", default=[1], metavar="N", help="seed of place and route (default 1)"
    )
    parser.add_argument("--router", choices=nextpnr.ROUTERS, help="of nextpnr (default: that of the family)")
    parser.add_argument(
        "--target", metavar="TARGET", help=f"of --implement: {', '.join(ROUTED)} (default: that of the system)"
    )
    parser.add_argument(
        "--pair", type=a_path, metavar="FOLDER", help="of --frame: left.png and right.png instead of a generated scene"
    )
    options = parser.parse_args()
    check(options)
    measured = ["--system", "--record"]
    if options.implement:
        parser.refuse_beside("--implement", *measured, "--seeds", "--router", "--target")
    elif options.frame:
        parser.refuse_beside("--frame", *measured, "--pair")
    elif options.streams is not None:
        parser.refuse_beside("--streams", *measured)
    else:
        modes = [mode for mode in ("--write", "--check", "--show") if getattr(options, mode[2:])]
        parser.refuse_beside(*(modes or ["the list of files"]), "--system")
    return options


def check(options: Namespace) -> None:
    for name in options.system or ():
        if name not in SYSTEMS:
            raise FlowError(f"unknown system '{name}'; known are: {', '.join(SYSTEMS)}")
    measures = options.implement or options.frame or options.streams is not None
    if measures and len(options.system or ()) != 1:
        raise FlowError("--implement, --frame and --streams take one --system")
    if options.record and not measures:
        raise FlowError("--record keeps a result of --implement, --frame or --streams")
    if options.pair and (options.record or not options.frame):
        raise FlowError("--pair goes with --frame, without --record: the pair is not part of this repository")
    if options.target and not options.implement:
        raise FlowError("--target goes with --implement")
    if options.target and options.target not in ROUTED:
        raise FlowError(f"unknown target '{options.target}'; known are: {', '.join(ROUTED)}")
    if options.target and options.record:
        raise FlowError("--record keeps a result of the system's own target, without --target")
    if options.streams is not None and options.streams < 1:
        raise FlowError("--streams must be 1 or more")
    if min(options.seeds) < 1:
        raise FlowError("--seeds must be 1 or more")


def measure(system: System, options: Namespace) -> int:
    work, made_of = WORK / "runs" / system.name, record.design(system)

    def keep(section: str, content: object) -> None:
        if options.record:
            record.keep(system, section, content, made_of)

    if options.implement:
        target = options.target or system.target
        keep("implementation", implementation.implement(system, sorted(set(options.seeds)), options.router, target))
        return EXIT_OK
    if options.frame:
        seen = frame.run_frame(system, options.pair, work / "frame")
        keep("frame", seen)
        print("\n".join(summary.of_frame(system, seen)))
        return EXIT_OK
    played = streams.run(system, options.streams, work / "streams")
    keep("streams", played)
    print(summary.of_streams(system, played))
    return EXIT_OK if streams.passed(played) else EXIT_MISMATCH


def main() -> int:
    options = parse()
    chosen = [SYSTEMS[name] for name in options.system or SYSTEMS]
    if options.write or options.check:
        texts = {system.path: text(system) for system in chosen}
        return files.update(texts, options.check, "scripts/camera_system.py --write")
    if options.implement or options.frame or options.streams is not None:
        return measure(chosen[0], options)
    for system in chosen:
        if options.show:
            print("\n".join(summary.of_record(system)))
        else:
            print(*(path.relative_to(ROOT) for path in vhdl_files(system)), sep="\n")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
