# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb: the way of a setting from its register to the core. What the core makes of it is
compared in Verilator."""

import cocotb
from cocotb.triggers import FallingEdge

from bench import Bench
from flow.base import rtl
from flow.shell import script
from flow.shell.broken import beats_of

READ_ONLY = 0xFFFF << 16  # the half of a setting's register that says the largest value: a write does not count there


@cocotb.test()
async def each_reaches_its_port(dut):
    """A setting that is written shows at the core's port of its name from the next frame on, not before, and no other
    port changes. The core is reset for a setting of its size and for no other. With the first frame behind a reset all
    show what they start with."""
    bench = await Bench(dut, "settings").start()
    settings = [setting for setting in rtl.settings_of(bench.parameters) if setting.least < setting.largest]
    assert settings
    resets = 0

    async def count_resets():
        nonlocal resets
        while True:
            await FallingEdge(dut.aclk)
            resets += int(dut.core.reset.value)

    def ports():
        return {setting.name: int(getattr(dut.core, setting.name).value) for setting in settings}

    async def send_frame():
        # Of the configuration's size: behind one of the size's settings it is broken, which does not matter.
        await bench.play(script.send(beats_of(bench.pool[0], bench.geometry)))

    cocotb.start_soon(count_resets())
    expected = {setting.name: setting.start for setting in settings}
    for setting in settings:
        wanted = setting.least if setting.start != setting.least else setting.largest
        await bench.write(setting.name, wanted | READ_ONLY)
        before = resets
        assert ports() == expected
        await send_frame()
        expected[setting.name] = wanted
        assert ports() == expected
        assert (resets > before) == setting.held, f"{setting.name}: {resets - before} clocks of reset"
    await bench.reset(1)
    await send_frame()
    assert ports() == {setting.name: setting.start for setting in settings}


@cocotb.test()
async def what_does_not_fit_is_refused(dut):
    """One below the least and one above the largest value: an error bit, and the register keeps what it had. Its upper
    half says the largest."""
    bench = await Bench(dut, "limits").start()
    for setting in rtl.settings_of(bench.parameters):
        for beyond in (setting.least - 1, setting.largest + 1):
            if beyond >= 0:
                await bench.write(setting.name, beyond | READ_ONLY)
                assert await bench.field("status", "setting_refused") == 1
                assert await bench.read(setting.name) == setting.start + (setting.largest << 16)
                await bench.write("status", 1 << bench.map["status"]["fields"]["setting_refused"]["low"])
                assert await bench.field("status", "setting_refused") == 0


@cocotb.test()
async def only_a_whole_value_counts(dut):
    """A write of one of the two bytes of a value, or of none, changes nothing and is no error."""
    bench = await Bench(dut, "strobes of settings").start()
    for setting in rtl.settings_of(bench.parameters):
        place, before = bench.map[setting.name]["offset"], await bench.read(setting.name)
        for wanted in (setting.least, setting.largest, 0xFFFF):
            low, high = wanted.to_bytes(2, "little")
            await bench.axil.write(place, bytes([low]))
            await bench.axil.write(place + 1, bytes([high, 0xFF, 0xFF]))
            await bench.axil.write(place + 2, b"\xff\xff")
            assert (await bench.read(setting.name), await bench.read("status")) == (before, 0), (
                f"part of {setting.name}"
            )
        await bench.axil.write(place, setting.least.to_bytes(2, "little"))
        assert await bench.read(setting.name) == setting.least + (setting.largest << 16)
