# SPDX-License-Identifier: Apache-2.0
"""The FPGA families and devices that a design is implemented on."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..base.tools import ROOT

REQUIREMENTS = ROOT / "scripts" / "requirements.txt"  # yosys and nextpnr from PyPI
TOP = "stereo_core"  # of every configuration: names can move the figures
# Before each target's own script, which looks at the design module by module and turns `-1 - x` into a carry chain;
# constants folded first make it an inverter. On `tiny` this took 293 of 1,315 MISTRAL_ALUT_ARITH away; on the
# other families, with -abc9, it changes next to nothing.
GENERIC = f"hierarchy -top {TOP}; proc; flatten; opt -full"

# Cyclone V's own script folds constants of adders less well: this took another sixth of the carry cells of
# ambrosch2007. It makes flip-flops of a memory with a start value, which no core needs in hardware.
FOLDED = f"{GENERIC}; delete t:$meminit*; wreduce; peepopt; opt_clean; alumacc; opt_expr -fine; opt_clean"


@dataclass(frozen=True)
class Target:
    """One FPGA family, on one device where it is placed and routed. `luts`: how many look-up tables a cell takes, by
    the beginning of its name."""

    name: str
    synthesis: str
    map_memories: str  # the step of the synthesis that turns memories into RAM; map_ffram makes flip-flops of the rest
    lut_name: str
    luts: dict[str, int]
    ffs: tuple[str, ...]
    block_rams: tuple[str, ...]
    device: str | None = None  # this and the next only where the result is placed and routed
    device_options: tuple[str, ...] = ()  # of nextpnr
    prepare: str = GENERIC
    family: str = ""  # the target whose synthesis this one takes; "": its own
    short: str = ""  # device and speed grade, for tables


FAMILIES = {
    target.name: target
    for target in (
        # A carry cell takes both LUTs of its half slice. A 16x4 RAM takes 4 LUTs in two slices for its data and the 2
        # LUTs of a third slice for its write port; nextpnr counts the same ("RAM LUTs", "RAMW LUTs"). PFUMX and L6MUX21
        # are multiplexers beside the LUTs.
        Target(
            "ecp5",
            f"synth_ecp5 -abc9 -top {TOP}",
            "map_ram",
            "LUT4",
            {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6},
            ("TRELLIS_FF",),
            ("DP16KD",),
            "LFE5U-85F-8BG756",
            ("--85k", "--package", "CABGA756", "--speed", "8"),
            short="85F, grade 8",
        ),
        # An inverter that is left over takes an ALUT. One MISTRAL_MLAB is 32x1 bits, the memory of one ALUT.
        Target(
            "cyclonev",
            f"synth_intel_alm -family cyclonev -top {TOP}",
            "map_bram",
            "ALUT",
            {"MISTRAL_ALUT": 1, "MISTRAL_NOT": 1, "MISTRAL_MLAB": 1},
            ("MISTRAL_FF",),
            ("MISTRAL_M10K",),
            prepare=FOLDED,
        ),
        # LUT6. CARRY4 and MUXF7/8 stand beside the LUTs. INV is counted, though a later tool may fold some of them.
        Target(
            "xc7",
            f"synth_xilinx -abc9 -family xc7 -top {TOP} -flatten",
            "map_memory",
            "LUT6",
            {"LUT": 1, "INV": 1, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "SRL": 1},
            ("FDRE", "FDSE", "FDCE", "FDPE"),
            ("RAMB18E1", "RAMB36E1"),
        ),
    )
}


def _other_device(name: str, device: str, device_options: tuple[str, ...], short: str) -> Target:
    """The netlist of ecp5 on another device or speed grade."""
    netlist = FAMILIES["ecp5"]
    return replace(netlist, name=name, device=device, device_options=device_options, short=short, family=netlist.name)


TARGETS = FAMILIES | {
    target.name: target
    for target in (
        _other_device(
            "ecp5_grade6",
            "LFE5U-85F-6BG756",
            ("--85k", "--package", "CABGA756", "--speed", "6"),
            "85F, grade 6",
        ),
        _other_device(
            "ecp5_25f_grade6",
            "LFE5U-25F-6BG381",
            ("--25k", "--package", "CABGA381", "--speed", "6"),
            "25F, grade 6",
        ),
    )
}
ROUTED = [name for name, target in TARGETS.items() if target.device]
