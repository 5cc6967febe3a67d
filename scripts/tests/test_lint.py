# SPDX-License-Identifier: Apache-2.0
"""The hand-written VHDL passes its checks, and the checks can fail."""

import shutil

import pytest

from flow.shell import design
from flow_commands import call

FAULTS = {
    "unused signal": (
        "stereo_frames",
        "architecture rtl of stereo_frames is\n",
        "architecture rtl of stereo_frames is\n  signal nobody : std_logic;\n",
        "nobody",
    ),
    "hidden name": (
        "stream_credit",
        "    variable change :",
        "    variable lent : integer;\n    variable change :",
        "lent",
    ),
    "loop": (
        "stereo_frames",
        "current <= oldest xor (result_valid and result_start);",
        "current <= oldest xor (result_valid and current);",
        "logic loop",
    ),
    "latch": (
        "stereo_frames",
        "current <= oldest xor (result_valid and result_start);",
        "process (all) begin if result_start = '1' then current <= oldest xor result_valid; end if; end process;",
        "latch",
    ),
    "capital letter": ("stream_fifo", "leaves := waits", "LEAVES := waits", "capital"),
    "a value kept": ("camera_queue", "read_address <= write_address;", "read_address <= read_address;", "to itself"),
    "long line": ("stream_fifo", "-- A queue", "-- " + 130 * "x", "longer"),
    "no licence": ("stream_fifo", "-- SPDX-License-Identifier: Apache-2.0\n", "", "SPDX"),
    "a name that Verilog reserves": ("stereo_frames", "frame_leaves", "final", "%Error"),
}


def test_no_findings(ghdl, verilator, yosys):
    process = call("lint.py")
    assert process.returncode == 0, process.stdout + process.stderr


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_is_found(ghdl, verilator, yosys, tmp_path, fault):
    file, old, new, word = FAULTS[fault]
    for path in [*design.shell_files(), *design.joiner_files()]:
        shutil.copy(path, tmp_path)
    text = (tmp_path / f"{file}.vhd").read_text()
    assert old in text
    (tmp_path / f"{file}.vhd").write_text(text.replace(old, new))
    process = call("lint.py", "--rtl", tmp_path)
    assert process.returncode in (1, 4) and word in process.stdout + process.stderr, process.stdout + process.stderr
