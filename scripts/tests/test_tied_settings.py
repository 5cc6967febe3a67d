# SPDX-License-Identifier: Apache-2.0
"""Settings whose ports are tied to the configuration's own numbers: nearly no area. Prints it."""

import json
import re

import pytest

from conftest import where_reachable
from cover import with_slow
from flow.base import committed, ghdl as ghdl_flow, rtl
from flow.base.configurations import designs
from flow.base.tools import run
from flow.implementation import yosys as yosys_flow
from flow.implementation.families.ecp5 import Ecp5
from flow.implementation.families.family import GENERIC, TOP, Family
from flow.implementation.figures import lut_count
from flow.synthesis import manifest

# Left alone, abc9 spends look-up tables on the shortest delay that the slowest path of a netlist allows, so another
# slowest path changes the area of all blocks: docs/logic.md has figures. So both versions get the same target.
DELAY_PS = 4500
OPERATIONS = "operations.json"  # adders, multiplexers, registers ... before they are mapped
PREPARE = f"scratchpad -set abc9.D {DELAY_PS}; {GENERIC}; tee -q -o {OPERATIONS} stat -json"


class AreaOnly(Family):
    """ECP5 without place and route and the steps before it."""

    name, synthesis, luts, ffs, block_rams = "ecp5", Ecp5.synthesis, Ecp5.luts, Ecp5.ffs, Ecp5.block_rams
    prepare = PREPARE


# (with ports, without, largest difference in percent). One pair for the size, whose ports end in blocks that all
# families share, and one for the settings of each family.
PAIRS = [
    ("tiny_settings_full", "tiny_full_all", 2),
    ("tiny_size", "tiny", 2),
    ("tiny_sgm_settings", "tiny_sgm_all", 2),
    ("tiny_trellis_settings", "tiny_trellis", 2),
    ("tiny_phase_settings", "tiny_phase_checks", 2),
]
FAST = [PAIRS[1]]  # the synthesis of the others takes up to a minute


def design(config, work):
    """(Verilog of the core, its entity)"""
    entity = committed.entity(config)
    return ghdl_flow.to_verilog(manifest.vhdl_files(committed.folder(config)), work, entity), entity


def with_top(verilog, entity, tied=()):
    """`tied`: settings whose ports get a number each."""
    return re.sub(rf"\bmodule {entity}\b", "module inner", verilog) + top_of(verilog, entity, dict(tied))


def area(verilog, work):
    """(LUT4, flip-flops)"""
    work.mkdir()
    found = yosys_flow.synthesize(AreaOnly(), verilog, work).area
    return lut_count(found), found["ffs"]


def operations(work):
    return json.loads((work / OPERATIONS).read_text())["design"]["num_cells"]


def prepared(verilog, work):
    """Number of operations; a part of the time that the whole synthesis takes."""
    work.mkdir()
    (work / f"{TOP}.v").write_text(verilog)
    (work / "prepare.ys").write_text(f"read_verilog {TOP}.v\n{PREPARE}\n")
    run([*yosys_flow.find_yosys(), "-s", "prepare.ys"], cwd=work)
    return operations(work)


def top_of(verilog, entity, tied):
    """A module around the core with all ports but the tied ones."""
    ports = re.search(rf"module {entity}\s*\((.*?)\);", verilog, re.DOTALL)
    found = re.findall(r"(input|output)\s+(\[\d+:0\])?\s*(\w+)", ports.group(1))
    assert set(tied) <= {name for *_, name in found}
    outer = ", ".join(f"{way} {width} {name}" for way, width, name in found if name not in tied)
    inner = ", ".join(f".{name}({tied.get(name, name)})" for *_, name in found)
    return f"\nmodule {TOP}({outer});\n  inner core({inner});\nendmodule\n"


@pytest.mark.parametrize("with_ports, without, largest", with_slow(PAIRS, FAST))
def test_tied_settings_cost_little(ghdl, tmp_path, with_ports, without, largest):
    where_reachable(yosys_flow.find_yosys)
    settings = rtl.settings_of(designs()[with_ports])
    assert any(setting.largest > 0 for setting in settings)
    tied = [(setting.name, f"{setting.bits}'d{setting.start}") for setting in settings]
    core, plain = design(with_ports, tmp_path), design(without, tmp_path)
    luts, ffs = area(with_top(*core, tied), tmp_path / "tied")
    plain_luts, plain_ffs = area(with_top(*plain), tmp_path / "plain")
    more, more_ffs = (100 * (a / b - 1) for a, b in ((luts, plain_luts), (ffs, plain_ffs)))
    print(f"{with_ports}, tied: {luts} LUT4 ({more:+.1f} %), {ffs} flip-flops ({more_ffs:+.1f} %)")
    assert max(more, more_ffs) <= largest
    assert prepared(with_top(*core), tmp_path / "free") > operations(tmp_path / "tied"), "the ports do nothing"
