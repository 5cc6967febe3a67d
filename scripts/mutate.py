#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts single faults into copies of the VHDL, of the core of a configuration and of its AXI4-Stream shell, and counts
which of them the tests notice. What they do not notice is equivalent if yosys-abc proves that nothing of it can be seen
from outside; else it has survived."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files, places
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path, one_or_more
from flow.mutation import record
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
    parser.add_argument(
        "--others",
        type=int,
        default=10,
        metavar="N",
        help="stress streams of other seeds that look for what the default one does not show (default 10)",
    )
    parser.add_argument("--jobs", type=one_or_more, default=2, help="mutants at a time (default 2)")
    parser.add_argument("--out", type=a_path, default=WORK, help="folder of report.json (default build/mutation)")
    parser.add_argument("--record", action="store_true", help="keep the result beside the VHDL; with --shell 0")
    parser.add_argument("--page", action="store_true", help="run nothing: write the table of kept results")
    parser.add_argument("--check", action="store_true", help="the same; exit code 1 when it is not up to date")
    options = parser.parse_args()
    if options.page or options.check:
        parser.refuse_beside(*(("--page", "--check") if options.page else ("--check",)))
        return files.update({record.PAGE: record.page()}, options.check, "scripts/mutate.py --page")
    if options.record and (options.shell or options.core < FEW):
        raise FlowError(f"--record keeps what a run gives of the core: it needs --shell 0 and --core {FEW} or more")
    if min(options.core, options.shell, options.others) < 0 or options.core + options.shell < 1:
        raise FlowError("--core, --shell and --others must be 0 or more, --core and --shell together 1 or more")
    places.results_folder(options.out, ("report.json",))
    (options.out / "report.json").unlink(missing_ok=True)  # a run that breaks off leaves none of an earlier one
    together = options.core >= FEW
    run = Run(
        options.seed,
        options.core,
        options.shell,
        options.jobs,
        config=options.config,
        together=together,
        others=options.others,
    )
    return EXIT_MISMATCH if run.run().report(options.out, options.record) else EXIT_OK


if __name__ == "__main__":
    run_command(main)
