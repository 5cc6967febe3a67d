#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a static site of the pages with Sphinx, which is installed from PyPI into build/venv-site at the first use.
Any warning is an error. The site loads nothing from other servers."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_OK, ArgumentParser, run_command
from flow.base.files import shown
from flow.base.options import a_path
from flow.base.tools import ROOT
from flow.pages import site
from flow.release.conditions import version


def main() -> int:
    parser = ArgumentParser(prog="site.py", description=__doc__)
    parser.add_argument("--out", type=a_path, default=ROOT / "build" / "site", metavar="DIR", help="default build/site")
    options = parser.parse_args()
    print(f"Site: {shown(site.build(options.out, version()))}")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
