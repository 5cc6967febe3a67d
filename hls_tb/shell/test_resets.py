# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb: resets of the stereo_ip, and soft resets."""

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge, with_timeout

from bench import PERIOD_NS, Bench, add_tests
from flow.shell import script
from flow.shell.contract import LAST, RESULT_ERROR, START


@cocotb.test()
async def reset_forgets_a_break(dut):
    """Behind a broken frame beats are dropped without an error. Behind a reset they are outside of a frame again."""
    bench = await Bench(dut, "reset behind a break").start()
    await bench.play(script.send([(1, START | LAST), (1, LAST)]))
    assert await bench.field("status", "outside_frame") == 0
    await bench.reset(1)
    await bench.play(script.send([(1, LAST)]))
    assert await bench.field("status", "outside_frame") == 1


async def soft_reset_at(bench, clocks):
    """Sends two frames and asks for a soft reset some clocks later; returns when it is done."""
    bench.send(bench.a_frame() + bench.a_frame())
    await ClockCycles(bench.dut.aclk, clocks)
    await bench.write("control", 3)
    while await bench.read("control") != 1:
        pass
    assert await bench.read("frames") == await bench.read("broken_frames") == 0
    assert await bench.read("status") & ~1 == 0


@cocotb.test()
async def soft_reset(dut):
    """At random clocks of frames and gaps: each frame that has begun still comes whole, the one that was cut with the
    mark; no beat of m_axis is withdrawn; the next frame is exact."""
    bench = await Bench(dut, "soft reset").start()
    size, cut = bench.geometry.results, 0
    for _ in range(10):
        results = bench.watch.segments[-1][1]
        before = len(results)
        bench.rates(bench.random.choice((0, 30)), bench.random.choice((0, 30)))
        await soft_reset_at(bench, bench.random.randrange(1, 2 * bench.geometry.groups))
        await bench.quiet()
        bench.send(bench.a_frame())
        await bench.quiet()
        parts = [results[first : first + size] for first in range(before, len(results), size)]
        assert len(parts[-1]) == size, "a frame ended too soon"
        marks = [bool(part[-1][1] & RESULT_ERROR) for part in parts]
        assert sum(marks) <= 1 and not marks[-1]
        cut += sum(marks)
        maps = {frame.results for frame in bench.pool}
        for part, marked in zip(parts, marks):
            flags = [beat[1] & ~RESULT_ERROR for beat in part]
            width = bench.geometry.result_columns
            assert flags == [(i == 0) | 4 * (i % width == width - 1) for i in range(size)]
            assert marked or tuple(beat[0] for beat in part) in maps, "a frame without mark is not exact"
            assert marked or not any(beat[1] & RESULT_ERROR for beat in part)
        await bench.write("status", 0xFFFFFFFF)
    assert cut >= 3
    assert not bench.watch.breaches, bench.watch.breaches


@cocotb.test()
async def soft_reset_clears_errors_and_events(dut):
    bench = await Bench(dut, "soft reset, errors").start()
    enables = 1 << bench.map["interrupt"]["fields"]["any_error_enable"]["low"]
    await bench.write("interrupt", enables)
    await bench.play(script.send([(1, LAST)] + bench.a_frame()))
    assert await bench.field("status", "outside_frame") == int(dut.irq.value) == 1
    assert await bench.field("interrupt", "frame_done") == await bench.read("frames") == 1
    await bench.write("control", 3)
    while await bench.read("control") != 1:
        pass
    assert (await bench.read("status"), await bench.read("frames"), int(dut.irq.value)) == (0, 0, 0), "left behind"
    assert await bench.read("interrupt") == enables


@cocotb.test()
async def soft_reset_keeps_enable(dut):
    bench = await Bench(dut, "soft reset, enable").start()
    await bench.write("control", 2)
    await ClockCycles(dut.aclk, 4)
    assert await bench.read("control") == 0
    bench.send(bench.a_frame())
    await ClockCycles(dut.aclk, bench.geometry.groups)
    assert not bench.watch.segments[-1][1]
    await bench.write("control", 1)
    await bench.quiet()
    assert bench.judge().exact_frames == 1


async def reset_in_the_middle_of_an_access(dut, half):
    """A reset takes away the half of a write that has come: it is not joined with the next write's other half."""
    bench = await Bench(dut, "reset of registers").start()
    late = bench.other_half(half)
    late.pause = True
    # An address or a value that the next write does not have.
    cocotb.start_soon(bench.write("status", 0) if half == "addresses" else bench.write("control", 1))
    await ClockCycles(dut.aclk, 10)
    taken = {"addresses": "s_axil_aw", "data": "s_axil_w"}[half]
    assert bench.watch.asked[taken] == 1, "nothing was in progress"
    dut.aresetn.value = 0
    await ClockCycles(dut.aclk, 1)
    dut.aresetn.value = 1
    late.pause = False
    await RisingEdge(dut.aclk)
    assert await bench.read("control") == 1
    await with_timeout(cocotb.start_soon(bench.write("control", 0)).join(), 100 * PERIOD_NS, "ns")
    assert await bench.read("control") == 0
    assert not bench.watch.breaches, bench.watch.breaches


add_tests(globals(), "reset_in_the_middle_of", reset_in_the_middle_of_an_access, [("addresses",), ("data",)])


@cocotb.test()
async def reset_while_answers_wait(dut):
    bench = await Bench(dut, "waiting answers").start()
    answers = (bench.axil.write_if.b_channel, bench.axil.read_if.r_channel)
    for channel in answers:
        channel.pause = True
    cocotb.start_soon(bench.write("control", 0))
    cocotb.start_soon(bench.axil.read(bench.map["control"]["offset"], 4))
    await ClockCycles(dut.aclk, 10)
    assert dut.s_axil_bvalid.value and dut.s_axil_rvalid.value
    dut.aresetn.value = 0
    await ClockCycles(dut.aclk, 4)
    dut.aresetn.value = 1
    for channel in answers:
        channel.pause = False
    assert await bench.read("control") == 1
    assert not bench.watch.breaches, bench.watch.breaches
