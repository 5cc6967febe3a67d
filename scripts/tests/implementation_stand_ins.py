# SPDX-License-Identifier: Apache-2.0
"""Stand-in executables for the tools that implement.py calls. Each records its command line and writes a small
answer."""

import json

SHELL = "module stereo_ip_tiny\\nendmodule\\n"
PORTS = "(input  clock,\\n   input  [7:0] left_pixel,\\n   input  valid,\\n   output [7:0] disparity);"
REGISTERS = "assign raster_left = n1_q;\\n  assign slice0cost_column_0 = n2_q;"
CORE = f"module stereo_core_tiny\\n  {PORTS}\\n  {REGISTERS}\\nendmodule"
CELLS = {"LUT4": 10, "CCU2C": 3, "TRELLIS_DPR16X4": 2, "PFUMX": 4, "TRELLIS_FF": 7, "DP16KD": 1}


def netlist(register="TRELLIS_FF", top="stereo_core", instance="", cells=None):
    """Of two registers of this type, with other cells."""
    registers = {
        name: {
            "type": register,
            "port_directions": {"Q": "output", "D": "input"},
            "connections": {"Q": [bit], "D": [bit + 10]},
        }
        for name, bit in (("a", 5), ("b", 6))
    }
    wires = {"raster_left": {"bits": [5]}, "n1_q": {"bits": [5]}, "n2_q": {"bits": [6]}}
    module = {
        "ports": {},
        "netnames": {instance + name: wire for name, wire in wires.items()},
        "cells": registers | (cells or {}),
    }
    return {"modules": {top: module}}


NETLIST = netlist()
MEMORY = "  cell $mem_v2 \\rows.memory\n    parameter \\SIZE 320\n    parameter \\WIDTH 16\n"
GHDL = f"""case "$*" in *--version*) echo 'GHDL 2.0.0 (stand-in)';; *--synth*) printf '{SHELL}{CORE}\\n';; esac"""


def report(mhz, utilization=None, cells="ab"):
    """`cells`: as nextpnr calls the two registers."""
    first, last = cells
    return {
        "fmax": {"clock": {"achieved": mhz, "constraint": 150}},
        "utilization": utilization or {"TRELLIS_COMB": {"used": 40}},
        "critical_paths": [
            {"from": "<async>", "to": "posedge clock", "path": []},
            {
                "from": "posedge clock",
                "to": "posedge clock",
                "path": [
                    {"from": {"cell": first}, "to": {"cell": first}},
                    {"from": {"cell": "x"}, "to": {"cell": last}},
                ],
            },
        ],
    }


def tool(folder, name, body):
    """An executable shell script that records its arguments in NAME.calls and then does `body`."""
    path = folder / name
    path.write_text(f'#!/bin/sh\necho "$*" >> {folder}/{name}.calls\n{body}\n')
    path.chmod(0o755)
    return path


def yosys_body(cells=None, lost="", statistics=None, netlist=NETLIST, around=None, memory=MEMORY):
    """yosys as flow.yosys.script drives it: the files are what the script names."""
    modules = {"stereo_core": cells or CELLS, **({"stereo_pins": around} if around else {})}
    stat = (
        json.dumps({"modules": {f"\\{name}": {"num_cells_by_type": counted} for name, counted in modules.items()}})
        if statistics is None
        else statistics
    )
    files = {"memories.txt": memory, "unmapped.txt": lost, "stat.json": stat, "netlist.json": json.dumps(netlist)}
    writes = "\n".join(f"cat > {name} <<'END'\n{text}\nEND" for name, text in files.items())
    return f'if [ "$1" = -V ]; then echo "Yosys 0.23 (stand-in)"; exit; fi\n{writes}'


def nextpnr_body(mhz_by_seed, otherwise="", **of_report):
    """`otherwise`: what it does with other seeds."""
    cases = "\n".join(
        f"*'--seed {seed} '*) cat > report_{seed}.json <<'END'\n{json.dumps(report(mhz, **of_report))}\nEND\n;;"
        for seed, mhz in mhz_by_seed.items()
    )
    return f"case \"$*\" in --version) echo '(Version nextpnr-0.0)' >&2;;\n{cases}\n*) {otherwise};;\nesac"


def environment(folder, yosys=None, nextpnr=None, ghdl=GHDL, family="ecp5"):
    """The variables that make implement.py take the stand-ins."""
    folder.mkdir(parents=True, exist_ok=True)
    bodies = {
        "GHDL": ghdl,
        "YOSYS": yosys or yosys_body(),
        f"NEXTPNR_{family.upper()}": nextpnr or nextpnr_body({1: 120.5, 2: 140.25, 3: 131.0}),
    }
    return {variable: str(tool(folder, variable.lower(), body)) for variable, body in bodies.items()}


def calls(folder, name):
    path = folder / f"{name}.calls"
    return path.read_text().splitlines() if path.is_file() else []
