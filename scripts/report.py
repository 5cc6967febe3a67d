#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes one self-contained HTML page from the folder that scripts/demo.sh filled."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.pages import demo_folder, report


def main() -> int:
    parser = ArgumentParser(prog="report.py", description=__doc__)
    parser.add_argument("--demo", required=True, type=a_path, metavar="DIR", help="folder of scripts/demo.sh")
    parser.add_argument("--out", type=a_path, metavar="FILE", help="the page (default DIR/report.html)")
    options = parser.parse_args()
    if options.out and options.out.suffix != ".html":
        raise FlowError(f"--out {options.out}: the name of a page ends in .html")
    demo = demo_folder.read_demo(options.demo)
    page = options.out or options.demo / "report.html"
    files.write(page, report.render(demo))
    print(f"Page: {page}, picture: {options.demo / demo_folder.PICTURE}")
    print(report.summary(demo))
    return EXIT_OK if demo.passed else EXIT_MISMATCH


if __name__ == "__main__":
    run_command(main)
