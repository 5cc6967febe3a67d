# SPDX-License-Identifier: Apache-2.0
"""The bench of the cocotb tests: clock, reset, the models of cocotbext-axi on each port, a watch on every handshake."""

import json
import logging
import os
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, FallingEdge
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

from flow.shell import contract, pool, registers
from flow.shell.broken import beats_of

PERIOD_NS = 10
QUIET_CLOCKS = 300  # nothing moved for so long: all that could come has come
HANG_CLOCKS = 20000


def load_pool():
    """(frames, parameters, seed) that flow.shell.cocotb_runs has prepared."""
    with open(os.environ["STEREO_AXI_POOL"], encoding="ascii") as file:
        content = json.load(file)
    frames = [pool.Frame(*(tuple(entry[key]) for key in ("groups", "results", "needs"))) for entry in content["frames"]]
    return frames, content["parameters"], content["seed"]


def add_tests(module, prefix, function, cases):
    """Makes a cocotb test of a module for each tuple of arguments, named after them."""
    for case in cases:

        async def test(dut, arguments=case):
            await function(dut, *arguments)

        test.__name__ = test.__qualname__ = "_".join([prefix, *(str(value).replace(" ", "_") for value in case)])
        test.__doc__ = function.__doc__
        test.__module__ = module["__name__"]
        module[test.__name__] = cocotb.test()(test)


class Watch:
    """Sees every clock of the streams and of the registers' answers, and breaches of the protocol: what is offered
    stays as it is until it is taken, no answer comes before its question was taken, and nothing is offered or taken in
    reset."""

    ANSWERS = {"s_axil_b": ("bresp",), "s_axil_r": ("rdata", "rresp")}
    QUESTIONS = {"s_axil_b": ("s_axil_aw", "s_axil_w"), "s_axil_r": ("s_axil_ar",)}

    LOW_IN_RESET = (
        *("m_axis_tvalid", "s_axis_tready", "s_axil_bvalid", "s_axil_rvalid"),
        *("s_axil_awready", "s_axil_wready", "s_axil_arready"),
    )

    def __init__(self, dut):
        self.dut = dut
        self.clock = 0
        self.moved = 0  # the last clock in which a beat moved
        self.taken = []  # the clocks of the beats of s_axis
        self.segments = []  # since each reset: ([beat of s_axis, ...], [(data, flags, clock) of m_axis, ...])
        self.breaches = []
        self.held = {}
        self.asked = dict.fromkeys(("s_axil_aw", "s_axil_w", "s_axil_ar"), 0)  # questions taken and not yet answered

    def _moves(self, channel):
        """Whether a channel offers something, and whether that is taken."""
        valid, ready = (bool(getattr(self.dut, f"{channel}{end}").value) for end in ("valid", "ready"))
        return valid, valid and ready

    def _pending(self, name, payload, valid, ready):
        """Checks one channel that the shell drives."""
        before = self.held.pop(name, None)
        if before is not None and (not valid or payload != before):
            self.breaches.append(f"{name} changed before it was taken, clock {self.clock}")
        if valid and not ready:
            self.held[name] = payload

    def _streams(self):
        dut = self.dut
        if dut.s_axis_tvalid.value and dut.s_axis_tready.value:
            flags = int(dut.s_axis_tuser.value) | int(dut.s_axis_tlast.value) << 1
            self.segments[-1][0].append((int(dut.s_axis_tdata.value), flags))
            self.taken.append(self.clock)
            self.moved = self.clock
        valid, ready = int(dut.m_axis_tvalid.value), int(dut.m_axis_tready.value)
        beat = None
        if valid:
            beat = (int(dut.m_axis_tdata.value), int(dut.m_axis_tuser.value) | int(dut.m_axis_tlast.value) << 2)
        self._pending("m_axis", beat, valid, ready)
        if valid and ready:
            self.segments[-1][1].append((*beat, self.clock))
            self.moved = self.clock

    def _answers(self):
        for channel, signals in self.ANSWERS.items():
            valid, taken = self._moves(channel)
            payload = tuple(int(getattr(self.dut, f"s_axil_{name}").value) for name in signals) if valid else None
            self._pending(channel, payload, valid, taken)
            if valid and not all(self.asked[question] for question in self.QUESTIONS[channel]):
                self.breaches.append(f"{channel} answers a question that was not taken, clock {self.clock}")
            for question in self.QUESTIONS[channel]:
                self.asked[question] += self._moves(question)[1] - taken

    async def run(self):
        in_reset = 0
        while True:
            await FallingEdge(self.dut.aclk)  # everything is settled; what stands here moves at the next rising edge
            self.clock += 1
            if self.dut.aresetn.value:
                if in_reset:
                    self.segments.append(([], []))
                in_reset = 0
                self._streams()
                self._answers()
                continue
            in_reset += 1
            self.held.clear()
            self.asked = dict.fromkeys(self.asked, 0)
            offered = [name for name in self.LOW_IN_RESET if getattr(self.dut, name).value]
            if in_reset > 1 and offered:
                self.breaches.append(f"{' and '.join(offered)} in reset, clock {self.clock}")


class Bench:
    def __init__(self, dut, name):
        if os.environ.get("STEREO_AXI_STOP_AT_FAILURE") and cocotb.regression_manager.failures:
            raise RuntimeError("not run: a test before it failed")
        self.dut = dut
        self.pool, self.parameters, seed = load_pool()
        self.geometry = pool.Geometry.of(self.parameters)
        self.random = random.Random(f"{seed} {name}")
        dut._log.info("seed %s", seed)
        for logger in ("cocotb.stereo_ip.s_axis", "cocotb.stereo_ip.m_axis", "cocotb.stereo_ip.s_axil"):
            logging.getLogger(logger).setLevel(logging.WARNING)
        reset = {"reset": dut.aresetn, "reset_active_level": False}
        self.source = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis"), dut.aclk, **reset, byte_lanes=1)
        self.sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), dut.aclk, **reset, byte_lanes=1)
        self.axil = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), dut.aclk, **reset)
        self.watch = Watch(dut)
        self.map = registers.by_name()

    async def start(self):
        self.dut.aresetn.value = 0
        cocotb.start_soon(Clock(self.dut.aclk, PERIOD_NS, units="ns").start())
        cocotb.start_soon(self.watch.run())
        await ClockCycles(self.dut.aclk, 3)
        self.dut.aresetn.value = 1
        await ClockCycles(self.dut.aclk, 2)
        return self

    def a_frame(self):
        """The beats of a random frame of the pool."""
        return beats_of(self.random.choice(self.pool), self.geometry)

    def other_half(self, half):
        """The channel that waits when only the addresses or only the data of writes come."""
        return {"addresses": self.axil.write_if.w_channel, "data": self.axil.write_if.aw_channel}[half]

    def rates(self, source_percent, sink_percent):
        """Chance in percent that a side pauses in a clock."""

        def pauses(percent):
            generator = random.Random(self.random.random())
            while True:
                yield generator.random() * 100 < percent

        for end, percent in ((self.source, source_percent), (self.sink, sink_percent)):
            if percent:
                end.set_pause_generator(pauses(percent))
            else:
                end.clear_pause_generator()
                end.pause = False

    def send(self, beats):
        """Queues beats. cocotbext-axi ends each of its frames with tlast: beats behind the last tlast get one."""
        line = []
        for beat in beats:
            line.append(beat)
            if beat[1] & contract.LAST:
                self._send_line(line)
                line = []
        if line:
            self._send_line(line)

    def _send_line(self, line):
        self.source.send_nowait(
            AxiStreamFrame([data for data, _ in line], tuser=[flags & contract.START for _, flags in line])
        )

    async def sent(self):
        """Until the source has nothing more to send."""
        start = self.watch.clock
        while not self.source.idle():
            await ClockCycles(self.dut.aclk, 20)
            assert self.watch.clock - max(self.watch.moved, start) < HANG_CLOCKS, "a beat was not taken for ever"

    async def quiet(self):
        """Until nothing moves any more."""
        await self.sent()
        start = self.watch.clock
        while self.watch.clock - max(self.watch.moved, start) < QUIET_CLOCKS:
            await ClockCycles(self.dut.aclk, 20)
            assert self.watch.clock - start < 10 * HANG_CLOCKS, "beats come out without end"

    async def clocks_until_irq(self, level):
        """Counted from now."""
        start = self.watch.clock
        while int(self.dut.irq.value) != level:
            await FallingEdge(self.dut.aclk)
            assert self.watch.clock - start < HANG_CLOCKS, f"irq does not become {level}"
        return self.watch.clock - start

    async def reset(self, clocks):
        """Drops what the source still has to send, as its own reset would."""
        self.dut.aresetn.value = 0
        self.source.clear()
        await ClockCycles(self.dut.aclk, clocks)
        self.dut.aresetn.value = 1

    async def play(self, steps):
        """The steps of flow.shell.script, then quiet."""
        beats = []
        for kind, *values in [*steps, ("drain",)]:
            if kind == "beat":
                beats.append(tuple(values))
                continue
            self.send(beats)
            beats = []
            if kind == "rates":
                await self.sent()
                self.rates(*values)
            elif kind == "idle":
                await self.sent()
                await ClockCycles(self.dut.aclk, values[0])
            elif kind == "reset":
                await self.reset(values[0])
        await self.quiet()

    async def read(self, name):
        return int.from_bytes((await self.axil.read(self.map[name]["offset"], 4)).data, "little")

    async def write(self, name, value):
        await self.axil.write(self.map[name]["offset"], value.to_bytes(4, "little"))

    async def field(self, register, field):
        place = self.map[register]["fields"][field]
        return await self.read(register) >> place["low"] & (1 << place["high"] - place["low"] + 1) - 1

    def judge(self):
        """Every segment between resets against the contract; returns the Judge."""
        verdict = contract.Judge(self.geometry, self.pool)
        verdict.problems += self.watch.breaches
        for number, (beats, results) in enumerate(self.watch.segments):
            verdict.judge(beats, [result[:2] for result in results], complete=number == len(self.watch.segments) - 1)
        assert not verdict.problems, f"{len(verdict.problems)} problems: " + "; ".join(verdict.problems[:5])
        assert verdict.compared, "nothing was compared"
        return verdict
