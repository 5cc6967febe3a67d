# SPDX-License-Identifier: Apache-2.0
"""The configurations that could serve a camera: algorithms whose quality is measured, at its size and with its
checks, each with so many clocks a pixel pair or pixel pairs a clock as there can be."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from ..base.configurations import configuration, configurations, matching_options, options
from ..base.errors import EXIT_USAGE, FlowError
from ..implementation import figures
from . import cores
from .path_shape import PathShape
from .window_shape import WindowShape

Options = dict[str, Any]
Key = tuple[Any, ...]
# What a check is called, and its options by the family; the value is that of the records and of the study.
CHECKS: dict[str, dict[str, Options]] = {
    "left_right": {"": {"left_right_threshold": 1}},
    "uniqueness": {"block_matching": {"uniqueness_percent": 5}, "semi_global": {"uniqueness_distance": 5}},
    "texture": {"block_matching": {"prefilter": "xsobel", "texture_threshold": 60}},
    "subpixel": {"": {"subpixel": True}},
    "median": {"": {"median": True}},
    "full_width": {"": {"full_width": True}},
}
THRESHOLDS = {"left_right_threshold", "uniqueness_percent", "uniqueness_distance", "texture_threshold"}
SAME_MAP = {"front_clocks"}  # a row with more of them serves as one with fewer: the same map, hardly more logic
SPEED = ("clocks_per_pixel", "pixels_per_clock")
PARALLEL = (2, 4)  # pixel pairs a clock, beside one


@dataclass(frozen=True)
class Camera:
    width_px: int
    height_px: int
    disparities: int
    frames_per_second: float
    checks: tuple[str, ...] = ()
    settings: Options = field(default_factory=dict)  # of any option, by its name

    def needed_mhz(self, clocks_a_frame: int) -> float:
        return clocks_a_frame * self.frames_per_second / 1e6


@dataclass(frozen=True)
class Algorithm:
    """A row of docs/quality.md: a configuration and what differs from it."""

    title: str
    config: str
    settings: Options
    wrong: Mapping[str, str]  # {pair: percent of its pixels that are wrong}


@dataclass(frozen=True)
class Candidate:
    algorithm: Algorithm
    options: Options  # all of the family's
    changes: Options  # those that differ from the algorithm's configuration
    problem: str  # why no core can be built; empty when one can

    @property
    def shape(self) -> WindowShape:
        return cores.shape_of(self.options)

    @property
    def clocks_a_frame(self) -> int:
        o: Any = {**self.options, "gap_groups": self.shape.gap_groups}
        return figures.clocks_per_frame(o)

    @property
    def family(self) -> str:
        family: str = self.options["family"]
        return family


def value_of(text: str) -> Any:
    """Of an option as users write it: a word, a number, or true and false."""
    if text in ("true", "false"):
        return text == "true"
    try:
        return int(text)
    except ValueError:
        return text


def check(camera: Camera, algorithms: Iterable[Algorithm]) -> None:
    """Refuses settings that no algorithm can have: where no family has the option, the checks need another value, or
    the program refuses them all."""
    known = [options()[family] for family in cores.FAMILIES]
    algorithms = list(algorithms)
    of_program = frozenset[str]().union(*(_known(algorithm.config) for algorithm in algorithms))
    for name, value in camera.settings.items():
        found = [option[name] for option in known if name in option]
        if not found:
            raise FlowError(f"no family has the option '{name}'; docs/options.md lists all")
        # Limits of other options may depend on each other: of those the program decides.
        if (name not in of_program or "words" in found[0]) and not any(_allows(option, value) for option in found):
            raise FlowError(f"{name} cannot be {_text(value)}; docs/options.md has its values")
        for one in camera.checks:
            of_check = {key: wish for wishes in CHECKS[one].values() for key, wish in wishes.items()}
            if name in of_check and value == found[0]["default"] != of_check[name]:
                raise FlowError(f"--set {name}={_text(value)} turns off what --with {one} asks for")
    if not _speeds(camera, camera.settings):
        said = " and ".join(f"{name} {camera.settings[name]}" for name in SPEED if name in camera.settings)
        raise FlowError(f"no core of {camera.disparities} disparities and {camera.height_px} rows can have {said}")
    refusals = []
    for algorithm in algorithms:
        wishes, reason = _wishes(camera, configuration(algorithm.config)["family"])
        if not reason:
            refusals.append(_refusal(algorithm.config, algorithm.settings | wishes))
    if camera.settings and refusals and all(refusals):
        for name, value in camera.settings.items():
            if not any(_allows(option[name], value) for option in known if name in option):
                raise FlowError(f"{name} cannot be {_text(value)}; docs/options.md has its values")
        raise FlowError(refusals[0])


def _refusal(config: str, changes: Options) -> str:
    """Why the program cannot match with these options; empty when it can."""
    known = _known(config)
    return _refused(config, tuple((name, _text(value)) for name, value in changes.items() if name in known))


@cache
def _refused(config: str, settings: tuple[tuple[str, str], ...]) -> str:
    try:
        matching_options(config, dict(settings))
    except FlowError as error:
        if error.exit_code != EXIT_USAGE:
            raise
        return str(error)
    return ""


@cache
def _known(config: str) -> frozenset[str]:
    return frozenset(matching_options(config))


def _allows(option: Mapping[str, Any], value: Any) -> bool:
    """As far as it does not depend on other options: what only some of them allow has one value here."""
    if "words" in option:
        return _text(value) in option["words"]
    if type(value) is not int:
        return False
    is_free = option["low"] == option["high"]
    return is_free or (option["low"] <= value and (option["high"] is None or value <= option["high"]))


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _wishes(camera: Camera, family: str) -> tuple[Options, str]:
    """(what the checks and settings change, why this family cannot have them)"""
    wishes: Options = {}
    for check in camera.checks:
        of_families = CHECKS[check]
        if family not in of_families and "" not in of_families:
            return {}, f"this family has no check of {check}"
        wishes |= of_families.get(family) or of_families[""]
    missing = [name for name in camera.settings if name not in options()[family]]
    if missing:
        return {}, f"this family has no {missing[0]}"
    return wishes | camera.settings, ""


def candidates(camera: Camera, algorithms: Iterable[Algorithm]) -> Iterator[Candidate]:
    """Of every algorithm: that with a pixel pair a clock, those with fewer, those with more. One that cannot be built
    says why."""
    table = configurations()
    for algorithm in algorithms:
        row = configuration(algorithm.config, table)
        family = row["family"]
        names = options()[family]
        base: Options = {name: value for name, value in dict(row).items() if name in names}
        size = {"width_px": camera.width_px, "height_px": camera.height_px, "disparities": camera.disparities}
        wishes, reason = _wishes(camera, family)
        last = "" if reason else _refusal(algorithm.config, algorithm.settings | wishes)
        wanted = base | algorithm.settings | size | wishes
        for (clocks, pixels), sums in itertools.product(_speeds(camera, wanted), _sums(camera, family)):
            chosen = wanted | {"clocks_per_pixel": clocks, "pixels_per_clock": pixels} | sums
            if "sign_memory" not in camera.settings:  # it only saves logic
                chosen["sign_memory"] &= clocks == 1 and _takes_sign_memory(chosen)
            changes = {name: chosen[name] for name in names if chosen[name] != base[name]}
            whole = chosen | {"family": family}
            yield Candidate(algorithm, whole, changes, reason or problem(cores.shape_of(whole)) or last)


def _sums(camera: Camera, family: str) -> list[Options]:
    """Direct and recursive sums give the same map: one takes less logic, the other less memory."""
    if family != "block_matching" or "aggregation" in camera.settings:
        return [{}]
    return [{"aggregation": word} for word in options()[family]["aggregation"]["words"]]


def _speeds(camera: Camera, wanted: Options) -> list[tuple[int, int]]:
    """(clocks a pixel pair, pixel pairs a clock), the slowest first; what settings say of either is kept."""
    speeds = [(clocks, 1) for clocks in range(camera.disparities // 2, 0, -1) if camera.disparities % clocks == 0]
    speeds += [(1, pixels) for pixels in PARALLEL if camera.height_px % pixels == 0]
    for place, name in enumerate(SPEED):
        if name in camera.settings:
            speeds = [speed for speed in speeds if speed[place] == wanted[name]]
    return speeds


def _takes_sign_memory(of: Mapping[str, Any]) -> bool:
    is_direct_sad = of["aggregation"] == "direct" and of["cost"] == "sad" and of["cost_clocks"] == 3
    return is_direct_sad and of.get("texture_threshold", 0) == 0 and bool(of["width_px"] >= 8)


def problem(shape: WindowShape) -> str:
    """Why no core has these options, where that depends on the size, the checks or the clocks; empty when nothing here
    says so. The compiler says the rest (`problem` of each family's config.hpp)."""
    s, o = shape, shape.options
    if s.width <= s.disparities:
        return "the image must be wider than the disparity range"
    if not (1 if isinstance(s, PathShape) else 2) <= s.window <= 31:
        return "the window must be 2x2 ... 31x31 pixels"
    if s.height < s.window:
        return "the image must be as high as the window"
    if s.is_census and o["prefilter"] != "none":
        return "census takes no prefilter"
    if s.texture and o["prefilter"] == "none":
        return "the texture check needs the prefilter"
    if s.width - s.first_cost_column < 2:
        return "the disparity range lies outside the image"
    if s.is_folded:
        if s.lanes < 2:
            return "two disparities or more must be left for each clock"
        if s.pixels > 1:
            return "with several clocks a pixel pair only one comes at once"
        if o.get("run_time_size", False):
            return "with several clocks a pixel pair there is no run-time size"
    if o["sign_memory"] and (s.is_folded or not _takes_sign_memory(o)):
        return "this core takes no sign memory"
    return _path_problem(s) if isinstance(s, PathShape) else _window_problem(s)


def _window_problem(shape: WindowShape) -> str:
    s = shape
    if s.full_width and s.width <= s.window:
        return "with a map of full width the image must be wider than the window"
    if s.is_folded:
        if s.full_width:
            return "with several clocks a pixel pair there is no map of full width"
        if not s.passes_fit:
            return "with so many clocks a pixel pair the image must be wider"
    return ""


def _path_problem(shape: PathShape) -> str:
    s = shape
    if s.options["sign_memory"]:
        return "a sign memory is for block matching"
    if s.pixels != 1:
        return "the semi-global core takes one pixel pair a clock"
    if s.disparities < 8:
        return "semi-global matching needs 8 disparities or more"
    if s.full_width and s.window < 3:
        return "a semi-global map of full width needs a window of 3x3 pixels or more"
    if s.is_folded:
        if s.passes < 4:
            return "a semi-global path takes four clocks a pixel pair or more, or one"
        if s.recursive:
            return "with several clocks a pixel pair semi-global costs have no recursive sums"
        if s.output_width * s.passes > 1 << 16:
            return "with so many clocks a pixel pair a row of the map must be shorter"
    elif not s.full_width and s.width - s.output_width < (s.disparities - 1).bit_length() + 7:
        return "the disparity range must leave more columns between the maps of two rows"
    return ""


def row_text(name: str, candidate: Candidate) -> str:
    """Of configurations.hpp."""
    changes = "".join(f", {key} = {in_cpp(key, value)}" for key, value in candidate.changes.items())
    return f"STEREO_ROW({name}, system, {candidate.algorithm.config}{changes});"


def in_cpp(name: str, value: Any) -> str:
    """A word is one of the option's own type, which bears its name."""
    if isinstance(value, str):
        return f"{name.title().replace('_', '')}::{value}"
    return _text(value)


def twins(table: Mapping[str, Mapping[str, Any]]) -> dict[Key, str]:
    """{what decides the hardware: a configuration of the table}"""
    return {key_of(row): name for name, row in table.items() if row["family"] in cores.FAMILIES}


def serving(table: Mapping[str, Mapping[str, Any]]) -> dict[Key, str]:
    """The same for those who do not ask for the options of SAME_MAP, as if no row had them."""
    return twins({name: {**row, **dict.fromkeys(SAME_MAP & row.keys(), 1)} for name, row in table.items()})


def key_of(row: Mapping[str, Any]) -> Key:
    """What decides the hardware: checks cost the same with any threshold."""
    kept = {name: row[name] for name in options()[row["family"]]}
    for name in THRESHOLDS & kept.keys():
        kept[name] = kept[name] >= 0 if name == "left_right_threshold" else kept[name] > 0
    return (row["family"], *sorted(kept.items()))
