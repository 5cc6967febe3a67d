# SPDX-License-Identifier: Apache-2.0
"""Bit streams of examples/boards: tiny on a board of each family, and the smallest of the boards' own cores. The others
take nextpnr minutes each: test_boards.py looks at their kept results."""

import json
import re

import pytest

from conftest import where_reachable
from flow.base import committed
from flow.base.tools import ROOT
from flow.boards.boards import BOARDS
from flow.implementation import nextpnr
from flow.shell import board_vhdl
from flow.synthesis import manifest
from flow_commands import call

ONE_OF_EACH_FAMILY = {board.target.family.name: name for name, board in BOARDS.items()}.values()


@pytest.mark.parametrize("board, config", [*((name, "tiny") for name in ONE_OF_EACH_FAMILY), ("icebreaker", None)])
def test_board_meets_its_clock(ghdl, tmp_path, board, config):
    where_reachable(lambda: nextpnr.find_nextpnr(BOARDS[board].target.family))
    own = ("--config", config) if config else ()
    process = call("build_example.py", "--board", board, *own, "--out", tmp_path / "made")
    assert process.returncode == 0, process.stdout + process.stderr
    # Fewer flip-flops than registers in the core would be a design that was optimised away.
    flip_flops = int(re.search(r"^(\d+) flip-flops", process.stdout, re.MULTILINE)[1])
    folder = committed.folder(config or BOARDS[board].config)
    assert flip_flops > 0.95 * manifest.read(folder)["tool_report"]["register_bits"]
    stream = ROOT / re.search(r"^bit stream: (\S+) \(", process.stdout, re.MULTILINE)[1]
    assert stream.parent == tmp_path / "made" and stream.stat().st_size > 100_000
    # All that the file of constraints names is a port of the design.
    netlist = json.loads((tmp_path / "made" / "netlist.json").read_text())
    ports = netlist["modules"][board_vhdl.TOP]["ports"]
    bits = {f"{name}[{bit}]" for name, port in ports.items() for bit in range(len(port["bits"]))} | {*ports}
    text = (board_vhdl.FOLDER / BOARDS[board].constraints).read_text()
    named = set(re.findall(r'^(?:LOCATE COMP|IO_LOC|set_io) "?([\w\[\]]+)', text, re.MULTILINE))
    assert len(named) == sum(len(port["bits"]) for port in ports.values()) and named <= bits
