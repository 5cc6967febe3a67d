#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts single faults into copies of the VHDL, of the core of a configuration and of its AXI4-Stream shell, and counts
which of them the tests notice. What they do not notice is equivalent if yosys-abc proves that nothing of it can be seen
from outside; else it has survived."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.mutation.judges import WORK
from flow.mutation.run import Run

FEW = 10  # mutants of a core: below, one build for all costs more than it saves


def main() -> int:
    parser = ArgumentParser(prog="mutate.py", description=__doc__)
    parser.add_argument(
        "--config", default="tiny", metavar="NAME", help="a small configuration, or a stage (default tiny)"
    )
    parser.add_argument("--core", type=int, default=60, metavar="N", help="mutants of the generated VHDL (default 60)")
    parser.add_argument(
        "--shell", type=int, default=60, metavar="N", help="mutants of the hand-written VHDL (default 60)"
    )
    parser.add_argument(
        "--seed",
        type=int,
        nargs="+",
        default=[1],
        help="which mutants are chosen; several: so many for each (default 1)",
    )
    parser.add_argument("--jobs", type=int, default=2, help="mutants at a time (default 2)")
    parser.add_argument("--out", type=a_path, default=WORK, help="folder of report.json (default build/mutation)")
    options = parser.parse_args()
    if min(options.core, options.shell) < 0 or options.core + options.shell < 1 or options.jobs < 1:
        raise FlowError("--core and --shell must be 0 or more, together and --jobs 1 or more")
    (options.out / "report.json").unlink(missing_ok=True)  # a run that breaks off leaves none of an earlier one
    run = Run(
        options.seed, options.core, options.shell, options.jobs, config=options.config, together=options.core >= FEW
    )
    return EXIT_MISMATCH if run.run().report(options.out) else EXIT_OK


if __name__ == "__main__":
    run_command(main)
