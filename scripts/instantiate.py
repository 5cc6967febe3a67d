#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the VHDL that puts a core between AXI4-Streams, stereo_ip_NAME, or an instance of it to be pasted."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files, rtl
from flow.base.errors import EXIT_OK, ArgumentParser, run_command
from flow.shell import template
from flow.synthesis import manifest


def main() -> int:
    parser = ArgumentParser(prog="instantiate.py", description=__doc__)
    parser.add_argument("--config", required=True, help="named configuration of generated_rtl/")
    parser.add_argument("--instance", action="store_true", help="only an instance, to be pasted")
    parser.add_argument("--out", type=Path, help="file to write (default: standard output)")
    options = parser.parse_args()
    entry = manifest.read(rtl.folder(options.config))
    make = template.user_instance if options.instance else template.entity
    text = make(options.config, entry)
    if options.out is None:
        print(text, end="")
    else:
        files.write(options.out, text)
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
