# SPDX-License-Identifier: Apache-2.0
"""The systems that the paper compares itself with: a whole frame in Verilator of a few that stand for all kinds, some
rows of one in GHDL, and both of every one whose VHDL has no run on record; minutes."""

import math

import pytest

from cover import COVERED, clocks, cover, rows
from flow.base import committed
from flow.base.configurations import configurations, outputs_per_frame
from flow.cosim import record
from flow.synthesis import manifest
from flow_commands import cosim, report, scene

TABLE = configurations()
SYSTEMS = sorted(name for name, row in TABLE.items() if row["use"] == "system")
ROWS = 2  # more where an output needs them


IN_SMALL = {  # whose whole VHDL test_cosim_options.py simulates
    (row.family, option) for row in rows().values() if row.use in (*COVERED, "tiny") for option in row.options
}


def kinds(row):
    """Its family, folded or not, and options that no smaller core has."""
    return {(row.family, "clocks_per_pixel" in row.options)} | {(row.family, o) for o in row.options} - IN_SMALL


FEW = cover({name: rows()[name] for name in SYSTEMS}, kinds, lambda row: math.sqrt(clocks(row)))


def on_record(config, least):
    """The simulators that have compared as many outputs of the VHDL that is there now."""
    folder = committed.folder(config)
    runs = record.read(folder, manifest.read(folder))
    return {name for name, run in runs.items() if run["passed"] and run["compared"] >= least}


WHOLE = [name for name in SYSTEMS if name in FEW or not on_record(name, outputs_per_frame(TABLE[name]))]
IN_GHDL = sorted(
    {min(FEW, key=lambda name: clocks(rows()[name]))} | {name for name in SYSTEMS if not on_record(name, 1)}
)


def test_there_are_systems():
    """Those that run are of every family, folded and not."""
    assert len(SYSTEMS) >= 9 and len(WHOLE) >= 6
    table = rows()
    assert {kind for name in WHOLE for kind in kinds(table[name])} == {
        kind for name in SYSTEMS for kind in kinds(table[name])
    }


@pytest.mark.parametrize("config", WHOLE)
def test_whole_frame_in_verilator(verilator, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--simulator", "verilator")
    assert process.returncode == 0, process.stdout + process.stderr
    result, wanted = report(tmp_path / "out"), outputs_per_frame(TABLE[config])
    assert (result["expected"], result["compared"], result["mismatches"]) == (wanted, wanted, 0)


@pytest.mark.parametrize("config", IN_GHDL)
def test_rows_in_ghdl(ghdl, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--rows", ROWS)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert result["compared"] == result["expected"] > 0 and result["mismatches"] == 0
