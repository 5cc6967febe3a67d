#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sends an image pair to a board with the design of examples/boards and gets the disparity map back; or plays the same
bytes over the serial line of the simulated board, and compares the map with that of the program."""

import sys
from argparse import Namespace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path, one_or_more
from flow.base.tools import find_stereo_hls
from flow.boards import boards, compared, line, play, protocol
from flow.shell import board_vhdl

SHOWN = 3  # of the pixels that differ


def parse() -> Namespace:
    parser = ArgumentParser(prog="board.py", description=__doc__)
    parser.add_argument(
        "--board", default=boards.FIRST, help=f"{', '.join(boards.BOARDS)} (default {boards.FIRST})", metavar="NAME"
    )
    parser.add_argument("--config", metavar="NAME", help="the core on it (default: that of build_example.py)")
    way = parser.add_mutually_exclusive_group(required=True)
    way.add_argument("--port", metavar="DEVICE", help="the board's serial line, such as /dev/ttyUSB0")
    way.add_argument("--simulate", action="store_true", help="no board: simulate it, and compare as --compare does")
    parser.add_argument("--left", type=a_path, required=True, metavar="IMAGE", help="of the size that the core takes")
    parser.add_argument("--right", type=a_path, required=True, metavar="IMAGE")
    parser.add_argument("--out", type=a_path, required=True, metavar="PNG", help="grey value = disparity in pixels")
    parser.add_argument("--baud", type=one_or_more, help="of --port (default: that of the board's bit stream)")
    parser.add_argument("--compare", action="store_true", help="exit code 1 if the program's map is another one")
    parser.add_argument(
        "--simulator", choices=play.SIMULATORS, help="of --simulate (default: ghdl, for large images verilator)"
    )
    options = parser.parse_args()
    for name, needed, other in (("baud", "port", "simulate"), ("simulator", "simulate", "port")):
        if getattr(options, name) and not getattr(options, needed):
            raise FlowError(f"--{name} has no effect beside --{other}")
    return options


def main() -> int:
    options = parse()
    files.refuse_input(options.out, (options.left, options.right))
    board = boards.named(options.board)
    config = board.config if options.config is None else options.config
    sizes = board_vhdl.sizes(config)
    left, right = (compared.pixels(path, config, sizes) for path in (options.left, options.right))
    compare = options.compare or options.simulate
    if compare:
        find_stereo_hls()  # before minutes have passed
    sent = protocol.frame(left, right)
    if options.simulate:
        simulator = options.simulator or play.simulator_for(sizes)
        answer = play.Played(config, simulator).play(sent).sent
    else:
        with line.opened(options.port, options.baud or board.baud) as opened:
            answer = list(line.exchange(opened, sent, protocol.answer_bytes(sizes)))
    found = protocol.read_map(answer, sizes)
    files.write(options.out, compared.picture(found, sizes))
    print(f"{len(sent)} bytes sent, {len(answer)} came back: {options.out}")
    if not compare:
        return EXIT_OK
    different = compared.differences(found, compared.of_program(config, left, right, sizes), sizes["output_width_px"])
    print(f"{len(different)} of {len(found.disparities)} disparities differ from the program's map")
    for sentence in different[:SHOWN]:
        print(f"  {sentence}")
    return EXIT_MISMATCH if different else EXIT_OK


if __name__ == "__main__":
    run_command(main)
