# SPDX-License-Identifier: Apache-2.0
"""Records what the signals of stereo_ip really do, for the pictures in docs/integration.md
(scripts/timing_diagrams.py)."""

import json
import os

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge

from bench import Bench
from flow.shell.broken import beats_of

STREAMS = (
    "s_axis_tvalid",
    "s_axis_tready",
    "s_axis_tdata",
    "s_axis_tuser",
    "s_axis_tlast",
    "m_axis_tvalid",
    "m_axis_tready",
    "m_axis_tdata",
    "m_axis_tuser",
    "m_axis_tlast",
)
REGISTERS = (
    "s_axil_awvalid",
    "s_axil_awready",
    "s_axil_awaddr",
    "s_axil_wvalid",
    "s_axil_wready",
    "s_axil_wdata",
    "s_axil_bvalid",
    "s_axil_bready",
    "s_axil_arvalid",
    "s_axil_arready",
    "s_axil_araddr",
    "s_axil_rvalid",
    "s_axil_rready",
    "s_axil_rdata",
)


async def record(dut, names, rows):
    while True:
        await FallingEdge(dut.aclk)
        row = {name: str(getattr(dut, name).value) for name in ("aresetn", *names)}
        rows.append(row)


def keep(name, rows):
    with open(os.path.join(os.environ["STEREO_AXI_DIAGRAMS"], f"{name}.json"), "w", encoding="ascii") as file:
        json.dump(rows, file)


@cocotb.test()
async def start_of_frame(dut):
    """Reset, then a frame whose source pauses once."""
    bench, rows = Bench(dut, "diagram"), []
    cocotb.start_soon(record(dut, STREAMS, rows))
    await bench.start()
    beats = beats_of(bench.pool[0], bench.geometry)
    pauses = iter([False] * 8 + [True] * 2)
    bench.source.set_pause_generator(iter(lambda: next(pauses, False), None))
    bench.send(beats)
    await ClockCycles(dut.aclk, 60)
    keep("start_of_frame", rows)


@cocotb.test()
async def back_pressure(dut):
    """The first disparities of a frame; the sink pauses for a while."""
    bench, rows = Bench(dut, "diagram"), []
    await bench.start()
    cocotb.start_soon(record(dut, STREAMS, rows))
    bench.send(beats_of(bench.pool[0], bench.geometry))
    while not dut.m_axis_tvalid.value:
        await FallingEdge(dut.aclk)
    await ClockCycles(dut.aclk, 2)
    bench.sink.pause = True
    await ClockCycles(dut.aclk, 3)
    bench.sink.pause = False
    await ClockCycles(dut.aclk, 40)
    keep("back_pressure", rows)


@cocotb.test()
async def broken_frame(dut):
    """A start of frame in the last line but one of a frame."""
    bench, rows = Bench(dut, "diagram"), []
    await bench.start()
    cocotb.start_soon(record(dut, STREAMS, rows))
    beats = beats_of(bench.pool[0], bench.geometry)
    bench.send(beats[: len(beats) - bench.geometry.columns - 9] + beats_of(bench.pool[1], bench.geometry))
    await bench.sent()
    await ClockCycles(dut.aclk, 200)
    keep("broken_frame", rows)


@cocotb.test()
async def register_access(dut):
    bench, rows = Bench(dut, "diagram"), []
    await bench.start()
    cocotb.start_soon(record(dut, REGISTERS, rows))
    await bench.write("control", 1)
    await bench.read("id")
    await ClockCycles(dut.aclk, 3)
    keep("register_access", rows)
