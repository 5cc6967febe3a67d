#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/post_processing.md and its picture: what each stage of the post-processing does to a map, on the real
pair Teddy, outdoors and on generated scenes."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.pages import post_processing, quality


def main() -> int:
    parser = ArgumentParser(prog="post_processing.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    arguments = parser.parse_args()
    pair = quality.default_pair()
    if missing := quality.missing_files(pair):
        raise FlowError(f"the pair Teddy is missing, so the page cannot be made: {missing[0]}")
    outdoors = post_processing.outdoor_pairs()
    if paths := [path for one in outdoors for path in one.missing]:
        raise FlowError(f"a pair is missing, so the page cannot be made: {paths[0]}")
    return files.update(post_processing.pages(pair, outdoors), arguments.check, "scripts/post_processing.py")


if __name__ == "__main__":
    run_command(main)
