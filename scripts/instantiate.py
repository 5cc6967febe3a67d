#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the VHDL that puts stereo_ip into a design: an entity without generics for one configuration, or only its
instance."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_OK, ArgumentParser, run_command
from flow.base.tools import GENERATED_RTL
from flow.shell import design, template
from flow.synthesis import manifest


def main() -> int:
    parser = ArgumentParser(prog="instantiate.py", description=__doc__)
    parser.add_argument("--config", required=True, help="named configuration of generated_rtl/")
    parser.add_argument("--instance", action="store_true", help="only the instance, to be pasted")
    parser.add_argument("--out", type=Path, help="file to write (default: standard output)")
    options = parser.parse_args()
    manifest.read(GENERATED_RTL / options.config)
    values = design.generics(options.config)
    text = template.instance(values, "stereo") + "\n" if options.instance else template.entity(options.config, values)
    if options.out is None:
        print(text, end="")
    else:
        files.write(options.out, text)
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
