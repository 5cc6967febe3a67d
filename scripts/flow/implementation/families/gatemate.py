# SPDX-License-Identifier: Apache-2.0
"""Cologne Chip GateMate."""

from __future__ import annotations

from .family import TOP, RoutedFamily, Utilization


class GateMate(RoutedFamily):
    # Each of these takes half of a logic element (CPE) but a multiplexer of four, which takes both. nextpnr knows no
    # CC_LUT3, CC_LUT4 and CC_MX8: trees of smaller LUTs take their place.
    name = "gatemate"
    synthesis = f"synth_gatemate -luttree -nomx8 -noiopad -noclkbuf -top {TOP}"
    map_memories = "map_bram"
    most_bits_in_flip_flops = 256
    lut_name = "half CPE"
    luts = {"CC_L2T": 1, "CC_LUT": 1, "CC_ADDF": 1, "CC_MX2": 1, "CC_MX4": 2}
    ffs = ("CC_DFF",)
    block_rams = ("CC_BRAM_20K", "CC_BRAM_40K")
    package = "yowasp-nextpnr-himbaechel-gatemate"
    router = "router2"  # router1 did not end within two minutes on `tiny`
    options = ("--vopt", "allow-unconstrained")
    words = {"CPE_LT": "half CPEs", "CPE_FF": "flip-flops", "RAM_HALF": "halves of block RAMs"}
    buffers = "iopadmap -bits -inpad CC_IBUF Y:I -outpad CC_OBUF A:O; clkbufmap -buf CC_BUFG O:I"

    def lut_sites(self, utilization: Utilization) -> int:
        """Half CPEs, which nextpnr names after what they became."""
        others = ("CPE_FF", "CPE_CPLINES", "CPE_RAMIO")
        cells = (cell for cell in utilization if cell.startswith("CPE_") and not cell.startswith(others))
        return sum(utilization[cell]["used"] for cell in cells)
