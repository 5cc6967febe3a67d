#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/features.md, what each option costs, from the committed manifests and implementation results. Runs no tool."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow import features, files  # noqa: E402
from flow.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command  # noqa: E402


def main():
    parser = ArgumentParser(prog="features.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    text = features.page() if not parser.parse_args().check else None
    if text is None:
        if not features.is_up_to_date():
            raise FlowError("docs/features.md is not up to date; run scripts/features.py", EXIT_MISMATCH)
        print("docs/features.md is up to date")
        return EXIT_OK
    files.write(features.PAGE, text)
    print(f"wrote {features.PAGE.relative_to(features.ROOT)}")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
