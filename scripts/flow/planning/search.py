# SPDX-License-Identifier: Apache-2.0
"""Which of the candidates fit a device."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Union

from ..base.configurations import configurations
from . import cores, ram
from .candidates import Camera, Candidate, candidates, key_of, twins
from .devices import Device
from .model import Implemented, Model, core_of, family_of, implemented

MEASURED, ESTIMATE = "measured", "estimate"


@dataclass(frozen=True)
class Number:
    """`of`: the core that was measured, or nothing of an estimate."""

    value: Union[int, float]
    of: str = ""

    @property
    def kind(self) -> str:
        return MEASURED if self.of else ESTIMATE

    def as_json(self) -> dict[str, Any]:
        value = self.value if isinstance(self.value, int) else round(self.value, 1)
        return {"value": value, "is": self.kind, **({"of": self.of} if self.of else {})}


@dataclass(frozen=True)
class Place:
    """Where a core shall go. fill: percent of its LUT sites that may be taken; margin: percent by which the expected clock
    shall be above the needed one where it is an estimate."""

    target: str
    device: Device
    fill: float
    margin: float


@dataclass(frozen=True)
class Planned:
    """A candidate with its numbers; None where nothing says them."""

    candidate: Candidate
    needed_mhz: float
    mhz: Number | None
    luts: Number | None
    lut_sites: Number | None
    block_rams: Number | None
    reasons: tuple[str, ...]  # why it does not fit
    load: float = math.inf  # the largest share that it takes of LUT sites, block RAMs or clock
    row: str | None = None  # that is there already

    @property
    def fits(self) -> bool:
        return not self.reasons


class Planner:
    def __init__(self, known: list[Implemented] | None = None) -> None:
        self.known = implemented() if known is None else known
        self.model = Model(self.known)
        self._twins = twins(configurations())

    def plan(self, camera: Camera, place: Place) -> list[Planned]:
        """Every candidate that can be built or says why not, in the order of its algorithms and speeds."""
        return [self._planned(candidate, camera, place) for candidate in candidates(camera)]

    def _planned(self, candidate: Candidate, camera: Camera, place: Place) -> Planned:
        needed = camera.needed_mhz(candidate.clocks_a_frame)
        if candidate.problem:
            return Planned(candidate, needed, None, None, None, None, (candidate.problem,))
        name = self._twins.get(key_of(candidate.options))
        mhz, luts, sites, block_rams = self._numbers(candidate, place.target, name)
        shares = list(_shares(luts, sites, block_rams, place))
        if mhz:
            margin = 0 if mhz.of else place.margin
            beside = f", with {margin:g} % above them" if margin else ""
            text = f"{needed:.0f} MHz are needed{beside}, {mhz.value:.0f} expected"
            shares.append((needed * (1 + margin / 100) / mhz.value, text))
        else:
            shares.append((math.inf, f"no clock is known on {place.target}"))
        reasons = tuple(text for share, text in shares if share > 1)
        load = max(share for share, _ in shares)
        return Planned(candidate, needed, mhz, luts, sites, block_rams, reasons, load, name)

    def _numbers(self, candidate: Candidate, target: str, name: str | None) -> tuple[Number | None, ...]:
        of_name = {core.target: core for core in self.known if core.name == name}
        netlist = of_name.get(target) or next(
            (core for core in of_name.values() if family_of(core.target) == family_of(target)), None
        )
        core, family = core_of(candidate.shape), ram.family_of(target)
        if netlist:
            luts, block_rams = Number(netlist.luts, netlist.name), Number(netlist.result["block_rams"], netlist.name)
            sites = Number(netlist.result["lut_sites"], netlist.name) if "lut_sites" in netlist.result else None
        else:
            luts, block_rams, sites = _estimated(self.model.luts(core, target)), None, None
            if family:
                memories = cores.memories_of(candidate.shape)
                keeps = cores.shows_word_before(candidate.family)
                block_rams = Number(ram.mapped(memories, family, keeps).block_rams)
        scale = self.model.sites.get(family_of(target))
        if sites is None and luts and scale:
            sites = Number(round(luts.value * scale))
        here = of_name.get(target)
        mhz = Number(here.mhz, here.name) if here and here.mhz else _estimated(self.model.mhz(core, target))
        return mhz, luts, sites, block_rams


def _estimated(value: float | None) -> Number | None:
    return None if value is None else Number(value)


def _shares(
    luts: Number | None, sites: Number | None, block_rams: Number | None, place: Place
) -> Iterator[tuple[float, str]]:
    """(how much of what there is a core takes, in words)"""
    most, taken = int(place.device.lut_sites * place.fill / 100), sites or luts
    if taken is None:
        yield math.inf, f"no LUTs are known on {place.target}"
    else:
        yield taken.value / max(1, most), f"{taken.value:,} of {most:,} LUT sites"
    if block_rams is None:
        yield math.inf, f"no block RAMs are known on {place.target}"
    elif block_rams.value:
        most = place.device.block_rams
        yield block_rams.value / most if most else math.inf, f"{block_rams.value} of {most} block RAMs"


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


def ordered(plans: Iterable[Planned]) -> list[Planned]:
    """The best quality first."""
    return sorted(plans, key=lambda planned: (wrong_pixels(planned), _luts(planned)))


def _luts(planned: Planned) -> float:
    return planned.luts.value if planned.luts else 0


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
