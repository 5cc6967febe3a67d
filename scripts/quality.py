#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/quality.md: our configurations, OpenCV's StereoBM and StereoSGBM against ground truth, in one run, on the
real pair Teddy, on pairs of roads, a yard and a room, and on generated scenes. Without the pairs only the scenes are
measured, and build/quality_scenes.md is written. With --pairs only those of another list, for the terminal."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.pages import quality, quality_pairs
from flow.quality.pairs import OWN_LIST, read_pairs


def main() -> int:
    parser = ArgumentParser(prog="quality.py", description=__doc__)
    parser.add_argument(
        "--pair",
        metavar="FOLDER",
        type=a_path,
        default=quality.default_pair(),
        help="Teddy: left.png, right.png, disp_left_x4.pgm, disp_right_x4.pgm "
        "(default: teddy below env STEREO_DATA, else below ../shared/data/stereo)",
    )
    parser.add_argument(
        "--pairs",
        metavar="LIST",
        type=a_path,
        help="JSON list of other pairs, as scripts/flow/quality/pairs.json: prints their tables, writes no page",
    )
    parser.add_argument(
        "--pictures",
        metavar="FOLDER",
        type=a_path,
        help="draw each pair of the list, its disparities and the error in colour; writes no page",
    )
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    arguments = parser.parse_args()
    pairs = read_pairs(arguments.pairs or OWN_LIST)
    missing = [str(path) for pair in pairs for path in pair.missing]
    if arguments.check:
        parser.refuse_beside("--check", "--pair")
    if arguments.pairs or arguments.pictures:
        if missing:
            raise FlowError(f"a pair of the list is not complete: {missing[0]} is missing")
        if arguments.pictures:
            quality_pairs.draw_pictures(pairs, arguments.pictures)
        if arguments.pairs:
            print(*quality_pairs.tables(pairs), sep="\n\n")
        return 0
    missing = quality.missing_files(arguments.pair) + missing
    if missing:
        if arguments.check:
            raise FlowError(f"the pairs are not complete, so nothing was checked: {missing[0]} is missing")
        print(f"the pairs are not complete ({missing[0]} is missing): only the scenes are measured")
        page, text = quality.SCENES_PAGE, quality.scenes_page()
    else:
        page, text = quality.PAGE, quality.page(arguments.pair, quality_pairs.text(pairs))
    return files.update({page: text}, arguments.check, "scripts/quality.py")


if __name__ == "__main__":
    run_command(main)
