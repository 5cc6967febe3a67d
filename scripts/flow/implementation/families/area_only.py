# SPDX-License-Identifier: Apache-2.0
"""Families whose area yosys counts, and that no nextpnr of PyPI places and routes."""

from .family import GENERIC, TOP, Family


class CycloneV(Family):
    # An inverter that is left over takes an ALUT. One MISTRAL_MLAB is 32x1 bits, the memory of one ALUT.
    name = "cyclonev"
    synthesis = f"synth_intel_alm -family cyclonev -top {TOP}"
    # Its own script folds constants of adders less well: this took another sixth of the carry cells of ambrosch2007. It
    # makes flip-flops of a memory with a start value, which no core needs in hardware.
    prepare = f"{GENERIC}; delete t:$meminit*; wreduce; peepopt; opt_clean; alumacc; opt_expr -fine; opt_clean"
    map_memories = "map_bram"
    lut_name = "ALUT"
    luts = {"MISTRAL_ALUT": 1, "MISTRAL_NOT": 1, "MISTRAL_MLAB": 1}
    ffs = ("MISTRAL_FF",)
    block_rams = ("MISTRAL_M10K",)


class Series7(Family):
    # LUT6. CARRY4 and MUXF7/8 stand beside the LUTs. INV is counted, though a later tool may fold some of them.
    name = "xc7"
    synthesis = f"synth_xilinx -abc9 -family xc7 -top {TOP} -flatten"
    map_memories = "map_memory"
    lut_name = "LUT6"
    luts = {"LUT": 1, "INV": 1, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "SRL": 1}
    ffs = ("FDRE", "FDSE", "FDCE", "FDPE")
    block_rams = ("RAMB18E1", "RAMB36E1")
