#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sweeps window, cost, disparity range and options over some pairs with the fast model, and sets the quality beside the
look-up tables that each choice costs: which configuration is worth its LUTs?"""

import os
import sys
from argparse import Namespace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import farm, files, places
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.quality import evaluation, explore, front, given_truth, hardware_cost
from flow.quality.kept import Kept


def parse() -> Namespace:
    parser = ArgumentParser(prog="explore.py", description=__doc__)
    parser.add_argument(
        "--pair",
        nargs=4,
        action="append",
        default=[],
        metavar=("LEFT", "RIGHT", "TRUTH_LEFT", "TRUTH_RIGHT"),
        help="a rectified pair and the ground truth of both images; - for none: then the other image is the "
        "reference; may be repeated",
    )
    parser.add_argument(
        "--truth-scale",
        nargs="+",
        action="extend",
        type=float,
        metavar="S",
        help="units of the truth in a pixel: one number for all pairs, or one for each --pair (default 256 for 16 bits "
        "as KITTI's, else 1)",
    )
    parser.add_argument(
        "--scenes", type=int, metavar="N", help="generated scenes beside the pairs (default 2 without a pair, else 0)"
    )
    parser.add_argument(
        "--window",
        nargs="+",
        type=int,
        default=[3, 5, 7, 9, 15, 21],
        metavar="B",
        help="sides of the window (default 3 5 7 9 15 21)",
    )
    parser.add_argument(
        "--cost", nargs="+", choices=sorted(explore.COSTS), default=list(explore.COSTS), help="default all"
    )
    parser.add_argument(
        "--range", dest="ranges", nargs="+", type=int, default=[64], metavar="D", help="disparities (default 64)"
    )
    parser.add_argument(
        "--switch",
        nargs="*",
        choices=sorted(explore.SWITCHES),
        default=["xsobel", "left_right", "subpixel", "median"],
        help="options to sweep off and on (default xsobel left_right subpixel median)",
    )
    parser.add_argument(
        "--config",
        nargs="*",
        default=["sgm_450", "sgm_640"],
        metavar="NAME",
        help="configurations to try unchanged except for the disparities and, if only one image has truth, "
        "the reference (default sgm_450 sgm_640)",
    )
    parser.add_argument(
        "--mask",
        choices=evaluation.MASKS,
        help="region to measure (default non_occluded, or all if only one image has truth)",
    )
    parser.add_argument(
        "--measure", choices=evaluation.MEASURES, default="bad_1", help="measure of the front (default bad_1)"
    )
    parser.add_argument(
        "--valid-only", action="store_true", help="leave rejected pixels out instead of counting them as bad"
    )
    farm.add_options(parser, os.cpu_count() or 1, "evaluations")
    parser.add_argument(
        "--out",
        type=a_path,
        default=ROOT / "build" / "explore",
        metavar="DIR",
        help="folder for explore.json, explore.csv, front.png, and evaluations.jsonl, which keeps finished evaluations",
    )
    return parser.parse_args()


def check(options: Namespace) -> None:
    if any(window < 2 or window > 31 for window in options.window):
        raise FlowError("--window must be 2 ... 31, as the core has it")
    if any(disparities < 2 or disparities > 256 for disparities in options.ranges):
        raise FlowError("--range must be 2 ... 256")
    if options.scenes is not None and options.scenes < 0:
        raise FlowError("--scenes must be 0 or more")
    scales = options.truth_scale or [1]  # none: one that fits
    if any(not scale > 0 or scale == float("inf") for scale in scales):
        raise FlowError("--truth-scale must be above 0")
    if len(scales) not in (1, len(options.pair)):
        raise FlowError(f"--truth-scale: give one number, or one for each of the {len(options.pair)} pairs")
    for paths in options.pair:
        for path in paths:
            if path != "-" and not Path(path).is_file():
                raise FlowError(f"{path}: there is no such file")
    if options.truth_scale and not options.pair:
        raise FlowError("--truth-scale needs --pair")
    written = [options.out / name for name in explore.RESULTS]
    written += [
        path
        for seed in range(1, (options.scenes or 0) + 1)
        for path in explore.scene_folder(options.out, seed).glob("*")
    ]
    inputs = [Path(path) for paths in options.pair for path in paths if path != "-"]
    for path in written:
        files.refuse_input(path, inputs)


def given_pairs(options: Namespace) -> list[explore.Pair]:
    pairs = []
    scales = options.truth_scale or [None]
    if len(scales) == 1:
        scales = scales * len(options.pair)
    for (left, right, *truths), scale in zip(options.pair, scales):
        truth_left, truth_right = (None if truth == "-" else Path(truth) for truth in truths)
        name = Path(left).parent.name or left
        pairs.append(explore.Pair(name, Path(left), Path(right), truth_left, truth_right, scale))
    return pairs


def main() -> int:
    options = parse()
    check(options)
    family = hardware_cost.Study()
    sweep = explore.Sweep(
        sorted(set(options.window)),
        list(dict.fromkeys(options.cost)),
        sorted(set(options.ranges)),
        list(dict.fromkeys(options.switch)),
    )
    number = options.scenes if options.scenes is not None else (0 if options.pair else 2)
    pairs = given_pairs(options)
    if not pairs and number == 0:
        raise FlowError("no pair: give --pair or --scenes")
    known = given_truth.known_sides(pairs) if pairs else given_truth.SIDES
    options.mask = given_truth.mask(options.mask, known)
    choices, refused = explore.choices(sweep, family, known)
    if not choices:
        raise FlowError("no choice is left: census takes no x-Sobel, and the texture check needs it")
    places.results_folder(options.out, explore.RESULTS)
    named, without_truth = explore.named_choices(list(dict.fromkeys(options.config)), sweep.ranges, known)
    choices += named
    pairs += explore.generated_scenes(number, max(sweep.ranges), options.out)
    names = ", ".join(pair.name for pair in pairs)
    left_out = f"; {refused} combinations left out that no core has" if refused else ""
    print(f"{len(choices)} choices of options on {len(pairs)} pair{'s' if len(pairs) != 1 else ''} ({names}){left_out}")
    if len(known) == 1:
        print(f"Only the {known[0]} images have truth: they are the references, and every pixel with truth counts.")
    for name in without_truth:
        print(f"{name} is left out: its reference is the other image, and no option changes that.")
    with farm.of(options) as workers:
        methods = explore.evaluate(pairs, choices, workers, Kept(options.out / explore.EVALUATIONS))
    for remark in explore.remarks(pairs, methods):
        print(remark)
    table = explore.rows(pairs, choices, methods, family, options.mask)
    way = "valid_only" if options.valid_only else "invalid_bad"
    show(options, family, pairs, table, f"{options.measure}_{way}_percent")
    return EXIT_OK


def notes_on(family: hardware_cost.Study) -> list[str]:
    """Where the look-up tables come from."""
    size = f"{family.base.parameters['width_px']}x{family.base.parameters['height_px']}"
    return [
        "measured: this very choice went through place and route. "
        f"estimate: of a {size} core by the model of plan.py, which docs/plan.md sets beside all measured cores. "
        "absent: not measured, and its family has no model.",
        f"Measured configurations: {', '.join(family.measured)}; "
        f"look-up tables of {size} and D={family.disparities} on ECP5, the smaller one of direct and recursive sums; "
        "wider images need more memory.",
    ]


def show(
    options: Namespace, family: hardware_cost.Study, pairs: list[explore.Pair], table: list[explore.Row], key: str
) -> None:
    explore.mark_front(table, key)
    measure = options.measure.replace("d1", "D1").replace("bad_0_5", "bad 0.5").replace("_", " ")
    title = f"{measure}, {options.mask.replace('_', '-')}, %"
    size = f"{family.base.parameters['width_px']}x{family.base.parameters['height_px']}"

    def luts_title(disparities: int) -> str:
        return f"LUT4 on ECP5 of a {size} core, D={disparities}"

    notes = notes_on(family)
    picture = front.draw(table, key, title, luts_title)
    content = {
        "format": explore.FORMAT,
        "pairs": [pair.name for pair in pairs],
        "mask": options.mask,
        "front_of": key,
        "notes": notes,
        "choices": table,
    }
    explore.write(options.out, content, table, picture)
    from rich.console import Console

    console = Console(highlight=False)
    for made in front.tables(table, key, title):
        console.print(made)
    for note in notes:
        console.print(note, soft_wrap=True)
    console.print(
        f"Each row again: its command in {options.out}/explore.csv; the picture: {options.out}/front.png",
        soft_wrap=True,
    )


if __name__ == "__main__":
    run_command(main)
