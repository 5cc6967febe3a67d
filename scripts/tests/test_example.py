# SPDX-License-Identifier: Apache-2.0
"""The example for an ECP5 board goes through place and route. The fast set routes its core: test_implementation.py."""

import os

from conftest import where_reachable
from flow.base import committed
from flow.implementation import nextpnr
from flow.implementation.targets import ECP5
from flow.synthesis import manifest
from flow_commands import call


def test_example_meets_its_clock(ghdl, yosys, tmp_path):
    where_reachable(lambda: nextpnr.find_nextpnr(ECP5))
    process = call("build_example.py", "--out", tmp_path / "example")
    assert process.returncode == 0, process.stdout + process.stderr
    # Fewer flip-flops than registers in the core would be an example that was optimised away.
    flip_flops = int(process.stdout.rpartition(" LUT sites, ")[2].split()[0])
    assert flip_flops > 0.95 * manifest.read(committed.folder("tiny"))["tool_report"]["register_bits"]
    assert os.path.getsize(tmp_path / "example" / "example.bit") > 100_000
