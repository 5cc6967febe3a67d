# SPDX-License-Identifier: Apache-2.0
"""Area and clock of a core, estimated from those of the cores that were measured."""

import dataclasses
import math
import statistics

import pytest

from flow.base import committed
from flow.base.configurations import configurations
from flow.planning import compared, cores, devices
from flow.planning.least_squares import fit
from flow.planning.model import REGISTERS, Core, Model
from flow.planning.registers import Registers, registers_of
from flow.planning.window_shape import WindowShape
from flow.planning.work import work_of
from flow.synthesis import manifest
from test_plan_shapes import LEFT_BITS_DECIDE

SMALL = "ecp5_25f_grade6"


def test_least_squares_finds_what_was_put_in(rng):
    true = [3.0, -0.5, 0.25]
    rows = [[rng.uniform(1, 9) for _ in true] for _ in range(30)]
    values = [sum(a * b for a, b in zip(row, true)) for row in rows]
    assert fit(rows, values) == pytest.approx(true)
    assert fit([[1.0], [1.0], [1.0]], [1.0, 2.0, 6.0]) == pytest.approx([3.0]), "the mean"
    assert fit([[1.0, 0.0, 2.0], [2.0, 0.0, 4.0]], [3.0, 6.0])[1:] == [0.0, 0.0], "a column that says nothing new"


def test_bars_on_the_estimates(errors):
    """Medians over all cores, each left out of its own estimate; block RAMs are exact but for one core of a family
    without model and two of which the bits that are left decide (test_plan_shapes.py)."""
    assert len(errors) > 50
    assert compared.size_of(one.luts_error for one in errors) < 0.12
    assert compared.size_of(one.flip_flops_error for one in errors) < 0.12
    assert compared.size_of(one.lut_sites_error for one in errors) < 0.12
    assert compared.size_of(one.mhz_error for one in errors) < 0.20
    assert {one.core.name for one in errors if one.block_rams_error} <= {"masrani_640", *LEFT_BITS_DECIDE}


def test_logic_cells_of_an_ice40(errors):
    """A flip-flop takes one, with a look-up table before it or alone. Designs that are too large count, too."""
    of_core = {one.core.name: one for one in errors if devices.netlist_of(one.core.target) == "ice40"}
    assert of_core["ambrosch2007"].core.lut_sites == 19_623 > devices.device_of("hx8k").lut_sites
    known = [one.lut_sites_error for one in of_core.values() if one.lut_sites_error is not None]
    assert len(known) >= 5 and max(map(abs, known)) < 0.12


def test_a_core_is_left_out_of_its_own_estimate(planner):
    """Others decide: a core whose record is ten times too large is estimated as before, and shows."""
    spoiled = [
        dataclasses.replace(core, result={**core.result, "luts": 10 * core.luts, "ffs": 10 * core.flip_flops})
        if core.name == "yi_270" and "luts" in core.result
        else core
        for core in planner.known
    ]
    before, after = (
        next(one for one in compared.compare(known) if one.core.name == "yi_270") for known in (planner.known, spoiled)
    )
    assert after.luts == before.luts and after.luts_error == pytest.approx((1 + before.luts_error) / 10 - 1)
    assert after.flip_flops == before.flip_flops
    assert after.flip_flops_error == pytest.approx((1 + before.flip_flops_error) / 10 - 1)


def test_factors_mean_something(planner):
    model = planner.model
    assert all(0.5 < luts < 2 for luts in model.work_luts), "a bit of work is about a look-up table"
    bits = dict(zip(REGISTERS, model.register_flip_flops))
    assert all(0.5 < bits[kind] < 1.5 for kind in Registers._fields[:4]), "a bit of a register is about a flip-flop"
    assert all(0.9 < scale < 1.1 for scale in model.family_flip_flops.values())
    assert model.covered_ffs.keys() == {"gowin"} and 0 < model.covered_ffs["gowin"] < 1, "a carry cell is a LUT, too"
    grades = model.grades()
    assert 1 == grades["ecp5"] > grades["ecp5_grade6"] > grades[SMALL]
    ecp5, ice40 = model.sites["ecp5"], model.sites["ice40"]
    assert 1 < ecp5.of_lut < 1.2 and ecp5.of_flip_flop == 0 and abs(ecp5.beside) < 100
    assert 0 < ice40.of_lut < 1 < ice40.of_flip_flop < 1.5 and ice40.beside == 0, "most registers are behind no LUT"
    measured = [
        one.lut_sites / model.lut_sites(one.luts, one.flip_flop_sites, "ecp5")
        for one in planner.known
        if one.mhz and devices.netlist_of(one.target) == "ecp5"
    ]
    assert all(0.9 < ratio < 1.1 for ratio in measured)
    clock = dict(zip(("constant", "luts", "cost", "winner", "not SAD"), model.clock))
    assert min(clock["luts"], clock["cost"], clock["winner"], clock["not SAD"]) > 0, "more work, a longer period"


def test_what_is_not_synthesised_is_not_estimated(planner):
    core = Core(WindowShape(configurations()["tiny"]))
    model = Model([one for one in planner.known if one.target == "ecp5"])
    assert model.flip_flops(core, "xc7") is model.flip_flop_sites(core, "xc7") is None
    assert model.luts(core, "xc7") is None and model.luts(core, "ecp5") > 0
    assert model.mhz(core, SMALL) is None and model.mhz(core, "ecp5") > 0
    assert model.luts(core, SMALL) == model.luts(core, "ecp5"), "the same netlist"


def test_work_follows_the_disparities_of_a_clock():
    row = configurations()["ambrosch2007_f5"]
    five, ten = (work_of(WindowShape({**row, "clocks_per_pixel": clocks})) for clocks in (5, 10))
    assert (five.costs, five.sums) == (2 * ten.costs, 2 * ten.sums) and five.beside == ten.beside


def registers(name, **changes):
    shape = cores.shape_of({**configurations()[name], **changes})
    return registers_of(shape, cores.memories_of(shape))


def test_registers_follow_the_options():
    """16 disparities of 5 taps: with a second clock for the costs each has a difference of 9 bits; with a third one two
    pairs of 9 bits and a deferred carry, and a single tap of 8 bits and one."""
    one, two, three = (registers("study", cost_clocks=clocks) for clocks in (1, 2, 3))
    assert two._replace(costs=one.costs) == three._replace(costs=one.costs) == one
    assert two.costs - one.costs == 16 * 5 * 9 and three.costs - two.costs == 16 * (2 * (9 + 1) + 9)
    assert one.sums == 16 * (11 + 11 + 12 + 12 + 13 + 13), "a column, one to four of them, five"
    assert registers("study", winner_group=4).winners < one.winners - 16 * 2 * 13, "no losers to clear, fewer levels"
    assert registers("study", median=True).words > one.words and one.paths == 0 < registers("tiny_sgm").paths


def test_registers_are_near_those_of_the_compiler():
    """Half of the cores have between 0.8 and 1.25 times the bits that Bambu counts, before any factor."""
    found = []
    for name in committed.known_configurations():
        row = configurations()[name]
        if row["family"] in cores.FAMILIES:
            said = manifest.read(committed.folder(name))["tool_report"]["register_bits"]
            found.append(abs(math.log(sum(registers(name)) / said)))
    assert len(found) > 50 and statistics.median(found) < math.log(1.25)


def test_registers_follow_the_disparities_of_a_clock():
    five, ten = (registers("ambrosch2007_f5", clocks_per_pixel=clocks) for clocks in (5, 10))
    assert five.sums == 2 * ten.sums and five.costs > 1.8 * ten.costs and five.words == ten.words


def test_flip_flops_that_have_no_place_on_gowin(planner):
    """Each LUT RAM takes the six of its tile, each carry cell one; elsewhere a core takes what it has."""
    records = {(core.name, core.target): core for core in planner.known}
    one = records["sgm_320_64_f16", "gw2ar_18"]
    cells = one.result["cells"]
    assert one.flip_flop_sites == one.flip_flops + 6 * cells["RAM16SDP4"] + cells["ALU"] == 6_589
    assert all(
        core.flip_flop_sites == core.flip_flops
        for core in planner.known
        if devices.netlist_of(core.target) != devices.netlist_of("gw2ar_18")
    )
    for core in planner.known:
        if core.target == "gw2ar_18":
            said = planner.model.flip_flop_sites(Core(cores.shape_of(core.options)), core.target)
            assert 0.88 < said / core.flip_flop_sites < 1.12, core.name


def test_every_device_has_flip_flops():
    """As nextpnr counts them: as many as LUT sites, but on Gowin six for eight."""
    for target in devices.targets():
        device = devices.device_of(target)
        eighths = 6 if devices.netlist_of(target) == "gowin" else 8
        assert device.flip_flops == device.lut_sites * eighths // 8, target


def test_what_was_routed_has_its_flip_flops(planner):
    routed = [core for core in planner.known if core.mhz]
    assert len(routed) > 80
    assert all(core.flip_flop_sites <= devices.device_of(core.target).flip_flops for core in routed)
