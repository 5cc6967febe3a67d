# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb: registers, alone and while frames run."""

import cocotb
from cocotb.triggers import ClockCycles, with_timeout

from bench import PERIOD_NS, Bench, add_tests
from flow.shell import registers, script
from flow.shell.contract import LAST, expect


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

    await bench.play(script.send(bench.a_frame()))
    assert (await bench.read("interrupt"), await level()) == (fields["frame_done"], 0)
    await bench.write("interrupt", fields["frame_done_enable"])
    assert await level() == 1
    await bench.write("interrupt", fields["frame_done_enable"] | fields["frame_done"])
    assert (await bench.read("interrupt"), await level()) == (fields["frame_done_enable"], 0)
    await bench.play(script.send(bench.a_frame()[:5] + bench.a_frame()))
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
        bench.send(bench.a_frame() if field == "frame_done" else [*bench.a_frame()[:5], *bench.a_frame()])

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
        await bench.play(script.send(bench.a_frame()))
        assert await bench.read("frames") == count
        assert await bench.read("frame_clocks") == core_clocks
    await bench.play(script.send(bench.a_frame()[:5] + bench.a_frame()))
    assert (await bench.read("frames"), await bench.read("broken_frames")) == (4, 1)
    await bench.play(script.send(bench.a_frame() + bench.a_frame()))
    assert await bench.read("frames") == 6
    assert await bench.read("frame_clocks") == core_clocks
    bench.rates(40, 40)
    await bench.play(script.send(bench.a_frame()))
    assert await bench.read("frame_clocks") > core_clocks
    bench.judge()


@cocotb.test()
async def enable(dut):
    """Off: the frame in progress is finished, the next one waits. On again: it comes, exact."""
    bench = await Bench(dut, "enable").start()
    bench.send(bench.a_frame() + bench.a_frame())
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
    beats = bench.a_frame()
    broken = [(beats[0][0], beats[0][1] | LAST)]  # early end of line
    wrong_start = beats[:3]
    late = beats[: bench.geometry.columns - 1] + [(0, 0), (0, LAST)]
    await bench.play(script.send([(1, LAST)] + broken + wrong_start + late + bench.a_frame()))
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
async def byte_strobes(dut):
    bench = await Bench(dut, "strobes").start()
    await bench.axil.write(bench.map["control"]["offset"] + 1, b"\x00\x00\x00")
    assert await bench.read("control") == 1
    await bench.axil.write(bench.map["control"]["offset"], b"\x00")
    assert await bench.read("control") == 0
    await bench.write("control", 1)
    await bench.play(script.send(bench.a_frame()))
    place, fields = bench.map["interrupt"]["offset"], bench.map["interrupt"]["fields"]
    frame_done, enables = 1 << fields["frame_done"]["low"], 1 << fields["frame_done_enable"]["low"]
    enables |= 1 << fields["any_error_enable"]["low"]
    assert enables < 1 << 8 <= frame_done < 1 << 16, "both in one byte"
    await bench.axil.write(place, b"\xff")
    await bench.axil.write(place + 2, b"\xff\xff")
    assert await bench.read("interrupt") == frame_done | enables
    await bench.axil.write(place + 1, b"\xff")
    assert await bench.read("interrupt") == enables


async def one_half_first(dut, half):
    """The addresses of some writes before their data, or the data before the addresses: each address gets its own data,
    and the writes happen in their order."""
    bench = await Bench(dut, half).start()
    late = bench.other_half(half)
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
    beats = bench.a_frame()
    bench.send(beats[: bench.geometry.columns])
    await bench.quiet()
    assert await bench.field("status", "busy") == 1, "a frame has begun"
    bench.send(beats[bench.geometry.columns :])
    await bench.sent()
    assert await bench.field("status", "busy") == 1
    await bench.quiet()
    assert await bench.field("status", "busy") == 0
    bench.sink.pause = True
    bench.send(bench.a_frame())
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
