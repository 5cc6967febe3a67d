#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates the generated VHDL of configurations against the C++ core on a stereo pair, to the last bit and
clock."""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import farm
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.places import build_folder
from flow.cosim import job, record, regression
from flow.cosim.simulators import SIMULATORS

MOST_SECONDS = 1e6

# What counts where the stream comes from a file.
WITH_A_FILE = (
    *("--config", "--stimulus", "--expected", "--simulator", "--rtl", "--allow-edited", "--out", "--wave"),
    *("--coverage", "--watchdog", "--jobs", "--scheduler", "--fail-fast", "--changed", "--record"),
)


def main() -> int:
    parser = ArgumentParser(prog="cosim.py", description=__doc__)
    parser.add_argument(
        "--config",
        dest="configs",
        required=True,
        nargs="+",
        action="extend",
        metavar="NAME",
        help="named configurations (see stereo_hls configurations), patterns such as 'tiny*', or all: those with VHDL",
    )
    farm.add_options(parser, 1, "configurations")
    parser.add_argument("--fail-fast", action="store_true", help="start no more configurations after a failure")
    parser.add_argument(
        "--changed",
        action="store_true",
        help="only configurations that have not passed into --out before with the same VHDL, model, tools and options",
    )
    parser.add_argument("--left", type=a_path, help="left image of a rectified pair, sent after the stress stream")
    parser.add_argument("--right", type=a_path, help="right image")
    parser.add_argument(
        "--stimulus",
        metavar="stress|scene|FILE",
        help="stress (default): a stream that is made to find faults, then the images, if any are given; "
        "scene: the images alone, or a generated scene; FILE: your own stimulus.txt, with --expected",
    )
    parser.add_argument(
        "--stress-clocks",
        type=int,
        metavar="N",
        help="at least N clocks of the stress stream: streams of other seeds follow each other (default 80000, three "
        "of a small core)",
    )
    parser.add_argument("--expected", type=a_path, help="the expected.txt of your own stimulus.txt")
    parser.add_argument(
        "--rows",
        metavar="A:B|N",
        help="send only image rows A ... B-1, as the top of a frame; or the middle N rows, more if an output needs "
        "them",
    )
    parser.add_argument(
        "--frames", type=int, default=1, help="frames back to back; every second one upside down (default 1)"
    )
    parser.add_argument(
        "--broken",
        type=int,
        default=0,
        metavar="N",
        help="send N stream faults instead of frames: frames broken off, records without a start of frame, resets",
    )
    parser.add_argument(
        "--stall-percent", type=int, default=0, help="random bubbles in the input, 0 ... 95 %% (default 0)"
    )
    parser.add_argument("--seed", type=int, default=1, help="seed of the bubbles and filler pixels (default 1)")
    parser.add_argument(
        "--fit", choices=("none", "crop", "resize"), default="none", help="how to adapt images of another size"
    )
    parser.add_argument("--simulator", choices=sorted(SIMULATORS), help="default ghdl, with --coverage verilator")
    parser.add_argument("--rtl", type=a_path, help="folder with manifest.json and VHDL (default: the committed ones)")
    parser.add_argument(
        "--allow-edited", action="store_true", help="take VHDL that differs from its manifest, for experiments"
    )
    parser.add_argument(
        "--out",
        type=a_path,
        help="folder for the reports (default build/cosim/CONFIG-SIMULATOR, of several configurations "
        "build/cosim/regression; in $XDG_CACHE_HOME if build/ cannot be written)",
    )
    parser.add_argument(
        "--wave",
        type=a_path,
        metavar="FILE",
        help="write a waveform around the first mismatch: .ghw, .fst or .vcd (ghdl), .fst (verilator, nvc)",
    )
    parser.add_argument(
        "--coverage",
        action="store_true",
        help="run in Verilator and list bits of registers that never took both values and branches that never ran",
    )
    parser.add_argument(
        "--watchdog",
        dest="watchdog_seconds",
        type=float,
        default=300.0,
        metavar="SECONDS",
        help="stop a simulation after this time without progress (default 300)",
    )
    parser.add_argument(
        "--record",
        action="store_true",
        help="write the result into cosimulation.json beside the VHDL: that of the images alone, for "
        "docs/performance.md, or with --stimulus stress that of the stress stream",
    )
    options = parser.parse_args()
    if options.coverage and options.simulator not in (None, "verilator"):
        raise FlowError(f"--coverage runs in verilator, not in {options.simulator}")
    options.simulator = options.simulator or ("verilator" if options.coverage else "ghdl")
    _choose_stimulus(options)
    _check(options)
    if options.stimulus:
        parser.refuse_beside("--stimulus FILE", *WITH_A_FILE)
    if len(set(options.configs)) > 1 or regression.is_pattern(options.configs[0]):
        return _several(options)
    if options.jobs != 1 or options.scheduler or options.fail_fast or options.changed:
        raise FlowError("--jobs, --scheduler, --fail-fast and --changed are for several configurations")
    fields = {name: value for name, value in vars(options).items() if name in job.Job.__dataclass_fields__}
    design = record.design(options.configs[0]) if options.record else {}
    report = job.run_job(job.Job(options.configs[0], **fields))
    if options.record:
        record.keep([(report, design)], stimulus(options))
    return job.exit_code(report)


def _choose_stimulus(options: argparse.Namespace) -> None:
    """options.stress says whether the stress stream is sent; options.stimulus is a file or None from here on."""
    word, options.stress = options.stimulus, False
    if options.expected:
        options.stimulus = None if word is None else a_path(word)
        return
    if word not in (None, "stress", "scene"):
        raise FlowError(f"--stimulus {word}: must be stress or scene, or a file together with --expected")
    options.stress, options.stimulus = word == "stress" or word is None and not options.record, None


def stimulus(options: argparse.Namespace) -> record.Stimulus:
    return "stress" if options.stress else "runs"


def _check(options: argparse.Namespace) -> None:
    if options.record and (options.rtl or options.simulator == "original" or options.stimulus or options.allow_edited):
        raise FlowError(
            "--record keeps results of the committed VHDL: no --rtl, --allow-edited, --stimulus, "
            "no --simulator original"
        )
    for one, other in (("left", "right"), ("stimulus", "expected")):
        if (getattr(options, one) is None) != (getattr(options, other) is None):
            raise FlowError(f"--{one} and --{other} go together: both are required")
    if options.stimulus and (options.left or options.rows or options.broken or options.stall_percent):
        raise FlowError("--stimulus takes the place of images, --rows, --broken and --stall-percent")
    if options.fit != "none" and not options.left:
        raise FlowError("--fit is for --left and --right")
    if options.stress_clocks is not None and not options.stress:
        raise FlowError(
            "--stress-clocks needs the stress stream, which --record alone and another --stimulus leave out"
        )
    if options.coverage and options.wave:
        raise FlowError("--coverage and --wave are for two runs")
    if options.record and (options.wave or options.coverage):
        raise FlowError(
            "--record keeps results of the VHDL as it is; --wave and --coverage simulate it without its arrays"
        )
    if options.record and options.changed:
        raise FlowError(
            "--record keeps a result of each configuration; --changed leaves out those that have passed before"
        )
    if options.record and options.broken:
        raise FlowError("--record keeps results of frames, rows and the stress stream: no --broken")
    if options.frames < 1:
        raise FlowError("--frames must be at least 1")
    if options.broken < 0:
        raise FlowError("--broken must be at least 0")
    if options.broken and (options.frames != 1 or options.rows):
        raise FlowError("--broken takes the place of --frames and --rows")
    if options.rows == "":
        raise FlowError("--rows must not be empty")
    if not 0 <= options.seed < 2**64:
        raise FlowError(f"--seed must be 0 ... {2**64 - 1}")
    if not 0 < options.watchdog_seconds < MOST_SECONDS:
        raise FlowError(f"--watchdog must be above 0 and below {MOST_SECONDS:g} seconds")


def _several(options: argparse.Namespace) -> int:
    for name in ("rtl", "wave", "expected"):
        if getattr(options, name):
            raise FlowError(f"--{name} is for one configuration")
    words = ["--stimulus", "stress" if options.stress else "scene"]
    for name in ("stress_clocks", "left", "right", "rows", "frames", "broken", "stall_percent", "seed", "fit"):
        value = getattr(options, name)
        if value is not None:
            words += [f"--{name.replace('_', '-')}", str(value)]
    words += ["--watchdog", str(options.watchdog_seconds)]
    words += [f"--{name}" for name in ("allow-edited", "coverage") if getattr(options, name.replace("-", "_"))]
    configs = regression.select(options.configs)
    with farm.of(options, SIMULATORS[options.simulator].tools) as workers:
        return regression.Regression(
            configs,
            options.simulator,
            words,
            [image for image in (options.left, options.right) if image],
            options.out or build_folder() / "cosim" / "regression",
            workers,
            options.fail_fast,
            options.changed,
            stimulus(options) if options.record else None,
        ).run()


if __name__ == "__main__":
    run_command(main)
