#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the bit stream of examples/boards for a board: a core, its self test, and a serial line that takes pairs."""

import sys
from argparse import Namespace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.boards import boards, build, record
from flow.shell import board_vhdl


def parse() -> Namespace:
    parser = ArgumentParser(prog="build_example.py", description=__doc__)
    parser.add_argument(
        "--board", default=boards.FIRST, help=f"{', '.join(boards.BOARDS)} (default {boards.FIRST})", metavar="NAME"
    )
    own = ", ".join(f"{board.name} {board.config}" for board in boards.BOARDS.values())
    parser.add_argument("--config", metavar="NAME", help=f"the core (default: {own})")
    parser.add_argument("--seed", type=int, default=record.SEED, help="seed of place and route (default %(default)s)")
    parser.add_argument(
        "--out", type=a_path, help="folder of everything that is made (default build/example/BOARD)", metavar="FOLDER"
    )
    parser.add_argument(
        "--core",
        type=a_path,
        metavar="FILE",
        help=f"only write {board_vhdl.CORE_FILE} of the core, for a flow of your own",
    )
    parser.add_argument("--record", action="store_true", help=f"keep area and clock in {files.shown(record.FILE)}")
    pages = parser.add_mutually_exclusive_group()
    pages.add_argument("--page", action="store_true", help="build nothing: write the table of what was kept")
    pages.add_argument("--check", action="store_true", help="the same; exit code 1 when it is not up to date")
    options = parser.parse_args()
    if options.page or options.check:
        parser.refuse_beside("--page" if options.page else "--check")
    if options.core:
        parser.refuse_beside("--core", "--board", "--config")
    if options.seed < 1:
        raise FlowError("--seed must be 1 or more")
    if options.record and options.seed != record.SEED:
        raise FlowError(f"--record keeps what seed {record.SEED} gives")
    return options


def main() -> int:
    options = parse()
    if options.page or options.check:
        return files.update({record.PAGE: record.page()}, options.check, "scripts/build_example.py --page")
    board = boards.named(options.board)
    config = board.config if options.config is None else options.config
    if options.core:
        files.write(options.core, board_vhdl.core_text(config))
        return EXIT_OK
    out = options.out or ROOT / "build" / "example" / board.name
    made_of = record.digest(board, config)
    result = build.build(board, config, out.resolve(), options.seed)
    found, holds = result.figures, board.target.holds
    assert holds is not None
    print(f"{board.title}, {config}: {found['lut_sites']} of {holds.lut_sites} LUT sites")
    print(f"{found['flip_flops']} flip-flops, {found['block_rams']} of {holds.block_rams} block RAMs")
    print(f"{found['fmax_mhz']} MHz routed where {board.clock_mhz} are needed")
    print(f"bit stream: {files.shown(result.bit_stream)} ({result.bit_stream.stat().st_size} bytes)")
    if options.record:
        record.keep(board, config, result, made_of)
    return EXIT_OK if found["fmax_mhz"] >= board.clock_mhz else EXIT_MISMATCH


if __name__ == "__main__":
    run_command(main)
