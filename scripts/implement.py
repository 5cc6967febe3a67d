#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Implements the generated VHDL on FPGAs: area by yosys and, where nextpnr knows the device, the clock after place and
route."""

import sys
from argparse import Namespace
from collections.abc import Collection
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, farm
from flow.base.errors import ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import find_ghdl
from flow.implementation import job, nextpnr, yosys
from flow.implementation.targets import TARGETS, USUAL

DEFAULT_SEEDS = [1, 2, 3]
ALONE = ("--target", "--shell", "--seeds", "--router", "--rtl", "--out")  # have an effect beside one --config


def chosen(given: list[str], known: Collection[str], what: str) -> list[str]:
    """The values of a repeated option, 'all' expanded, each checked."""
    for name in given:
        if name not in known and name != "all":
            raise FlowError(f"unknown {what} '{name}'; known are: {', '.join(sorted(known))}")
    return sorted(known) if "all" in given else list(dict.fromkeys(given))


def jobs(options: Namespace) -> list[job.Job]:
    targets = chosen(options.target or list(USUAL), TARGETS, "target")
    if any(seed < 1 for seed in options.seeds):
        raise FlowError("--seeds must be 1 or more")
    seeds = sorted(set(options.seeds))
    if options.rtl:
        if len(options.config) != 1 or options.config == ["all"]:
            raise FlowError("--rtl takes the VHDL of one --config")
        if options.shell:
            raise FlowError("--shell takes the committed VHDL, not that of --rtl")
        names = options.config
    else:
        names = chosen(options.config, committed.known_designs(), "configuration")
        stages = [name for name in names if options.shell and name not in committed.known_configurations()]
        if stages:
            raise FlowError(f"--shell is for matching cores; {stages[0]} is a stage and has no shell")
    made = []
    for name in names:
        vhdl = options.rtl or committed.folder(name)
        made.append(
            job.Job(
                name,
                vhdl,
                options.out / name if options.out else options.rtl,
                targets,
                seeds,
                options.shell,
                options.router,
            )
        )
    return made


def main() -> int:
    parser = ArgumentParser(prog="implement.py", description=__doc__)
    parser.add_argument(
        "--config",
        action="append",
        required=True,
        metavar="NAME",
        help="configuration, may be repeated; 'all' for each with VHDL",
    )
    parser.add_argument(
        "--target",
        action="append",
        metavar="TARGET",
        help=f"{', '.join(TARGETS)} or all, may be repeated (default {', '.join(USUAL)})",
    )
    parser.add_argument(
        "--shell", action="store_true", help="stereo_ip_NAME, the core in its AXI shell, instead of the core alone"
    )
    parser.add_argument(
        "--seeds",
        type=int,
        nargs="+",
        default=DEFAULT_SEEDS,
        metavar="N",
        help="seeds of place and route (default 1 2 3)",
    )
    parser.add_argument(
        "--router",
        choices=nextpnr.ROUTERS,
        help="router of nextpnr (default: that of the family, mostly router1; router2 ends where router1 does not, "
        "with longer clock periods)",
    )
    parser.add_argument("--rtl", type=a_path, help="folder with manifest.json and VHDL (default: the committed ones)")
    parser.add_argument("--out", type=a_path, help="implementation.json goes to OUT/CONFIG (default beside the VHDL)")
    farm.add_options(parser, 1, "configurations")
    options = parser.parse_args()
    work = jobs(options)
    if len(work) == 1 and not options.scheduler:
        parser.refuse_beside("one --config", "--config", *ALONE)
    if not any(TARGETS[name].device for one in work for name in one.targets):
        for option, value in (("--seeds", options.seeds != DEFAULT_SEEDS), ("--router", options.router)):
            if value:
                raise FlowError(f"{option} is for place and route, which none of these targets has")
    for one in work:
        job.checked_manifest(one)  # before tools are installed
    find_ghdl()
    yosys.find_yosys()
    if not options.scheduler and (len(work) == 1 or options.jobs == 1):
        return max(job.run_job(one) for one in work)
    words = [word for target in options.target or [] for word in ("--target", target)]
    words += ["--seeds", *map(str, options.seeds), *(["--shell"] if options.shell else [])]
    words += ["--router", options.router] if options.router else []
    words += ["--out", str(options.out.resolve())] if options.out else []
    with farm.of(options, job.tools) as workers:
        commands = {one.config: ["--config", one.config, *words] for one in work}
        return farm.run_each(workers, "implement.py", commands, job.WORK / "logs")


if __name__ == "__main__":
    run_command(main)
