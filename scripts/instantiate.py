#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the VHDL that puts a core between AXI4-Streams, stereo_ip_NAME, or an instance of it to be pasted, or a folder
with all that a vendor's tool wants of it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import committed, files
from flow.base.errors import EXIT_OK, ArgumentParser, FlowError, run_command
from flow.base.options import a_path, megahertz
from flow.kit import constraints, contents, write
from flow.shell import template
from flow.synthesis import manifest


def main() -> int:
    parser = ArgumentParser(prog="instantiate.py", description=__doc__)
    parser.add_argument("--config", required=True, help="named configuration with VHDL")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--instance", action="store_true", help="write an instance to paste")
    what.add_argument("--kit", choices=contents.TOOLS, help="a folder for this tool")
    parser.add_argument("--mhz", type=megahertz, help="clock in the constraints of a kit (default 100)")
    parser.add_argument(
        "--pad-map",
        action="store_true",
        help="in a kit: pad m_axis_tdata with zeros to a power of two of bits, for DMA engines",
    )
    parser.add_argument("--out", type=a_path, help="file to write (default: standard output); of a kit: a new folder")
    options = parser.parse_args()
    folder = committed.folder(options.config)
    if options.config not in committed.known_configurations() and folder.parent.name in committed.STAGES:
        raise FlowError(f"'{options.config}' is a stage in front of a core; it has no stereo_ip")
    manifest.require_as_made(folder)
    if options.kit:
        if options.out is None:
            raise FlowError("--kit needs --out FOLDER")
        write.write(options.kit, options.config, options.out, options.mhz or constraints.DEFAULT_MHZ, options.pad_map)
        return EXIT_OK
    for name, value in (("--mhz", options.mhz), ("--pad-map", options.pad_map)):
        if value:
            raise FlowError(f"{name} is for --kit")
    entry = manifest.read(folder)
    make = template.user_instance if options.instance else template.entity
    text = make(options.config, entry)
    if options.out is None:
        print(text, end="")
    else:
        files.write(options.out, text)
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
