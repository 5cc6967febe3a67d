#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times the developer's loop, from a changed header to a simulated frame of new VHDL. Writes only to build/."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.dev_loop import DevLoop, Timing


def main() -> int:
    from rich.console import Console
    from rich.table import Table

    parser = ArgumentParser(prog="dev_loop.py", description=__doc__)
    parser.add_argument("--config", default="tiny", metavar="NAME", help="configuration to simulate (default tiny)")
    parser.add_argument(
        "--header", default="cost/window_sum.hpp", help="file of hls/ that is touched (default cost/window_sum.hpp)"
    )
    parser.add_argument("--rows", type=int, default=8, metavar="N", help="rows of the crop in GHDL (default 8)")
    options = parser.parse_args()
    if options.rows < 2:
        raise FlowError("--rows must be 2 or more")
    loop = DevLoop(options.config, options.header, options.rows)
    console = Console(highlight=False, soft_wrap=True)
    timings: list[Timing] = []
    with console.status("bringing the build up to date") as status:
        loop.prepare()
        status.update("the steps of the loop")

        def done(timing: Timing) -> None:
            timings.append(timing)
            seconds = "SKIP" if timing.skipped else f"{timing.seconds:.1f} s"
            why = timing.skipped or timing.failed
            console.print(f"{timing.step}: {seconds}{f': {why}' if why else ''}")

        proven = loop.run(done)
    table = Table("step", "starts at", "seconds", "", title=f"Developer's loop, {options.config}")
    for timing in timings:
        note = timing.skipped or (f"FAILED: {timing.failed}" if timing.failed else timing.note)
        seconds = "SKIP" if timing.skipped else f"{timing.seconds:.1f}"
        table.add_row(timing.step, f"{timing.started:.1f}", seconds, note)
    console.print(table)
    failures = [timing.step for timing in timings if timing.failed]
    if failures:
        raise FlowError(f"failed: {', '.join(failures)}", EXIT_MISMATCH)
    if not any(timing.skipped for timing in timings):
        console.print(f"From the edit to a whole frame in GHDL and in Verilator: {proven:.0f} s.")
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
