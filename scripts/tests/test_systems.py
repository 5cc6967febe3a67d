# SPDX-License-Identifier: Apache-2.0
"""The systems that the paper compares itself with: a whole frame of each in Verilator, some rows in GHDL; minutes."""

import pytest

from flow.base.configurations import configurations
from flow_commands import cosim, report, scene

TABLE = configurations()
SYSTEMS = sorted(name for name, row in TABLE.items() if row["use"] == "system")
ROWS = 2  # more where an output needs them


def test_there_are_systems():
    assert len(SYSTEMS) >= 9


@pytest.mark.parametrize("config", SYSTEMS)
def test_whole_frame_in_verilator(verilator, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--simulator", "verilator")
    assert process.returncode == 0, process.stdout + process.stderr
    row, result = TABLE[config], report(tmp_path / "out")
    outputs = row["output_width_px"] * row["output_height_px"] // row["pixels_per_clock"]
    assert (result["expected"], result["compared"], result["mismatches"]) == (outputs, outputs, 0)


@pytest.mark.parametrize("config", SYSTEMS)
def test_rows_in_ghdl(ghdl, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--rows", ROWS)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert result["compared"] == result["expected"] > 0 and result["mismatches"] == 0
