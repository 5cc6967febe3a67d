#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the VHDL package and the documentation table of the registers from hls/rtl/registers.json."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow import registers  # noqa: E402
from flow.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, run_command  # noqa: E402
from flow.tools import ROOT  # noqa: E402


def main():
    parser = ArgumentParser(prog="registers.py", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit code 1 when a file is not up to date")
    check = parser.parse_args().check
    stale = {path: text for path, text in registers.made_files().items() if not path.is_file() or path.read_text() != text}
    for path, text in stale.items():
        print(f"{path.relative_to(ROOT)} {'is not up to date' if check else 'written'}")
        if not check:
            path.write_text(text)
    return EXIT_MISMATCH if check and stale else EXIT_OK


if __name__ == "__main__":
    run_command(main)
