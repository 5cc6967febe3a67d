# SPDX-License-Identifier: Apache-2.0
"""Parameter study: `stereo_hls evaluate` of many choices of options on some pairs, beside what each costs in hardware."""

import csv
import io
import itertools
import json
import shlex
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from ..base import files
from ..base.errors import FlowError
from . import evaluation, hardware_cost

FORMAT = "stereo-hls exploration 1"
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
    truth_left: object  # a path, or None
    truth_right: object
    scale: float = 1

    def words(self):
        words = ["--left", self.left, "--right", self.right]
        for option, path in (("--truth-left", self.truth_left), ("--truth-right", self.truth_right)):
            words += [option, path] if path else []
        return [*words, *(["--truth-scale", f"{self.scale:g}"] if self.scale != 1 else [])]


@dataclass(frozen=True)
class Sweep:
    windows: list
    costs: list
    ranges: list
    switches: list  # each is swept off and on


@dataclass(frozen=True)
class Choice:
    """One point of the sweep. `settings`: what differs from the plain core."""

    window: int
    cost: str
    disparities: int
    switches: tuple
    settings: tuple  # ("NAME=VALUE", ...)

    @property
    def title(self):
        return " ".join([f"{self.cost} {self.window}x{self.window}", *self.switches])


def choices(sweep, family):
    """(choices, how many combinations were left out because no core has them)"""
    found, refused = [], 0
    switch_sets = [
        tuple(s for s, on in zip(sweep.switches, flags) if on)
        for flags in itertools.product((False, True), repeat=len(sweep.switches))
    ]
    for disparities, cost, window, switches in itertools.product(sweep.ranges, sweep.costs, sweep.windows, switch_sets):
        if (cost == "census" and {"xsobel", "texture"} & set(switches)) or (
            "texture" in switches and "xsobel" not in switches
        ):
            refused += 1
            continue
        options = {}
        for name in (COSTS[cost], *(SWITCHES[switch] for switch in switches)):
            options |= family.options_of(name)
        options |= {"window_px": window, "disparities": disparities}
        found.append(
            Choice(
                window,
                cost,
                disparities,
                switches,
                tuple(f"{key}={json.dumps(value).strip(chr(34))}" for key, value in options.items()),
            )
        )
    return found, refused


def generated_scenes(number, disparities, folder):
    """Pairs with truth of both images; `disparities`: the largest range that is explored."""
    return [
        Pair(f"scene {seed}", *evaluation.scene(seed, disparities, folder / f"scene{seed}").values())
        for seed in range(1, number + 1)
    ]


def words(pair, choice):
    """What `stereo_hls evaluate` takes."""
    return [
        *pair.words(),
        "--config",
        hardware_cost.BASE,
        *itertools.chain(*(("--set", setting) for setting in choice.settings)),
    ]


def command(pair, choice):
    return shlex.join(str(word) for word in (PROGRAM, "evaluate", *words(pair, choice)))


def evaluate(pairs, all_choices, jobs):
    """[[method of each pair] of each choice]. Every evaluation is a process of its own, `jobs` at a time."""
    results = [[None] * len(pairs) for _ in all_choices]
    with (
        Progress(
            TextColumn("evaluating"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TimeRemainingColumn()
        ) as bar,
        ThreadPoolExecutor(jobs) as pool,
    ):
        task = bar.add_task("", total=len(all_choices) * len(pairs))
        futures = {
            pool.submit(evaluation.evaluate, *words(pair, choice)): (i, j)
            for i, choice in enumerate(all_choices)
            for j, pair in enumerate(pairs)
        }
        try:
            for future in as_completed(futures):
                i, j = futures[future]
                results[i][j] = future.result()[0]
                bar.advance(task)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return results


def _mean(values):
    values = list(values)
    return sum(values) / len(values) if values else None


def rows(pairs, all_choices, methods, family, mask):
    """One row of numbers for each choice: quality as the mean over the pairs, and cost."""
    table = []
    for choice, of_pairs in zip(all_choices, methods):
        masks = [method["masks"][mask] for method in of_pairs if mask in method["masks"]]
        if len(masks) != len(pairs):
            raise FlowError(f"a pair has no pixels in the region '{mask}'; non_occluded needs the truth of both images")
        cost = family.cost(of_pairs[0]["parameters"])
        row = {
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
                row[f"{name}_{way}_percent"] = 100 * _mean(m[name][way] for m in masks)
        row |= {
            "density_percent": 100 * _mean(m["density"] for m in masks),
            "rms_px": _mean(m["rms_px"] for m in masks),
            "milliseconds": _mean(method["milliseconds"] for method in of_pairs),
            "commands": [command(pair, choice) for pair in pairs],
        }
        table.append(row)
    return table


def mark_front(table, key):
    """Sets `front` of the rows that no other row of the same range beats in both LUTs and `key`. Rows without LUTs are never on it."""
    for disparities in {row["disparities"] for row in table}:
        members = [row for row in table if row["disparities"] == disparities]
        best = float("inf")
        for row in sorted(
            members, key=lambda row: (row["luts"] if row["luts"] is not None else float("inf"), row[key])
        ):
            row["front"] = row["luts"] is not None and row[key] < best
            best = row[key] if row["front"] else best


def front(table, disparities):
    return sorted(
        (row for row in table if row["front"] and row["disparities"] == disparities), key=lambda row: row["luts"]
    )


def write(out, content, table, picture):
    """explore.json, explore.csv, front.png: after everything else has succeeded."""
    text = io.StringIO()
    names = [name for name in table[0] if name != "commands"]
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*names, "command"])
    for row in table:
        values = [" ".join(row[name]) if isinstance(row[name], list) else row[name] for name in names]
        writer.writerow(
            ["" if value is None else f"{value:.6g}" if isinstance(value, float) else value for value in values]
            + [" && ".join(row["commands"])]
        )
    for name, data in (
        ("explore.json", json.dumps(content, indent=1) + "\n"),
        ("explore.csv", text.getvalue()),
        ("front.png", picture),
    ):
        files.write(out / name, data)
