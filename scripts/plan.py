#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Says which configurations serve a camera on a device: each algorithm of docs/quality.md at the camera's size, with as
many clocks a pixel pair as its frames a second leave. Of each it shows clocks a frame, the needed and the expected
clock, look-up tables, flip-flops, block RAMs and wrong pixels, and whether a number is measured or an estimate; then
the row to add and the commands that make, check and implement it. Runs no tool. Exit code 1: nothing fits."""

import json
import re
import sys
from argparse import ArgumentTypeError, Namespace
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.configurations import configurations
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.pages import plan as page
from flow.pages.plan_algorithms import algorithms
from flow.planning import candidates, devices, plan_text, search
from flow.planning.candidates import Camera


def number(text: str, least: float, most: float) -> float:
    try:
        value = float(text)
    except ValueError:
        value = least - 1
    if not least <= value <= most:
        raise ArgumentTypeError(f"'{text}' is no number from {least:g} to {most:g}")
    return value


def size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,4})x(\d{1,4})", text)
    width, height = (int(match[1]), int(match[2])) if match else (0, 0)
    if not (1 <= width <= 4096 and 1 <= height <= 4096):
        raise ArgumentTypeError(f"'{text}' is no size such as 640x480, each side 1 ... 4096")
    return width, height


def count(text: str) -> int:
    if not re.fullmatch(r"\d{1,7}", text):
        raise ArgumentTypeError(f"'{text}' is no whole number below 10,000,000")
    return int(text)


def setting(text: str) -> tuple[str, Any]:
    name, equals, value = text.partition("=")
    if not (name and equals and value):
        raise ArgumentTypeError(f"'{text}' is not NAME=VALUE")
    return name, candidates.value_of(value)


def parse() -> Namespace:
    parser = ArgumentParser(prog="plan.py", description=__doc__)
    parser.add_argument(
        "--device",
        choices=devices.targets(),
        default="ecp5_25f_grade6",
        help="device and speed grade, a target of implement.py (default ecp5_25f_grade6)",
    )
    parser.add_argument("--luts", type=count, metavar="N", help="look-up tables there are (default all of the device)")
    parser.add_argument(
        "--flip-flops", type=count, metavar="N", help="flip-flops there are (default all of the device)"
    )
    parser.add_argument(
        "--block-rams", type=count, metavar="N", help="block RAMs there are (default all of the device)"
    )
    parser.add_argument("--size", type=size, metavar="WxH", help="of the images, such as 640x480")
    parser.add_argument("--fps", type=lambda text: number(text, 0.01, 1e6), metavar="N", help="frames a second")
    parser.add_argument("--disparities", type=count, metavar="D", help="the range, 2 ... 256")
    parser.add_argument(
        "--with",
        dest="checks",
        nargs="*",
        default=[],
        choices=sorted(candidates.CHECKS),
        help="checks and steps that the core must have beside those of its algorithm",
    )
    parser.add_argument(
        "--set",
        dest="settings",
        action="append",
        default=[],
        type=setting,
        metavar="NAME=VALUE",
        help="any other option of docs/options.md, such as pixel_bits=10; may be repeated",
    )
    parser.add_argument(
        "--fill",
        type=lambda text: number(text, 1, 100),
        default=85.0,
        metavar="PERCENT",
        help="of the look-up tables and of the flip-flops that the core may take (default 85)",
    )
    parser.add_argument(
        "--margin",
        type=lambda text: number(text, 0, 1000),
        default=20.0,
        metavar="PERCENT",
        help="by which an estimated clock must be above the needed one (default 20)",
    )
    parser.add_argument("--all", action="store_true", help="show every number of clocks a pixel pair that fits")
    parser.add_argument(
        "--choose",
        type=count,
        metavar="N",
        help="show row and commands of number N (default the smallest of those whose wrong pixels are within a percent "
        "of the fewest)",
    )
    parser.add_argument("--name", help="of the row to add (default after its base, size and clocks)")
    parser.add_argument("--json", action="store_true", help="print everything as JSON")
    pages = parser.add_mutually_exclusive_group()
    pages.add_argument(
        "--page", action="store_true", help="instead write docs/plan.md: estimates beside all measured cores"
    )
    pages.add_argument("--check", action="store_true", help="instead only say whether docs/plan.md is up to date")
    options = parser.parse_args()
    if options.page or options.check:
        parser.refuse_beside("--page" if options.page else "--check")
    return options


def camera_of(options: Namespace) -> Camera:
    for name in ("size", "fps", "disparities"):
        if getattr(options, name) is None:
            raise FlowError(f"--{name} is missing (see plan.py --help)")
    if not 2 <= options.disparities <= 256:
        raise FlowError("--disparities must be 2 ... 256")
    width, height = options.size
    if width <= options.disparities:
        raise FlowError("--size must be wider than --disparities")
    settings = dict(options.settings)
    for name in settings:
        if sum(other == name for other, _ in options.settings) > 1:
            raise FlowError(f"--set {name} appears twice")
    fixed = {"width_px", "height_px", "disparities"} & settings.keys()
    if fixed:
        raise FlowError(f"--set {fixed.pop()}: the camera's size and range have options of their own")
    return Camera(width, height, options.disparities, options.fps, tuple(dict.fromkeys(options.checks)), settings)


def place_of(options: Namespace) -> search.Place:
    known = devices.device_of(options.device)
    if known is None and None in (options.luts, options.flip_flops, options.block_rams):
        raise FlowError(f"what {options.device} holds is not known: give --luts, --flip-flops and --block-rams")
    flip_flops = options.flip_flops if options.flip_flops is not None else known.flip_flops if known else 0
    luts = options.luts if options.luts is not None else known.lut_sites if known else 0
    block_rams = options.block_rams if options.block_rams is not None else known.block_rams if known else 0
    if luts == 0:
        raise FlowError("--luts must be 1 or more")
    return search.Place(options.device, devices.Device(luts, flip_flops, block_rams), options.fill, options.margin)


def main() -> int:
    options = parse()
    if options.page or options.check:
        return files.update(page.pages(), options.check, "scripts/plan.py --page")
    camera, place = camera_of(options), place_of(options)
    if options.name is not None and not re.fullmatch(r"[a-z]\w{0,60}", options.name):
        raise FlowError("--name must be a C++ name that begins with a small letter")
    if options.name in configurations():
        raise FlowError(f"--name {options.name}: is a configuration already")
    candidates.check(camera, algorithms())
    planner = search.Planner(algorithms())
    plans = planner.plan(camera, place)
    chosen = search.best(plans)
    shown = search.ordered(planned for planned in plans if planned.fits) if options.all else chosen
    row = None
    if shown:
        choice = search.recommended(shown) + 1 if options.choose is None else options.choose
        if not 1 <= choice <= len(shown):
            raise FlowError(f"--choose must be 1 ... {len(shown)}")
        row = plan_text.Row.of(choice, shown[choice - 1], place, options.name)
    if options.json:
        print(json.dumps(plan_text.as_json(camera, place, shown, search.closest(plans), row), indent=1))
    else:
        print(plan_text.text(camera, place, shown, search.closest(plans), row, planner.known))
    return EXIT_OK if shown else EXIT_MISMATCH


if __name__ == "__main__":
    run_command(main)
