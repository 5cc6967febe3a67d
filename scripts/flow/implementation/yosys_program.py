# SPDX-License-Identifier: Apache-2.0
"""The program yosys, which the package pyosys does not bring: `-V`, or `-s SCRIPT`. Runs in the environment that has
the package."""

import sys

from pyosys import libyosys


def main() -> None:
    if sys.argv[1:] == ["-V"]:
        print(libyosys.yosys_maybe_version())
    else:
        _, script = sys.argv[1:]
        libyosys.run_pass(f"script {script}", libyosys.Design())


if __name__ == "__main__":
    main()
