# SPDX-License-Identifier: Apache-2.0
"""Look-up tables of a choice of options, from the committed results of the configurations that are there for a `study`:
each was synthesised and routed at one size, most with one option beside the plain core.

  measured  a configuration of the study has exactly these options
  estimate  of that size, by the model that plan.py has (flow/planning/model.py)
  absent    of a configuration that is not measured, and whose family has no model
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol, Union

from ..base import committed, rtl
from ..base.configurations import Parameters
from ..implementation import figures
from ..implementation.record import Area
from ..implementation.results import Configuration
from ..planning import cores
from ..planning.model import Core, Model, implemented
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
SUMS = ("direct", "recursive")  # which give the same map: the smaller core counts


@dataclass(frozen=True)
class Cost:
    kind: str
    luts: int | None
    sources: tuple[str, ...] = ()  # the configuration that was measured
    missing: tuple[str, ...] = ()  # the one that was not


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
    """The measured configurations. `known`: others than the committed folders, by name; `model`: of other cores."""

    def __init__(self, known: Mapping[str, Implemented] | None = None, model: Model | None = None) -> None:
        self._model = Model(implemented()) if model is None else model
        if known is None:
            known = {name: Configuration(name, stale_is_none=True) for name in with_use("study")}
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
        exact = self._members.get(_key(features(parameters)))
        if exact and exact[1] is not None and parameters["disparities"] == self.disparities:
            return Cost(MEASURED, exact[1], (exact[0],))
        chosen: Mapping[str, Any] = parameters
        options = {**self.base.parameters, **{name: chosen[name] for name in OPTIONS}}
        options["disparities"] = parameters["disparities"]
        return _estimate(self._model, [{**options, "aggregation": sums} for sums in SUMS])


def _estimate(model: Model, choices: Iterable[Mapping[str, Any]]) -> Cost:
    """The smallest of some cores."""
    luts = [luts for options in choices if (luts := model.luts(Core(cores.shape_of(options)), TARGET))]
    return Cost(ESTIMATE, min(luts)) if luts else Cost(ABSENT, None)


def of_configuration(name: str, disparities: int, as_it_is: bool = True) -> Cost:
    """What a configuration takes, with another number of disparities by the model, of a family without one in
    proportion to them. not as_it_is: with the other image as reference, which costs about the same."""
    if name not in committed.known_configurations():
        return Cost(ABSENT, None, (), (name,))
    known = Configuration(name, stale_is_none=True)
    own = known.parameters["disparities"]
    if TARGET in known.targets and disparities == own and as_it_is:
        return Cost(MEASURED, figures.lut_count(known.targets[TARGET]), (name,))
    if known.parameters["family"] in cores.FAMILIES:
        return _estimate(Model(implemented()), [{**known.parameters, "disparities": disparities}])
    if TARGET not in known.targets:
        return Cost(ABSENT, None, (), (name,))
    return Cost(ESTIMATE, round(figures.lut_count(known.targets[TARGET]) * disparities / own), (name,))


def _key(values: Features) -> _Key:
    return tuple(sorted(values.items(), key=lambda item: item[0]))
