# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb: registers, alone and while frames run."""

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge, with_timeout

from bench import PERIOD_NS, Bench, add_tests
from flow.shell import registers, script
from flow.shell.broken import beats_of
from flow.shell.contract import LAST, RESULT_ERROR, START, expect


def a_frame(bench):
    return beats_of(bench.random.choice(bench.pool), bench.geometry)


@cocotb.test()
async def identification_and_configuration(dut):
    bench = await Bench(dut, "identification").start()
    major, minor, patch = registers.VERSION
    assert await bench.read("id") == registers.ID
    assert await bench.read("version") == major << 16 | minor << 8 | patch
    for register in ("size", "matching", "map"):
        for field in bench.map[register]["fields"]:
            assert await bench.field(register, field) == bench.parameters[field], field
    assert await bench.read("control") == 1
    for name in ("status", "frames", "broken_frames", "frame_clocks"):
        assert await bench.read(name) == 0, name


@cocotb.test()
async def read_only_registers_keep_their_values(dut):
    bench = await Bench(dut, "read only").start()
    before = {name: await bench.read(name) for name in bench.map}
    for name in bench.map:
        if name not in ("control", "status", "interrupt", *registers.settings()):
            await bench.write(name, 0xFFFFFFFF)
    assert {name: await bench.read(name) for name in bench.map} == before


@cocotb.test()
async def settings_that_the_core_does_not_have_are_refused(dut):
    bench = await Bench(dut, "no settings").start()
    for name in registers.settings():
        await bench.write(name, 0)
        assert await bench.field("status", "setting_refused") == 0
        await bench.write(name, 1)
        assert (await bench.read(name), await bench.field("status", "setting_refused")) == (0, 1)
        await bench.write("status", 1 << bench.map["status"]["fields"]["setting_refused"]["low"])
        assert await bench.read("status") == 0


@cocotb.test()
async def interrupt_follows_frames_and_errors(dut):
    bench = await Bench(dut, "interrupt").start()
    fields = {name: 1 << field["low"] for name, field in bench.map["interrupt"]["fields"].items()}

    async def level():
        await ClockCycles(dut.aclk, 3)
        return int(dut.irq.value)

    await bench.play(script.send(a_frame(bench)))
    assert (await bench.read("interrupt"), await level()) == (fields["frame_done"], 0)
    await bench.write("interrupt", fields["frame_done_enable"])
    assert await level() == 1
    await bench.write("interrupt", fields["frame_done_enable"] | fields["frame_done"])
    assert (await bench.read("interrupt"), await level()) == (fields["frame_done_enable"], 0)
    await bench.play(script.send(a_frame(bench)[:5] + a_frame(bench)))
    assert await level() == 1
    both = fields["frame_done_enable"] | fields["any_error_enable"]
    await bench.write("interrupt", both | fields["frame_done"])
    assert (await bench.read("interrupt"), await level()) == (both | fields["any_error"], 1)
    await bench.write("status", 0xFFFFFFFF)
    assert (await bench.read("interrupt"), await level()) == (both, 0)


async def stays_if_it_happens_while_it_is_cleared(dut, register, field):
    """A bit is cleared some clocks before its event, in the very clock of the event, and behind it. Only the last one
    clears it."""
    bench = await Bench(dut, field).start()
    enables = bench.map["interrupt"]["fields"]
    enable = 1 << enables["frame_done_enable" if field == "frame_done" else "any_error_enable"]["low"]
    clears = enable | 1 << enables["frame_done"]["low"] if register == "interrupt" else 0xFFFFFFFF
    await bench.write("interrupt", enable)

    async def begin():
        await bench.quiet()
        await bench.write(register, clears)
        await ClockCycles(dut.aclk, 10)
        assert int(dut.irq.value) == 0
        bench.send(a_frame(bench) if field == "frame_done" else [*a_frame(bench)[:5], *a_frame(bench)])

    left = []
    for offset in range(-3, 4):
        await begin()
        to_event = await bench.clocks_until_irq(1)
        await bench.quiet()
        clearing = cocotb.start_soon(bench.write(register, clears))
        to_clear = await bench.clocks_until_irq(0)
        await clearing.join()
        await begin()
        await ClockCycles(dut.aclk, to_event - to_clear + offset)
        await bench.write(register, clears)
        await bench.quiet()
        left.append(await bench.field(register, field))
    assert left == [1, 1, 1, 1, 0, 0, 0], left


EVENTS = [("interrupt", "frame_done"), ("status", "early_start")]
add_tests(globals(), "stays", stays_if_it_happens_while_it_is_cleared, EVENTS)


@cocotb.test()
async def counters_and_clocks(dut):
    """The same number of clocks a frame as the co-simulation of the core alone measures."""
    bench = await Bench(dut, "counters").start()
    core_clocks = int(bench.parameters["clocks_of_one_frame"])
    for count in (1, 2, 3):
        await bench.play(script.send(a_frame(bench)))
        assert await bench.read("frames") == count
        assert await bench.read("frame_clocks") == core_clocks
    await bench.play(script.send(a_frame(bench)[:5] + a_frame(bench)))
    assert (await bench.read("frames"), await bench.read("broken_frames")) == (4, 1)
    await bench.play(script.send(a_frame(bench) + a_frame(bench)))
    assert await bench.read("frames") == 6
    assert await bench.read("frame_clocks") == core_clocks
    bench.rates(40, 40)
    await bench.play(script.send(a_frame(bench)))
    assert await bench.read("frame_clocks") > core_clocks
    bench.judge()


@cocotb.test()
async def enable(dut):
    """Off: the frame in progress is finished, the next one waits. On again: it comes, exact."""
    bench = await Bench(dut, "enable").start()
    bench.send(a_frame(bench) + a_frame(bench))
    await ClockCycles(dut.aclk, bench.geometry.groups // 2)
    await bench.write("control", 0)
    assert await bench.read("control") == 0
    await ClockCycles(dut.aclk, 3 * bench.geometry.groups)
    assert len(bench.watch.segments[-1][1]) == bench.geometry.results
    assert await bench.read("frames") == 1
    assert not bench.source.idle()
    await bench.write("control", 1)
    await bench.quiet()
    assert bench.judge().exact_frames == 2
    assert await bench.read("status") == 0


@cocotb.test()
async def errors_are_sticky_and_cleared_one_by_one(dut):
    bench = await Bench(dut, "sticky").start()
    beats = a_frame(bench)
    broken = [(beats[0][0], beats[0][1] | LAST)]  # early end of line
    wrong_start = beats[:3]
    late = beats[: bench.geometry.columns - 1] + [(0, 0), (0, LAST)]
    await bench.play(script.send([(1, LAST)] + broken + wrong_start + late + a_frame(bench)))
    bench.judge()
    fields = bench.map["status"]["fields"]
    names = sorted(expect(bench.watch.segments[-1][0], bench.geometry).errors)
    assert names == ["early_line_end", "early_start", "late_line_end", "outside_frame"]
    all_bits = sum(1 << fields[name]["low"] for name in names)
    assert await bench.read("status") == all_bits
    await bench.write("control", 1)
    await bench.axil.write(bench.map["status"]["offset"], b"\xff")  # not the byte of the errors
    await bench.axil.write(bench.map["status"]["offset"] + 2, b"\xff\xff")
    await bench.write("status", 0xFFFFFFFF & ~all_bits)
    assert await bench.read("status") == all_bits
    for name in names:  # with the byte of the errors alone
        await bench.axil.write(bench.map["status"]["offset"] + 1, (1 << fields[name]["low"] - 8).to_bytes(1, "little"))
        all_bits &= ~(1 << fields[name]["low"])
        assert await bench.read("status") == all_bits
    await bench.play(script.send([(1, LAST)]))
    assert await bench.read("status") == 1 << fields["outside_frame"]["low"]


@cocotb.test()
async def reset_forgets_a_break(dut):
    """Behind a broken frame beats are dropped without an error. Behind a reset they are outside of a frame again."""
    bench = await Bench(dut, "reset behind a break").start()
    await bench.play(script.send([(1, START | LAST), (1, LAST)]))
    assert await bench.field("status", "outside_frame") == 0
    await bench.reset(1)
    await bench.play(script.send([(1, LAST)]))
    assert await bench.field("status", "outside_frame") == 1


@cocotb.test()
async def byte_strobes(dut):
    bench = await Bench(dut, "strobes").start()
    await bench.axil.write(bench.map["control"]["offset"] + 1, b"\x00\x00\x00")
    assert await bench.read("control") == 1
    await bench.axil.write(bench.map["control"]["offset"], b"\x00")
    assert await bench.read("control") == 0
    await bench.write("control", 1)
    await bench.play(script.send(a_frame(bench)))
    place, fields = bench.map["interrupt"]["offset"], bench.map["interrupt"]["fields"]
    frame_done, enables = 1 << fields["frame_done"]["low"], 1 << fields["frame_done_enable"]["low"]
    enables |= 1 << fields["any_error_enable"]["low"]
    assert enables < 1 << 8 <= frame_done < 1 << 16, "both in one byte"
    await bench.axil.write(place, b"\xff")
    await bench.axil.write(place + 2, b"\xff\xff")
    assert await bench.read("interrupt") == frame_done | enables
    await bench.axil.write(place + 1, b"\xff")
    assert await bench.read("interrupt") == enables


def other_half(bench, half):
    """The channel that waits when only the addresses or only the data of writes come."""
    return {"addresses": bench.axil.write_if.w_channel, "data": bench.axil.write_if.aw_channel}[half]


async def one_half_first(dut, half):
    """The addresses of some writes before their data, or the data before the addresses: each address gets its own data,
    and the writes happen in their order."""
    bench = await Bench(dut, half).start()
    late = other_half(bench, half)
    for enables, last in ((3, 1), (0, 0)):
        late.pause = True
        wanted = ("interrupt", enables), ("control", 1 - last), ("control", last)
        writes = [cocotb.start_soon(bench.write(name, value)) for name, value in wanted]
        await ClockCycles(dut.aclk, 20)
        late.pause = False
        for write in writes:
            await with_timeout(write.join(), 100 * PERIOD_NS, "ns")
        assert (await bench.read("interrupt"), await bench.read("control")) == (enables, last)
    assert not bench.watch.breaches, bench.watch.breaches


add_tests(globals(), "first", one_half_first, [("addresses",), ("data",)])


async def without_lost_clocks(dut, kind, clocks):
    """Accesses that wait for one another follow without a lost clock."""
    bench = await Bench(dut, f"{kind} each {clocks} clocks").start()
    one = {"reads": lambda: bench.read("id"), "writes": lambda: bench.write("control", 1)}[kind]
    count, began = 40, bench.watch.clock
    accesses = [cocotb.start_soon(one()) for _ in range(count)]
    for access in accesses:
        await access.join()
    assert clocks * count <= bench.watch.clock - began <= clocks * count + 8, bench.watch.clock - began
    assert not bench.watch.breaches, bench.watch.breaches


add_tests(globals(), "without_lost_clocks", without_lost_clocks, [("reads", 3), ("writes", 2)])


@cocotb.test()
async def busy(dut):
    bench = await Bench(dut, "busy").start()
    assert await bench.field("status", "busy") == 0
    beats = a_frame(bench)
    bench.send(beats[: bench.geometry.columns])
    await bench.quiet()
    assert await bench.field("status", "busy") == 1, "a frame has begun"
    bench.send(beats[bench.geometry.columns :])
    await bench.sent()
    assert await bench.field("status", "busy") == 1
    await bench.quiet()
    assert await bench.field("status", "busy") == 0
    bench.sink.pause = True
    bench.send(a_frame(bench))
    await ClockCycles(dut.aclk, 3 * bench.geometry.groups)
    assert await bench.field("status", "busy") == 1, "disparities wait"
    bench.sink.pause = False
    await bench.quiet()
    assert await bench.read("status") == 0
    bench.judge()


@cocotb.test()
async def traffic_during_frames(dut):
    """Reads and writes without pause while frames run: neither side disturbs the other."""
    bench = await Bench(dut, "traffic").start()
    bench.rates(20, 20)
    for percent, channel in zip(
        (30, 60, 40, 50, 70),
        (
            bench.axil.write_if.aw_channel,
            bench.axil.write_if.w_channel,
            bench.axil.write_if.b_channel,
            bench.axil.read_if.ar_channel,
            bench.axil.read_if.r_channel,
        ),
    ):
        generator = bench.random.__class__(percent)
        channel.set_pause_generator(iter(lambda g=generator, p=percent: g.random() * 100 < p, None))
    running = cocotb.start_soon(bench.play(script.frames(bench.random, bench.pool, bench.geometry, 6)))
    accesses = 0
    while not running.done():
        assert await bench.read("id") == registers.ID
        await bench.write("control", 1)
        await bench.write("status", 0xFFFFFFFF)
        assert await bench.field("size", "width_px") == bench.parameters["width_px"]
        accesses += 4
    assert accesses > 50
    assert bench.judge().exact_frames == 6
    assert await bench.read("frames") == 6


async def soft_reset_at(bench, clocks):
    """Sends two frames and asks for a soft reset some clocks later; returns when it is done."""
    bench.send(a_frame(bench) + a_frame(bench))
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
        bench.send(a_frame(bench))
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
async def soft_reset_keeps_enable(dut):
    bench = await Bench(dut, "soft reset, enable").start()
    await bench.write("control", 2)
    await ClockCycles(dut.aclk, 4)
    assert await bench.read("control") == 0
    bench.send(a_frame(bench))
    await ClockCycles(dut.aclk, bench.geometry.groups)
    assert not bench.watch.segments[-1][1]
    await bench.write("control", 1)
    await bench.quiet()
    assert bench.judge().exact_frames == 1


async def reset_in_the_middle_of_an_access(dut, half):
    """A reset takes away the half of a write that has come: it is not joined with the next write's other half."""
    bench = await Bench(dut, "reset of registers").start()
    late = other_half(bench, half)
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
