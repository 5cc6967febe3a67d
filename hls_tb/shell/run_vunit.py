# SPDX-License-Identifier: Apache-2.0
"""Runs a bench under VUnit: run_vunit.py --output-path DIR VHDL... in compile order."""

from vunit import VUnit, VUnitCLI

cli = VUnitCLI()
cli.parser.add_argument("--vhdl", nargs="+", required=True)
arguments = cli.parse_args()
vunit = VUnit.from_args(arguments, compile_builtins=False)
vunit.add_vhdl_builtins()
vunit.add_verification_components()
vunit.add_library("design").add_source_files(arguments.vhdl)
vunit.main()
