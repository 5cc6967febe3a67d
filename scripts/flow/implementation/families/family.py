# SPDX-License-Identifier: Apache-2.0
"""What the flow asks of an FPGA family. A new family is a class with these members."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar

from ...base.tools import ROOT

TOP = "stereo_core"  # of every configuration: names can move the figures
# Before each family's own script, which looks at the design module by module and turns `-1 - x` into a carry chain;
# constants folded first make it an inverter. On `tiny` this took 293 of 1,315 MISTRAL_ALUT_ARITH away; on the
# other families, with -abc9, it changes next to nothing.
GENERIC = f"hierarchy -top {TOP}; proc; flatten; opt -full"

Utilization = Mapping[str, Mapping[str, int]]  # {cell: {"used": ..., "available": ...}} of nextpnr's report


class Family:
    """A family without a free router: area by yosys alone."""

    name: ClassVar[str]
    synthesis: ClassVar[str]  # yosys's command, for TOP
    prepare: ClassVar[str] = GENERIC
    # The step of yosys's command that turns memories into RAM; its map_ffram makes flip-flops of the rest.
    map_memories: ClassVar[str] = "map_ram"
    # Where there is no LUT RAM, yosys makes flip-flops of rings of some words, which would fill next to nothing of a
    # block RAM: those of `tiny_sgm` have up to 145 bits. Of a larger memory they are a fault.
    most_bits_in_flip_flops: ClassVar[int] = 0
    lut_name: ClassVar[str] = "LUT4"
    luts: ClassVar[dict[str, int]]  # how many look-up tables a cell takes, by the beginning of its name
    ffs: ClassVar[tuple[str, ...]]
    # How many flip-flops of the device a cell leaves no place for, by its name.
    covered_ffs: ClassVar[dict[str, int]] = {}
    # nextpnr's cell that a LUT and the flip-flop behind it share, and that either takes alone; "": places for
    # flip-flops are others than those for LUTs, so that sites are a matter of LUTs.
    logic_cell: ClassVar[str] = ""
    block_rams: ClassVar[tuple[str, ...]]
    words: ClassVar[dict[str, str]] = {}  # for nextpnr's names of cells, where a device has too few of them


class RoutedFamily(Family):
    """A family that a nextpnr of PyPI places and routes."""

    package: ClassVar[str]
    router: ClassVar[str] = "router1"  # of nextpnr
    options: ClassVar[tuple[str, ...]] = ()  # of nextpnr, for each device
    # The core stands between registers that three pins feed and read (pins.py), behind these buffers.
    few_pins: ClassVar[bool] = True
    buffers: ClassVar[str] = ""  # yosys's commands that add them; "": nextpnr adds its own
    # The way to a bit stream, of a family that a board has.
    packer: ClassVar[str] = ""
    packer_beside: ClassVar[str] = ""  # its name in nextpnr's package
    routed_option: ClassVar[str] = ""  # of nextpnr, in front of the file that the packer reads
    bit_stream: ClassVar[str] = ""  # how the name of its file ends

    @property
    def tool(self) -> str:
        return self.package.removeprefix("yowasp-")

    @property
    def variable(self) -> str:
        """Of the environment, that names another nextpnr."""
        return f"NEXTPNR_{self.name.upper()}"

    @property
    def environment(self) -> str:
        """The folder in build/ that its nextpnr is installed into."""
        return f"venv-{self.name}"

    @property
    def requirements(self) -> Path:
        return ROOT / "scripts" / f"requirements-{self.name}.txt"

    def constraints(self, pins: tuple[str, ...]) -> str:
        """The file that binds clock, scan_in and scan_out to these pins; "" where pins need not be bound."""
        return ""

    def constraint_options(self, file: str) -> tuple[str, ...]:
        """Of nextpnr, that name the file."""
        return ()

    def packer_options(self, options: tuple[str, ...], routed: str, bit_stream: str) -> tuple[str, ...]:
        """For a device with these options of nextpnr."""
        return routed, bit_stream

    def improve(self, module: dict[str, Any]) -> None:
        """What yosys leaves undone in the netlist that nextpnr reads."""

    def lut_sites(self, utilization: Utilization) -> int:
        """What the routed design takes of the device."""
        raise NotImplementedError

    def registers(self, module: dict[str, Any]) -> dict[str, int | str]:
        """{cell as nextpnr's report names it: the bit that it gives} of the flip-flops of a netlist."""
        return {
            name: cell["connections"]["Q"][0]
            for name, cell in module["cells"].items()
            if cell["type"].startswith(self.ffs)
        }
