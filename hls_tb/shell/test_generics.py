# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb with other generics than those of its core. Each test names the run that it belongs
to."""

import cocotb
from cocotb.triggers import ClockCycles

from bench import Bench
from flow.shell import script
from flow.shell.broken import beats_of


@cocotb.test()
async def wrong_latency(dut):
    """latency_clocks is not that of the core: core_fault says so as soon as a clock without a group shows it, nothing
    overflows."""
    bench = await Bench(dut, "wrong latency").start()
    bench.rates(50, 0)
    await bench.play(script.send(beats_of(bench.pool[0], bench.geometry)))
    assert await bench.field("status", "core_fault") == 1
    assert not bench.watch.breaches
    assert len(bench.watch.segments[-1][0]) == bench.geometry.groups
    await bench.write("status", 1 << bench.map["status"]["fields"]["core_fault"]["low"])
    assert await bench.field("status", "core_fault") == 0


@cocotb.test()
async def starts_disabled(dut):
    """enabled_at_reset = false: nothing is taken before the register says so, after each reset."""
    bench = await Bench(dut, "disabled").start()
    for _ in range(2):
        assert await bench.read("control") == 0
        bench.send(beats_of(bench.pool[0], bench.geometry))
        await ClockCycles(dut.aclk, bench.geometry.groups)
        assert not bench.watch.segments[-1][1]
        await bench.write("control", 1)
        await bench.quiet()
        assert bench.judge().exact_frames >= 1
        await bench.reset(1)
