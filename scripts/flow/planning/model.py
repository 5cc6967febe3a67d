# SPDX-License-Identifier: Apache-2.0
"""Look-up tables, flip-flops, block RAMs and clock of a core that was not implemented, from those that were.

  block RAMs  counted: each memory of the core becomes what yosys makes of it (ram.py); nothing is fitted
  flip-flops  a number for each kind of register (registers.py) and constants, fitted; on a family that is not ECP5
              one number more, for all of them
  LUTs        LUT RAM and what chooses among RAMs, counted too, and a number for each kind of work (work.py), fitted;
              on a family that is not ECP5 one number more, for all work
  clock       the logarithm of the period is a constant, a slope over the logarithm of the LUTs, four options that
              leave more or less logic in a clock, and a constant for each device and grade

Fits are plain least squares of relative errors, over the committed cores whose families work.py knows.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from ..base import committed
from ..implementation import figures
from ..implementation.record import Result
from ..implementation.results import Configuration
from . import cores, devices, ram
from .least_squares import fit
from .path_shape import PathShape
from .registers import registers_of
from .window_shape import WindowShape
from .work import work_of

BASE = "ecp5"  # the target with most cores
WORK = ("costs", "sums", "winners", "paths", "what is there once")  # as the fields of Work
REGISTERS = (  # as Registers, then what a core has once: every core, and more of them other than block matching
    "costs",
    "sums",
    "winners",
    "paths",
    "words of memories, pixels and the map",
    "constant",
    "block matching in several clocks a pixel pair",
    "semi-global matching",
    "semi-global matching in several clocks a pixel pair",
)
CLOCK = (
    "constant",
    "logarithm of the LUTs",
    "cost clock less than 3",
    "winner more in a group",
    "cost not SAD",
    "clock more in front of a folded core",
)


@dataclass(frozen=True)
class Implemented:
    """A committed core on one target."""

    name: str
    options: Mapping[str, Any]
    target: str
    result: Result

    @property
    def luts(self) -> int:
        return figures.lut_count(self.result)

    @property
    def flip_flops(self) -> int:
        return self.result["ffs"]

    @property
    def lut_sites(self) -> int | None:
        """Of the device, also where it has too few of them."""
        short = self.result.get("does_not_fit", {}).get(devices.logic_cell(devices.netlist_of(self.target)))
        return short["used"] if short else self.result.get("lut_sites")

    @property
    def flip_flop_sites(self) -> int:
        """Flip-flops of the device that it takes, with those that have no place beside another cell."""
        covered = devices.covered_ffs(devices.netlist_of(self.target))
        cells = self.result["cells"]
        return self.flip_flops + sum(cells.get(cell, 0) * count for cell, count in covered.items())

    @property
    def mhz(self) -> float | None:
        return self.result["fmax_mhz"]["median"] if "fmax_mhz" in self.result else None


class Core:
    """What the model reads of a core."""

    def __init__(self, shape: WindowShape) -> None:
        self.options = shape.options
        self.work = work_of(shape)
        self._memories = cores.memories_of(shape)
        has_paths, once = isinstance(shape, PathShape), (False, True)
        kinds = [(has_paths, shape.is_folded) == (paths, folded) for paths in once for folded in once]
        self.registers = (*registers_of(shape, self._memories), 1, *kinds[1:])
        self._mapped: dict[str, ram.Mapped] = {}

    def mapped(self, family: str) -> ram.Mapped | None:
        """What its memories become; None where nothing is known of the RAMs."""
        if family not in ram.FAMILIES:
            return None
        if family not in self._mapped:
            keeps = cores.shows_word_before(self.options)
            self._mapped[family] = ram.mapped(self._memories, ram.FAMILIES[family], keeps)
        return self._mapped[family]

    def memory_luts(self, family: str) -> int:
        """LUT RAM, and what chooses among RAMs; where nothing is known of them, those of BASE."""
        known = family if family in ram.FAMILIES else BASE
        found = self.mapped(known)
        return found.lut_rams * ram.FAMILIES[known].luts + found.choice_bits if found else 0

    def lut_ram_covered_ffs(self, family: str) -> int:
        """Flip-flops of the device that LUT RAM leaves no place for."""
        found = self.mapped(family)
        return found.lut_rams * devices.covered_ffs(family).get(ram.FAMILIES[family].lut_cell, 0) if found else 0


def implemented() -> list[Implemented]:
    """Every committed core of any family, on each target of its record."""
    found, known = [], devices.every_target()
    for name in committed.known_configurations():
        core = Configuration(name, stale_is_none=True)
        found += [
            Implemented(name, core.parameters, target, result)
            for target, result in core.targets.items()
            if target in known
        ]
    return found


def is_modelled(core: Implemented) -> bool:
    return core.options["family"] in cores.FAMILIES


class Sites(NamedTuple):
    """LUT sites of a routed design: for each look-up table, for each flip-flop where the two share a logic cell, and
    those beside, as what leads to carry chains takes."""

    of_lut: float
    of_flip_flop: float
    beside: float


class Model:
    def __init__(self, measured: Sequence[Implemented], known: Mapping[str, Core] | None = None) -> None:
        """known: what was read of the cores before."""
        self._measured = [core for core in measured if is_modelled(core)]
        self._cores: Mapping[str, Core] = known or {
            core.name: Core(cores.shape_of(core.options)) for core in self._measured
        }

    def without(self, name: str) -> Model:
        """Of all cores but one."""
        return Model([core for core in self._measured if core.name != name], self._cores)

    @cached_property
    def work_luts(self) -> list[float]:
        """Of a bit of each kind of work."""
        known = [(self._cores[core.name], core.luts) for core in self._measured if core.target == BASE]
        rows = [[bits / luts for bits in core.work] for core, luts in known]
        return fit(rows, [1 - core.memory_luts(BASE) / luts for core, luts in known])

    def _worked_luts(self, core: Core) -> float:
        """On BASE, without memories."""
        return sum(bits * luts for bits, luts in zip(core.work, self.work_luts))

    def _base_luts(self, core: Core) -> float:
        return core.memory_luts(BASE) + self._worked_luts(core)

    @cached_property
    def family_luts(self) -> dict[str, float]:
        """{family: its LUTs for one of BASE, without memories}, where a core was synthesised for it."""
        found = {}
        for family in devices.netlists():
            netlists = {core.name: core.luts for core in self._measured if devices.netlist_of(core.target) == family}
            of_family = [(self._cores[name], luts) for name, luts in netlists.items()]
            rows = [[self._worked_luts(core) / luts] for core, luts in of_family]
            if rows:
                found[family] = fit(rows, [1 - core.memory_luts(family) / luts for core, luts in of_family])[0]
        return found

    def luts(self, core: Core, target: str) -> int | None:
        family = devices.netlist_of(target)
        scale = self.family_luts.get(family)
        if scale is None:
            return None
        return max(1, round(core.memory_luts(family) + scale * self._worked_luts(core)))

    @cached_property
    def register_flip_flops(self) -> list[float]:
        """Of a bit of each kind of register, as REGISTERS."""
        known = [(self._cores[core.name], core.flip_flops) for core in self._measured if core.target == BASE]
        return fit([[bits / count for bits in core.registers] for core, count in known], [1.0] * len(known))

    def _base_flip_flops(self, core: Core) -> float:
        return sum(bits * factor for bits, factor in zip(core.registers, self.register_flip_flops))

    def _netlists(self, family: str) -> dict[str, Implemented]:
        """{name: a core that was synthesised for a family}"""
        return {core.name: core for core in self._measured if devices.netlist_of(core.target) == family}

    @cached_property
    def family_flip_flops(self) -> dict[str, float]:
        """{family: its flip-flops for one of BASE}, where a core was synthesised for it."""
        found = {}
        for family in devices.netlists():
            netlists = self._netlists(family).items()
            rows = [[self._base_flip_flops(self._cores[name]) / core.flip_flops] for name, core in netlists]
            if rows:
                found[family] = fit(rows, [1.0] * len(rows))[0]
        return found

    def flip_flops(self, core: Core, target: str) -> int | None:
        scale = self.family_flip_flops.get(devices.netlist_of(target))
        return None if scale is None else max(1, round(scale * self._base_flip_flops(core)))

    @cached_property
    def covered_ffs(self) -> dict[str, float]:
        """{family: flip-flops of the device that have no place for each look-up table that is no LUT RAM}"""
        found = {}
        for family in devices.netlists():
            rows, values = [], []
            for name, core in self._netlists(family).items():
                luts = core.luts - self._cores[name].memory_luts(family)
                rows.append([luts / core.luts])
                beside = core.flip_flop_sites - core.flip_flops - self._cores[name].lut_ram_covered_ffs(family)
                values.append(beside / core.luts)
            if rows and devices.covered_ffs(family):
                found[family] = fit(rows, values)[0]
        return found

    def flip_flop_sites(self, core: Core, target: str) -> int | None:
        """Flip-flops of the device that it takes, with those that have no place beside another cell."""
        own, luts, family = self.flip_flops(core, target), self.luts(core, target), devices.netlist_of(target)
        if own is None or luts is None:
            return None
        covered = self.covered_ffs.get(family, 0.0) * (luts - core.memory_luts(family))
        return round(own + covered + core.lut_ram_covered_ffs(family))

    @cached_property
    def sites(self) -> dict[str, Sites]:
        """By family, of its routed cores."""
        found = {}
        for family in devices.netlists():
            shares = bool(devices.logic_cell(family))
            routed = [
                (core.luts, core.flip_flop_sites if shares else 1, core.lut_sites)
                for core in self._measured
                if devices.netlist_of(core.target) == family and core.lut_sites
            ]
            if routed:
                of_lut, other = fit([[luts / sites, more / sites] for luts, more, sites in routed], [1.0] * len(routed))
                found[family] = Sites(of_lut, other, 0.0) if shares else Sites(of_lut, 0.0, other)
        return found

    def lut_sites(self, luts: float, flip_flops: float, target: str) -> int | None:
        """Of a design with so many look-up tables and flip-flops."""
        sites = self.sites.get(devices.netlist_of(target))
        return sites and max(1, round(sites.of_lut * luts + sites.of_flip_flop * flip_flops + sites.beside))

    @cached_property
    def _clocked(self) -> list[str]:
        """Targets with a routed core."""
        routed = {core.target for core in self._measured if core.mhz}
        return [target for target in devices.targets() if target in routed]

    @cached_property
    def clock(self) -> list[float]:
        """As CLOCK, then the constant of each target of _clocked but the first."""
        routed = [(core, core.mhz) for core in self._measured if core.mhz]
        rows = [self._clock_row(self._cores[core.name], core.target) for core, _ in routed]
        return fit(rows, [-math.log(mhz) for _, mhz in routed])

    def _clock_row(self, core: Core, target: str) -> list[float]:
        o = core.options
        is_direct_sad = o["cost"] == "sad" and o["aggregation"] == "direct"
        own = [
            1.0,
            math.log(max(1.0, self._base_luts(core))),
            float(3 - o["cost_clocks"]) if is_direct_sad else 0.0,
            float(o["winner_group"] - 2),
            float(o["cost"] != "sad"),
            float(o.get("front_clocks", 1) - 1),
        ]
        return own + [float(target == other) for other in self._clocked[1:]]

    def mhz(self, core: Core, target: str) -> float | None:
        if target not in self._clocked:
            return None
        return math.exp(-sum(x * factor for x, factor in zip(self._clock_row(core, target), self.clock)))

    def grades(self) -> dict[str, float]:
        """{target: its clock for a MHz of the first one}"""
        constants = [0.0, *self.clock[len(CLOCK) :]]
        return {target: math.exp(-constant) for target, constant in zip(self._clocked, constants)}
