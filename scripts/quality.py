#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/quality.md: our configurations, OpenCV's StereoBM and StereoSGBM against ground truth, in one run, on the
real pair Teddy and on generated scenes. Without the pair only the scenes are measured, and build/quality_scenes.md is
written."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.pages import quality


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
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    arguments = parser.parse_args()
    missing = quality.missing_files(arguments.pair)
    if missing:
        if arguments.check:
            raise FlowError(f"the pair Teddy is not complete, so nothing was checked: {missing[0]} is missing")
        print(f"the pair Teddy is not complete ({missing[0]} is missing): only the scenes are measured")
        page, text = quality.SCENES_PAGE, quality.scenes_page()
    else:
        page, text = quality.PAGE, quality.page(arguments.pair)
    return files.update({page: text}, arguments.check, "scripts/quality.py")


if __name__ == "__main__":
    run_command(main)
