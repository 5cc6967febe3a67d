# SPDX-License-Identifier: Apache-2.0
"""Which of the candidates fit a device."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..base.configurations import configurations, option
from . import cores
from .candidates import SAME_MAP, Algorithm, Camera, Candidate, candidates, key_of, serving, twins
from .devices import Device, netlist_of
from .model import Core, Implemented, Model, implemented

MEASURED, ESTIMATE = "measured", "estimate"


@dataclass(frozen=True)
class Number:
    """`of`: the core that was measured, or nothing of an estimate."""

    value: float  # a count is an int
    of: str = ""

    @property
    def kind(self) -> str:
        return MEASURED if self.of else ESTIMATE

    def as_json(self) -> dict[str, Any]:
        value = self.value if isinstance(self.value, int) else round(self.value, 1)
        return {"value": value, "is": self.kind, **({"of": self.of} if self.of else {})}


@dataclass(frozen=True)
class Numbers:
    """Of a core on a device; None where nothing says one."""

    mhz: Number | None = None
    luts: Number | None = None
    lut_sites: Number | None = None
    flip_flops: Number | None = None
    flip_flop_sites: Number | None = None
    block_rams: Number | None = None
    block_units: int | None = None  # the same as the device counts them, where that is another number

    @property
    def blocks(self) -> float | None:
        """Of those that the device has."""
        if self.block_units is not None:
            return self.block_units
        return self.block_rams.value if self.block_rams else None


@dataclass(frozen=True)
class Place:
    """Where a core shall go. fill: percent of its LUT sites and of its flip-flops that may be taken; margin: percent by
    which the expected clock shall be above the needed one where it is an estimate."""

    target: str
    device: Device
    fill: float
    margin: float


@dataclass(frozen=True)
class Planned:
    """A candidate on a device."""

    candidate: Candidate
    needed_mhz: float
    numbers: Numbers
    reasons: tuple[str, ...]  # why it does not fit
    load: float = math.inf  # the largest share that it takes of LUT sites, flip-flops, block RAMs or clock
    row: str | None = None  # that has the same options

    @property
    def fits(self) -> bool:
        return not self.reasons


class Planner:
    def __init__(self, algorithms: Sequence[Algorithm], known: list[Implemented] | None = None) -> None:
        self._algorithms = algorithms
        self.known = implemented() if known is None else known
        self.model = Model(self.known)
        self._table = configurations()
        self._twins, self._serving = twins(self._table), serving(self._table)

    def plan(self, camera: Camera, place: Place) -> list[Planned]:
        """Every candidate that can be built or says why not, in the order of its algorithms and speeds."""
        return [self._planned(candidate, camera, place) for candidate in candidates(camera, self._algorithms)]

    def _planned(self, candidate: Candidate, camera: Camera, place: Place) -> Planned:
        needed = camera.needed_mhz(candidate.clocks_a_frame)
        if candidate.problem:
            return Planned(candidate, needed, Numbers(), (candidate.problem,))
        key = key_of(candidate.options)
        name = self._twins.get(key)
        if name is None and not SAME_MAP & camera.settings.keys():
            name = self._serving.get(key)
        of_name = {core.target: core for core in self.known if core.name == name}
        numbers = self.numbers(candidate.options, place.target, of_name)
        shares = list(_shares(numbers, place))
        mhz = numbers.mhz
        if mhz:
            margin = 0 if mhz.of else place.margin
            beside = f", with {margin:g} % above them" if margin else ""
            text = f"{needed:.0f} MHz are needed{beside}, {mhz.value:.0f} expected"
            shares.append((needed * (1 + margin / 100) / mhz.value, text))
        else:
            shares.append((math.inf, f"no clock is known on {place.target}"))
        reasons = tuple(text for share, text in shares if share > 1)
        load = max(share for share, _ in shares)
        wanted = {o: value for o, value in candidate.options.items() if o not in SAME_MAP}
        is_there = name is not None and all(option(self._table[name], o) == value for o, value in wanted.items())
        return Planned(candidate, needed, numbers, reasons, load, name if is_there else None)

    def numbers(self, options: Mapping[str, Any] | None, target: str, measured: Mapping[str, Implemented]) -> Numbers:
        """measured: the same core by target, as far as it was implemented; options: None of a family without model."""
        here = measured.get(target)
        netlist = here or next(
            (core for core in measured.values() if netlist_of(core.target) == netlist_of(target)), None
        )
        found = self._estimates(options, target) if options else Numbers()
        if netlist:
            luts, block_rams = Number(netlist.luts, netlist.name), Number(netlist.result["block_rams"], netlist.name)
            found = replace(found, luts=luts, block_rams=block_rams, lut_sites=None)
            flip_flops = Number(netlist.flip_flops, netlist.name)
            found = replace(found, flip_flops=flip_flops, flip_flop_sites=Number(netlist.flip_flop_sites, netlist.name))
            if "lut_sites" in netlist.result:
                found = replace(found, lut_sites=Number(netlist.result["lut_sites"], netlist.name))
        if found.lut_sites is None and found.luts:
            registers = found.flip_flop_sites.value if found.flip_flop_sites else 0
            found = replace(found, lut_sites=_estimated(self.model.lut_sites(found.luts.value, registers, target)))
        return replace(found, mhz=self._clock(target, measured) or found.mhz)

    def _clock(self, target: str, measured: Mapping[str, Implemented]) -> Number | None:
        """Of the same core here, or from another device or grade by what lies between the two."""
        here = measured.get(target)
        if here and here.mhz:
            return Number(here.mhz, here.name)
        grades = self.model.grades()
        for core in measured.values():
            if core.mhz and netlist_of(core.target) == netlist_of(target) and {target, core.target} <= grades.keys():
                return Number(core.mhz * grades[target] / grades[core.target])
        return None

    def _estimates(self, options: Mapping[str, Any], target: str) -> Numbers:
        core = Core(cores.shape_of(options))
        mapped = core.mapped(netlist_of(target))
        return Numbers(
            mhz=_estimated(self.model.mhz(core, target)),
            luts=_estimated(self.model.luts(core, target)),
            flip_flops=_estimated(self.model.flip_flops(core, target)),
            flip_flop_sites=_estimated(self.model.flip_flop_sites(core, target)),
            block_rams=Number(mapped.block_rams) if mapped else None,
            block_units=mapped.block_units if mapped else None,
        )


def _estimated(value: float | None) -> Number | None:
    return None if value is None else Number(value)


def _shares(numbers: Numbers, place: Place) -> Iterator[tuple[float, str]]:
    """(how much of what there is a core takes, in words)"""
    most, taken = int(place.device.lut_sites * place.fill / 100), numbers.lut_sites or numbers.luts
    if taken is None:
        yield math.inf, f"no LUTs are known on {place.target}"
    else:
        yield taken.value / max(1, most), f"{taken.value:,} of {most:,} LUT sites"
    most, registers = int(place.device.flip_flops * place.fill / 100), numbers.flip_flop_sites
    if registers is None:
        yield math.inf, f"no flip-flops are known on {place.target}"
    else:
        yield registers.value / max(1, most), f"{registers.value:,} of {most:,} flip-flop sites"
    blocks = numbers.blocks
    if blocks is None:
        yield math.inf, f"no block RAMs are known on {place.target}"
    elif blocks:
        most = place.device.block_rams
        yield blocks / most if most else math.inf, f"{blocks} of {most} block RAMs"


def wrong_pixels(planned: Planned) -> float:
    """Of the mean pair, for an order by quality."""
    values = [float(text.split()[0]) for text in planned.candidate.algorithm.wrong.values()]
    return sum(values) / len(values)


def best(plans: Iterable[Planned]) -> list[Planned]:
    """Of each algorithm the one that fits and takes the fewest LUTs, the best quality first."""
    found: dict[str, Planned] = {}
    for planned in plans:
        title = planned.candidate.algorithm.title
        if planned.fits and (title not in found or _luts(planned) < _luts(found[title])):
            found[title] = planned
    return ordered(found.values())


NEAR = 1.0  # percent of the pixels


def recommended(plans: Sequence[Planned]) -> int:
    """Which one takes the fewest LUTs of those that have about as few wrong pixels as the best: its place."""
    least = min(wrong_pixels(planned) for planned in plans)
    near = [place for place, planned in enumerate(plans) if wrong_pixels(planned) <= least + NEAR]
    return min(near, key=lambda place: _luts(plans[place]))


def ordered(plans: Iterable[Planned]) -> list[Planned]:
    """The best quality first."""
    return sorted(plans, key=lambda planned: (wrong_pixels(planned), _luts(planned)))


def _luts(planned: Planned) -> float:
    return planned.numbers.luts.value if planned.numbers.luts else 0


def closest(plans: Iterable[Planned]) -> list[Planned]:
    """Of each algorithm of which nothing fits the one that is nearest to it; where none can be built, one of these."""
    plans = list(plans)
    fitting = {planned.candidate.algorithm.title for planned in plans if planned.fits}
    found: dict[str, Planned] = {}
    for planned in plans:
        title = planned.candidate.algorithm.title
        if title not in fitting and (title not in found or planned.load < found[title].load):
            found[title] = planned
    return ordered(found.values())
