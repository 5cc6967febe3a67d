# SPDX-License-Identifier: Apache-2.0
"""Proofs about the memory cell, the stream blocks of the shell and the boards' serial line, for all inputs and all
times: `ghdl --synth`, yosys, and the model checker of yosys-abc (property directed reachability), which finds the
invariants by itself."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from ..base import aiger, ghdl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT
from .board_vhdl import FOLDER as BOARDS
from .design import RTL

HARNESSES = ROOT / "hls_tb" / "formal"


@dataclass(frozen=True)
class Proof:
    block: str
    generics: dict[str, int] = field(default_factory=dict)
    folder: Path = RTL
    parts: tuple[str, ...] = ()  # of a block of several files

    @property
    def files(self) -> list[Path]:
        """The block's."""
        return [self.folder / f"{name}.vhd" for name in self.parts or (self.block,)]

    @property
    def name(self) -> str:
        return " ".join([self.block, *(f"{name}={value}" for name, value in self.generics.items())])


PROOFS = (
    Proof("line_memory", {"width": 1}),
    Proof("line_memory", {"width": 10}),  # a word of camera_queue: a pixel of 8 bits and two flags
    Proof("line_memory", {"width": 14}),  # of 12 bits
    Proof("line_memory", {"width": 61}),
    Proof("stream_register", {"flag_bits": 1, "data_bits": 1}),
    Proof("stream_register", {"flag_bits": 1, "data_bits": 2}),
    Proof("stream_register", {"flag_bits": 2, "data_bits": 16}),  # a pair of stereo_joiner
    Proof("stream_register", {"flag_bits": 2, "data_bits": 24}),
    Proof("stream_fifo", {"depth": 1, "width": 1}),
    Proof("stream_fifo", {"depth": 2, "width": 1}),
    Proof("stream_fifo", {"depth": 3, "width": 1}),
    Proof("stream_fifo", {"depth": 4, "width": 1}),
    Proof("stream_credit", {"words": 3, "latency": 2}),
    Proof("stream_credit", {"words": 4, "latency": 1}),
    Proof("stream_credit", {"words": 7, "latency": 3}),
    Proof("uart", {"clocks_per_bit": 4}, BOARDS, ("uart_transmitter", "uart_receiver")),
)


def prove(proof: Proof, work: Path, folder: Path | None = None) -> tuple[str, str]:
    """("proved", "") or ("refuted", in which clock). `folder`: one with other files of the block."""
    top = f"prove_{proof.block}"
    work.mkdir(parents=True, exist_ok=True)
    block = [(folder or path.parent) / path.name for path in proof.files]
    files = [*block, HARNESSES / "reference_queue.vhd", HARNESSES / f"{top}.vhd"]
    aiger.write(ghdl.to_verilog(files, work, top, proof.generics), top, work)
    answer = aiger.prove("read_aiger design.aig; strash", work)
    if answer.proved:
        return "proved", ""
    if not answer.clock:
        raise FlowError(f"yosys-abc came to no end with {proof.name}; see {work / 'abc.log'}", EXIT_TOOL_FAILED)
    return "refuted", answer.clock
