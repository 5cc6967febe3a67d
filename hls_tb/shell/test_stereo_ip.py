# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb: streams. Every frame is compared with the C++ core (flow.shell.contract)."""

import cocotb
from cocotb.triggers import ClockCycles, FallingEdge, Timer

from bench import Bench, add_tests
from flow.shell import script
from flow.shell.broken import CASES, beats_of
from flow.shell.contract import RESULT_START, expect

MOST_GAPS = 60  # that one run tries, beside the shortest


async def frames(dut, name):
    return await Bench(dut, name).start()


def full_frames(bench, count):
    return script.send(
        [beat for _ in range(count) for beat in beats_of(bench.random.choice(bench.pool), bench.geometry)]
    )


@cocotb.test()
async def full_speed(dut):
    """Frames back to back: as many clocks a frame as the core takes, none lost within a line."""
    bench = await frames(dut, "full speed")
    await bench.play(full_frames(bench, 4))
    assert bench.judge().exact_frames == 4
    results = bench.watch.segments[-1][1]
    starts = [clock for _, flags, clock in results if flags & RESULT_START]
    period = bench.geometry.groups + bench.parameters["gap_groups"]
    assert {b - a for a, b in zip(starts, starts[1:])} == {period}, starts
    width = bench.geometry.result_columns
    for first in range(0, len(results), width):
        clocks = [clock for _, _, clock in results[first : first + width]]
        assert clocks == list(range(clocks[0], clocks[0] + width)), "a clock was lost within a line"


@cocotb.test()
async def sink_waits_then_takes_all(dut):
    """The sink stands still until the shell is full: until as many disparities are due as the output queue has words,
    or one or two fewer, and three beats are in the input buffer. Then it takes a beat in each clock: no bubble, nothing
    lost."""
    bench = await frames(dut, "sink waits")
    bench.sink.pause = True
    bench.send(beats_of(bench.pool[0], bench.geometry) + beats_of(bench.pool[1], bench.geometry))
    await ClockCycles(dut.aclk, 3 * bench.geometry.columns + 200)
    stopped = len(bench.watch.segments[-1][0])
    await ClockCycles(dut.aclk, 100)
    assert len(bench.watch.segments[-1][0]) == stopped, "the shell did not stop its source"
    words, needs = bench.parameters["latency_clocks"] + 9, bench.pool[0].needs
    assert needs[words - 3] + 3 <= stopped <= needs[words - 1] + 3, f"{stopped} beats came in"
    bench.sink.pause = False
    await bench.quiet()
    assert bench.judge().exact_frames == 2
    clocks = [clock for _, _, clock in bench.watch.segments[-1][1]][: bench.geometry.result_columns]
    assert clocks == list(range(clocks[0], clocks[0] + len(clocks))), "a bubble after the wait"


async def random_stalls(dut, source, sink):
    bench = await frames(dut, f"stalls {source} {sink}")
    bench.rates(source, sink)
    await bench.play(script.frames(bench.random, bench.pool, bench.geometry, 4))
    assert bench.judge().exact_frames == 4


add_tests(
    globals(),
    "stalls",
    random_stalls,
    [(10, 0), (0, 10), (50, 0), (0, 50), (30, 30), (50, 50), (80, 10), (10, 80), (90, 90)],
)


async def hold_between_frames(bench, lengths):
    """Keeps the source from offering anything for so many clocks after the last beat of each frame."""
    for number, length in enumerate(lengths, 1):
        while len(bench.watch.taken) < number * bench.geometry.groups:
            await FallingEdge(bench.dut.aclk)
            await Timer(1, "ns")  # the watch has seen the beat that moves at the next rising edge
        bench.source.pause = length > 0
        await ClockCycles(bench.dut.aclk, length)
        await FallingEdge(bench.dut.aclk)
        bench.source.pause = False


@cocotb.test()
async def gaps_of_all_lengths(dut):
    """Frames come at each clock of the flush of the one before, or at some of them where it is long."""
    bench = await frames(dut, "gaps")
    longest = bench.parameters["flush_groups"] + bench.parameters["latency_clocks"] + 8
    lengths = [*range(8), *bench.random.sample(range(8, longest), min(longest - 8, MOST_GAPS)), longest]
    bench.random.shuffle(lengths)
    cocotb.start_soon(hold_between_frames(bench, lengths))
    await bench.play(full_frames(bench, len(lengths) + 1))
    assert bench.judge().exact_frames == len(lengths) + 1
    groups, taken = bench.geometry.groups, bench.watch.taken
    gaps = [taken[number * groups] - taken[number * groups - 1] - 1 for number in range(1, len(lengths) + 1)]
    for gap, length in zip(gaps, lengths):  # the shell may make a frame wait that comes in the gap which the core needs
        assert gap == length or gap > length < bench.parameters["gap_groups"], "a frame did not come when it should"


async def broken_stream(dut, case):
    """The case at full speed and with stalls; each time the next correct frame is exact. Status shows just its
    errors."""
    bench = await frames(dut, case)
    steps = script.broken(bench.random, bench.pool, bench.geometry, case)
    steps += [("rates", 25, 25), *script.broken(bench.random, bench.pool, bench.geometry, case)]
    await bench.play(steps)
    bench.judge()
    last = bench.watch.segments[-1][1][-bench.geometry.results :]
    assert not any(flags & 2 for _, flags, _ in last), "the correct frame after the broken ones is marked"
    expected = expect(bench.watch.segments[-1][0], bench.geometry)
    status = await bench.read("status")
    seen = {field for field, place in bench.map["status"]["fields"].items() if status >> place["low"] & 1}
    assert seen == expected.errors, f"status shows {sorted(seen)}, expected {sorted(expected.errors)}"
    assert await bench.read("frames") == sum(frame.whole for frame in expected.frames)
    assert await bench.read("broken_frames") == sum(frame.broken for frame in expected.frames)


add_tests(globals(), "broken", broken_stream, [(case,) for case in sorted(CASES)])


@cocotb.test()
async def reset_at_any_clock(dut):
    """Resets of 1 to 4 clocks in frames, between them, while the sink waits; a frame after each is exact."""
    bench = await frames(dut, "reset")
    for _ in range(12):
        bench.rates(bench.random.choice((0, 30)), bench.random.choice((0, 30, 90)))
        bench.send(
            beats_of(bench.random.choice(bench.pool), bench.geometry)
            + beats_of(bench.random.choice(bench.pool), bench.geometry)
        )
        await ClockCycles(dut.aclk, bench.random.randrange(1, int(2.2 * bench.geometry.groups)))
        await bench.reset(bench.random.randrange(1, 5))
        bench.rates(0, 0)
        if bench.random.random() < 0.7:
            await bench.play(full_frames(bench, 1))
    await bench.play(full_frames(bench, 2))
    assert bench.judge().exact_frames >= 2
    assert await bench.read("status") == 0


@cocotb.test()
async def mixture(dut):
    """Everything at once: rates, gaps, broken streams, resets."""
    bench = await frames(dut, "mixture")
    await bench.play(script.mixture(bench.random, bench.pool, bench.geometry, 12))
    assert bench.judge().exact_frames >= 1
