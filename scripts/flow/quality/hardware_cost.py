# SPDX-License-Identifier: Apache-2.0
"""Look-up tables of a choice of options, from the committed results of the configurations that are there for a `study`:
each was synthesised and routed at one size, most with one option beside the plain core.

  measured  a configuration of the family has exactly these options
  estimate  the plain core and, for each option, what that option alone costs; and for another number of disparities
            than the family's, the look-up tables in proportion to it
  absent    an option whose configuration is not measured yet
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol, Union

from ..base import committed, rtl
from ..base.configurations import Parameters
from ..implementation import figures
from ..implementation.record import Area
from ..implementation.results import Configuration
from ..synthesis.manifest import with_use

BASE = "study"
TARGET = "ecp5"
MEASURED, ESTIMATE, ABSENT = "measured", "estimate", "absent"
# What decides the result. The other parameters are the size, and how the core is built.
OPTIONS = (
    "window_px",
    "min_disparity",
    "pixel_bits",
    "reference",
    "cost",
    "census_width_px",
    "census_height_px",
    "prefilter",
    "prefilter_cap",
    "ties",
    "left_right_threshold",
    "uniqueness_percent",
    "texture_threshold",
    "subpixel",
    "median",
)
_BUILD = (
    "pixels_per_clock",
    "cost_clocks",
    "winner_group",
    "slice_disparities",
    "width_px",
    "height_px",
    "disparities",
)
_NEEDS = {"texture": "prefilter"}  # an option that is only there with another one
# Of two sizes of the plain 3x3 core, to see how far proportion to the disparities holds.
_SCALE_CHECK = ("study_w3", "ambrosch2007")


@dataclass(frozen=True)
class Cost:
    kind: str
    luts: int | None
    sources: tuple[str, ...] = ()  # configurations that were added up
    missing: tuple[str, ...] = ()  # options without a measured configuration


Feature = Union[int, str, tuple[Union[str, int], ...]]
Features = dict[str, Feature]


class Implemented(Protocol):
    """What is read of a results.Configuration."""

    @property
    def parameters(self) -> Parameters: ...

    @property
    def targets(self) -> Mapping[str, Area]: ...


def features(parameters: Parameters) -> Features:
    """What costs hardware, by name: thresholds of any value cost the same check."""
    p: Mapping[str, Any] = parameters
    census = (p["census_width_px"], p["census_height_px"]) if p["cost"] == "census" else ()
    return {
        "window": p["window_px"],
        "pixel_bits": rtl.pixel_bits_of(p),
        "cost": (p["cost"], *census),
        "prefilter": p["prefilter"],
        "reference": p["reference"],
        "ties": p["ties"],
        "min_disparity": p["min_disparity"],
        "left_right": p["left_right_threshold"] >= 0,
        "uniqueness": p["uniqueness_percent"] > 0,
        "texture": p["texture_threshold"] > 0,
        "subpixel": p["subpixel"],
        "median": p["median"],
    }


_Key = tuple[tuple[str, Feature], ...]


class Study:
    """The measured configurations. `known`: others than the committed folders, by name."""

    def __init__(self, known: Mapping[str, Implemented] | None = None) -> None:
        if known is None:
            names = [*with_use("study"), *_SCALE_CHECK]
            known = {name: Configuration(name, stale_is_none=True) for name in names}
        self._known = known
        self.base = known[BASE]
        self._members: dict[_Key, tuple[str, int | None]] = {}  # (configuration, LUTs)
        for name, configuration in sorted(known.items()):
            if self._is_member(configuration):
                self._add(name, configuration)

    def _is_member(self, configuration: Implemented) -> bool:
        ours: Mapping[str, object] = configuration.parameters
        plain: Mapping[str, object] = self.base.parameters
        return all(ours[key] == plain[key] for key in _BUILD)

    def _add(self, name: str, configuration: Implemented) -> None:
        """Direct and recursive sums give the same map: the smaller one counts."""
        key = _key(features(configuration.parameters))
        result = configuration.targets.get(TARGET)
        luts = figures.lut_count(result) if result else None
        before = self._members.get(key)
        if before is None or before[1] is None or (luts is not None and luts < before[1]):
            self._members[key] = (name, luts)

    @property
    def disparities(self) -> int:
        return self.base.parameters["disparities"]

    @property
    def measured(self) -> list[str]:
        return sorted(
            name
            for name, configuration in self._known.items()
            if self._is_member(configuration) and TARGET in configuration.targets
        )

    def options_of(self, name: str) -> dict[str, object]:
        """The options in which a configuration differs from the plain core."""
        ours: Mapping[str, object] = self._known[name].parameters
        plain: Mapping[str, object] = self.base.parameters
        return {key: ours[key] for key in OPTIONS if ours[key] != plain[key]}

    def cost(self, parameters: Parameters) -> Cost:
        wanted = features(parameters)
        exact = self._members.get(_key(wanted))
        if exact and exact[1] is not None:
            return self._scaled(MEASURED, exact[1], (exact[0],), parameters)
        plain = features(self.base.parameters)
        base_luts = self._members[_key(plain)][1]
        if base_luts is None:
            return Cost(ABSENT, None, (), ("the plain core",))
        luts, sources = base_luts, [BASE]
        missing: list[str] = []
        for option, value in wanted.items():
            if value == plain[option]:
                continue
            extra = self._extra(plain, option, wanted)
            if extra is None:
                missing.append(option if isinstance(value, bool) else _word(option, value))
            else:
                luts += extra[0]
                sources.append(extra[1])
        if missing:
            return Cost(ABSENT, None, tuple(sources), tuple(missing))
        return self._scaled(ESTIMATE, luts, tuple(sources), parameters)

    def _extra(self, plain: Features, option: str, wanted: Features) -> tuple[int, str] | None:
        """(LUTs that one option adds, the configuration that says so), or None."""
        without = dict(plain)
        if option in _NEEDS:
            without[_NEEDS[option]] = wanted[_NEEDS[option]]
        before = self._members.get(_key(without))
        after = self._members.get(_key({**without, option: wanted[option]}))
        if not before or not after or before[1] is None or after[1] is None:
            return None
        return after[1] - before[1], after[0]

    def _scaled(self, kind: str, luts: int, sources: tuple[str, ...], parameters: Parameters) -> Cost:
        if parameters["disparities"] == self.disparities:
            return Cost(kind, luts, sources)
        return Cost(ESTIMATE, round(luts * parameters["disparities"] / self.disparities), sources)

    def scale_check(self) -> str | None:
        """A sentence on how far proportion to the disparities holds, or None when that is not measured."""
        small, large = (self._known.get(name) for name in _SCALE_CHECK)
        if not (small and large and TARGET in small.targets and TARGET in large.targets):
            return None
        scale = large.parameters["disparities"] / small.parameters["disparities"]
        guess, truth = figures.lut_count(small.targets[TARGET]) * scale, figures.lut_count(large.targets[TARGET])
        return (
            f"{_SCALE_CHECK[0]} in proportion to the disparities of {_SCALE_CHECK[1]} gives {guess:,.0f} LUT4, "
            f"measured are {truth:,}: {100 * (guess / truth - 1):+.0f} %"
        )


def of_configuration(name: str, disparities: int, as_it_is: bool = True) -> Cost:
    """What a committed configuration takes, in proportion to its disparities for another number of them. not as_it_is:
    with the other image as reference, which costs about the same."""
    if name not in committed.known_configurations():
        return Cost(ABSENT, None, (), (name,))
    known = Configuration(name, stale_is_none=True)
    if TARGET not in known.targets:
        return Cost(ABSENT, None, (), (name,))
    luts, own = figures.lut_count(known.targets[TARGET]), known.parameters["disparities"]
    if disparities == own and as_it_is:
        return Cost(MEASURED, luts, (name,))
    return Cost(ESTIMATE, round(luts * disparities / own), (name,))


def _key(values: Features) -> _Key:
    return tuple(sorted(values.items(), key=lambda item: item[0]))


def _word(option: str, value: Feature) -> str:
    if isinstance(value, tuple):
        name, *size = value
        return str(name) + (f" {size[0]}x{size[1]}" if size else "")
    return f"window {value}x{value}" if option == "window" else f"{option} {value}"
