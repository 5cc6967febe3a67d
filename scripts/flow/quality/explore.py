# SPDX-License-Identifier: Apache-2.0
"""Parameter study: `stereo_hls evaluate` of many choices of options on some pairs, beside what each costs in
hardware."""

from __future__ import annotations

import csv
import io
import itertools
import json
import shlex
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base import files, progress
from ..base.configurations import configuration, configurations, option
from ..base.errors import FlowError
from ..base.farm import Farm, result_of
from ..base.tools import Word
from . import evaluation, given_truth, hardware_cost
from .evaluation import Method
from .kept import Kept

FORMAT = "stereo-hls exploration 1"
EVALUATIONS = "evaluations.jsonl"
RESULTS = ("explore.json", "explore.csv", "front.png", EVALUATIONS)
PROGRAM = "build/release/stereo_hls"
# Each option by the configuration that has it beside the plain core: its settings are those that were synthesised.
COSTS = {"sad": hardware_cost.BASE, "ssd": "study_ssd", "census": "study_census"}
SWITCHES = {
    "xsobel": "study_xsobel",
    "left_right": "study_left_right",
    "uniqueness": "study_uniqueness",
    "texture": "study_texture",
    "subpixel": "study_subpixel",
    "median": "study_median",
    "left": "study_left",
}


@dataclass(frozen=True)
class Pair:
    name: str
    left: Path
    right: Path
    truth_left: Path | None
    truth_right: Path | None
    scale: float | None = None  # what the user says; else the kind of the file has one

    def words(self) -> list[Word]:
        words: list[Word] = ["--left", self.left, "--right", self.right]
        for word, path in (("--truth-left", self.truth_left), ("--truth-right", self.truth_right)):
            if path:
                words += [word, path]
        if self.scale is not None:
            words += ["--truth-scale", f"{self.scale:g}"]
        return words


@dataclass(frozen=True)
class Sweep:
    windows: list[int]
    costs: list[str]
    ranges: list[int]
    switches: list[str]  # each is swept off and on


@dataclass(frozen=True)
class Choice:
    """One point of the sweep. `settings`: what differs from the plain core."""

    window: int
    cost: str
    disparities: int
    switches: tuple[str, ...]
    settings: tuple[str, ...]  # ("NAME=VALUE", ...)
    config: str = hardware_cost.BASE  # another one is tried as it is, but for the disparities and the reference

    @property
    def title(self) -> str:
        if self.config != hardware_cost.BASE:
            return self.config
        return " ".join([f"{self.cost} {self.window}x{self.window}", *self.switches])


# One choice in explore.json: what it is, "luts" and where they come from, each measure in percent (None where no pixel
# counts), "commands"; mark_front adds "front".
Row = dict[str, Any]


def choices(
    sweep: Sweep, family: hardware_cost.Study, known: tuple[str, ...] = given_truth.SIDES
) -> tuple[list[Choice], int]:
    """(choices, how many combinations were left out because no core has them). known: the images with truth, one of
    which is the reference."""
    if "left" in sweep.switches and len(known) < len(given_truth.SIDES):
        raise FlowError("--switch left: tries both references and so needs the truth of both images of every pair")
    turned = given_truth.reference_setting(configuration(hardware_cost.BASE), known) or {}
    found, refused = [], 0
    switch_sets = [
        tuple(s for s, on in zip(sweep.switches, flags) if on)
        for flags in itertools.product((False, True), repeat=len(sweep.switches))
    ]
    for disparities, cost, window, switches in itertools.product(sweep.ranges, sweep.costs, sweep.windows, switch_sets):
        if not _is_possible(cost, switches):
            refused += 1
            continue
        options = dict(turned)
        for name in (COSTS[cost], *(SWITCHES[switch] for switch in switches)):
            options |= family.options_of(name)
        options |= {"window_px": window, "disparities": disparities}
        settings = tuple(f"{key}={json.dumps(value).strip(chr(34))}" for key, value in options.items())
        found.append(Choice(window, cost, disparities, switches, settings))
    return found, refused


def named_choices(
    names: Iterable[str], ranges: Iterable[int], known: tuple[str, ...] = given_truth.SIDES
) -> tuple[list[Choice], list[str]]:
    """(configurations of any family, for each range; the names of those whose reference has no truth). All else is as
    it is."""
    found, left_out = [], []
    table = configurations()
    for name in names:
        row = configuration(name, table)
        turned = given_truth.reference_setting(row, known)
        if turned is None:
            left_out.append(name)
            continue
        for disparities in ranges:
            settings = tuple(f"{key}={value}" for key, value in {"disparities": disparities, **turned}.items())
            found.append(Choice(option(row, "window_px") or 1, row["family"], disparities, (), settings, name))
    return found, left_out


def _is_possible(cost: str, switches: tuple[str, ...]) -> bool:
    """Census takes no x-Sobel, and the texture check needs it."""
    if cost == "census":
        return not {"xsobel", "texture"} & set(switches)
    return "texture" not in switches or "xsobel" in switches


def scene_folder(out: Path, seed: int) -> Path:
    return out / f"scene{seed}"


def generated_scenes(number: int, disparities: int, folder: Path) -> list[Pair]:
    """Pairs with truth of both images; `disparities`: the largest range that is explored."""
    pairs = []
    for seed in range(1, number + 1):
        made = evaluation.scene(seed, disparities, scene_folder(folder, seed))
        truths = made["--truth-left"], made["--truth-right"]
        pairs.append(Pair(f"scene {seed}", made["--left"], made["--right"], *truths))
    return pairs


def words(pair: Pair, choice: Choice) -> list[Word]:
    """What `stereo_hls evaluate` takes."""
    settings = [word for setting in choice.settings for word in ("--set", setting)]
    return [*pair.words(), "--config", choice.config, *settings]


def command(pair: Pair, choice: Choice) -> str:
    return shlex.join(str(word) for word in (PROGRAM, "evaluate", *words(pair, choice)))


def evaluate(pairs: Sequence[Pair], all_choices: Sequence[Choice], workers: Farm, kept: Kept) -> list[list[Method]]:
    """[[method of each pair] of each choice]. Every evaluation is a process of its own with one thread; those that are
    kept from before are not made again."""
    calls = {(i, j): words(pair, choice) for i, choice in enumerate(all_choices) for j, pair in enumerate(pairs)}
    results = {place: method for place, call in calls.items() if (method := kept.find(call))}
    if results:
        print(f"{len(results)} of {len(calls)} evaluations are in {kept.path} from before")
    with progress.bar("evaluating", len(calls)) as bar:
        futures = {
            workers.submit(evaluation.evaluate, *call, "--threads", 1): place
            for place, call in calls.items()
            if place not in results
        }
        try:
            for future in as_completed(futures):
                place = futures[future]
                method = result_of(future)[0]
                kept.add(calls[place], method)
                results[place] = method
                bar.show(len(results))
        except BaseException:
            workers.stop()
            if results:
                bar.say(
                    f"{len(results)} of {len(calls)} evaluations are in {kept.path}; the next run goes on from there"
                )
            raise
    return [[results[i, j] for j in range(len(pairs))] for i in range(len(all_choices))]


def remarks(pairs: Sequence[Pair], methods: Sequence[Sequence[Method]]) -> list[str]:
    """One for each pair whose truth fits badly, as with a wrong scale."""
    found = []
    for place, pair in enumerate(pairs):
        of_pair = [text for of_choice in methods for text in of_choice[place].get("remarks", ())]
        if of_pair:
            found.append(f"{pair.name}: {of_pair[0]} ({len(of_pair)} of {len(methods)} choices say so)")
    return found


def _mean(values: Iterable[float | None], scale: float = 1) -> float | None:
    """None where a value is not known."""
    known = list(values)
    total = 0.0
    for value in known:
        if value is None:
            return None
        total += value
    return scale * (total / len(known)) if known else None


def rows(
    pairs: Sequence[Pair],
    all_choices: Sequence[Choice],
    methods: Sequence[Sequence[Method]],
    family: hardware_cost.Study,
    mask: str,
) -> list[Row]:
    """One row of numbers for each choice: quality as the mean over the pairs, and cost."""
    table = []
    for choice, of_pairs in zip(all_choices, methods):
        empty = [pair.name for pair, method in zip(pairs, of_pairs) if mask not in method["masks"]]
        if empty:
            raise FlowError(f"{empty[0]}: has no pixels in the region '{mask}' for {choice.title}; give another --mask")
        masks = [method["masks"][mask] for method in of_pairs]
        if choice.config == hardware_cost.BASE:
            cost = family.cost(of_pairs[0]["parameters"])
        else:
            as_it_is = len(choice.settings) == 1  # but for the disparities
            cost = hardware_cost.of_configuration(choice.config, choice.disparities, as_it_is)
        row: Row = {
            "title": choice.title,
            "window": choice.window,
            "cost": choice.cost,
            "disparities": choice.disparities,
            "switches": list(choice.switches),
            "luts": cost.luts,
            "luts_are": cost.kind,
            "luts_from": list(cost.sources),
            "luts_missing": list(cost.missing),
        }
        for name in evaluation.MEASURES:
            for way in ("invalid_bad", "valid_only"):
                row[f"{name}_{way}_percent"] = _mean((m[name][way] for m in masks), 100)
        row |= {
            "density_percent": _mean((m["density"] for m in masks), 100),
            "rms_px": _mean(m["rms_px"] for m in masks),
            "milliseconds": _mean(method["milliseconds"] for method in of_pairs),
            "commands": [command(pair, choice) for pair in pairs],
        }
        table.append(row)
    return table


def mark_front(table: list[Row], key: str) -> None:
    """Sets `front` of the rows that no other row of the same range beats in both LUTs and `key`. Rows without either
    are never on it."""
    for row in table:
        row["front"] = False
    for disparities in {row["disparities"] for row in table}:
        known = [
            row
            for row in table
            if row["disparities"] == disparities and row["luts"] is not None and row[key] is not None
        ]
        best = float("inf")
        for row in sorted(known, key=lambda row: (row["luts"], row[key])):
            if row[key] < best:
                row["front"], best = True, row[key]


def front(table: list[Row], disparities: int) -> list[Row]:
    """From the cheapest to the best."""
    members = [row for row in table if row["front"] and row["disparities"] == disparities]
    return sorted(members, key=lambda row: row["luts"])


def write(out: Path, content: Mapping[str, object], table: list[Row], picture: bytes) -> None:
    """explore.json, explore.csv, front.png: after everything else has succeeded."""
    text = io.StringIO()
    names = [name for name in table[0] if name != "commands"]
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*names, "command"])
    for row in table:
        writer.writerow([*(_csv_cell(row[name]) for name in names), " && ".join(row["commands"])])
    files.write(out / "explore.json", json.dumps(content, indent=1) + "\n")
    files.write(out / "explore.csv", text.getvalue())
    files.write(out / "front.png", picture)


def _csv_cell(value: object) -> object:
    if isinstance(value, list):
        return " ".join(value)
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else value
