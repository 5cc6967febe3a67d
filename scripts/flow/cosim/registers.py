# SPDX-License-Identifier: Apache-2.0
"""The registers of the VHDL beside those of the C++ core, which have the same names: which one differs first.

What differs first lies nearest to the fault: all that differs later may follow from it. What is no fault does not
count:

- registers whose name is a guess, as they never changed in the trace that gave it (synthesis/lowering/naming);
- what needs no reset keeps what it held, where the C++ core begins anew: the first clocks, and behind a reset in
  mid-stream all until both agree;
- of these, counters of rings, which may stand anywhere: they never agree;
- what a memory gives before it was written, X in VHDL: it counts where nothing else differs.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass

from ..synthesis.lowering.naming import Trace
from . import waveform
from .vcd import Values
from .vectors import Seen


@dataclass(frozen=True)
class Divergence:
    """In one clock."""

    clock: int
    registers: list[tuple[str, int, Seen]]  # (name, value in C++, in VHDL), in the order of the data's way
    is_first: bool  # False: they differ in the first clock that was compared, and perhaps before

    def __str__(self) -> str:
        name, cpp, vhdl = self.registers[0]
        more = f"; {len(self.registers) - 1} more in that clock" if len(self.registers) > 1 else ""
        words = "first register that differs" if self.is_first else "in the first clock looked at, registers differ"
        return f"{words}: {name}, clock {self.clock}: {cpp} in C++, {vhdl} in VHDL{more}"


class Registers:
    """Of a dump and of a trace whose first clock is `first`. `sure`: the names that are no guess; `reset`: of the
    registers that the VHDL resets."""

    def __init__(
        self, values: Values, trace: Trace, first: int, sure: Collection[str], reset: Collection[str] = ()
    ) -> None:
        self._values, self._trace, self._reset = values, trace, reset
        self.clocks = range(first, first + len(trace["in_valid"]))
        core = {name[len(waveform.CORE) :] for name in values.names if name.startswith(waveform.CORE)}
        self._shared = [name for name in trace if name in core and not name.startswith(("in_", "out_"))]
        self.names = [name for name in self._shared if name in sure]

    def cpp(self, name: str, clock: int) -> int:
        return self._trace[name][clock - self.clocks.start]

    def vhdl(self, name: str, clock: int) -> Seen | None:
        """With the sign that the register has in C++."""
        seen, bits = self._values.at(waveform.CORE + name, waveform.start_ns(clock)), self._bits(name)
        is_negative = isinstance(seen, int) and bits == waveform.INTEGER_BITS and seen >> (bits - 1)
        return seen - (1 << bits) if is_negative and isinstance(seen, int) else seen

    def _bits(self, name: str) -> int:
        return self._values.bits(waveform.CORE + name)

    def differs(self, name: str, clock: int) -> bool:
        seen = self.vhdl(name, clock)
        return seen is not None and (seen == "X" or (seen - self.cpp(name, clock)) % (1 << self._bits(name)) != 0)

    def cpp_signals(self) -> dict[str, tuple[int, dict[int, int]]]:
        """For vcd.add: all registers that both have."""
        times = {clock: waveform.start_ns(clock) for clock in self.clocks}
        return {
            name: (self._bits(name), {time: self.cpp(name, clock) for clock, time in times.items()})
            for name in self._shared
        }

    def _first_difference(self, name: str, settled: int, resets: set[int], x_counts: bool) -> int | None:
        def is_left_out(clock: int) -> bool:
            return not x_counts and self.vhdl(name, clock) == "X"

        if name in self._reset:
            return next((clock for clock in self.clocks if self.differs(name, clock) and not is_left_out(clock)), None)
        found, agreed, agreed_ever = None, True, False
        for clock in self.clocks[max(settled - self.clocks.start, 0) :]:
            agreed = agreed and clock not in resets and not is_left_out(clock)
            if not self.differs(name, clock):
                agreed = agreed_ever = True
            elif agreed and found is None:
                found = clock
        return found if agreed_ever else None

    def divergence(self, settled: int, only_reset: bool = False) -> Divergence | None:
        """`settled`: the clock before which what is without reset may hold anything. `only_reset`: looks at nothing
        else. Behind a reset in mid-stream the rest may hold pixels of the frame before: it counts where nothing else
        differs."""
        times = {clock: waveform.start_ns(clock) for clock in self.clocks}
        resets = {clock + 1 for clock, time in times.items() if self._values.at(waveform.CORE + "reset", time) == 1}
        steps = [step for step, is_taken in ((True, resets or only_reset), (False, not only_reset)) if is_taken]
        tries = [(step, x_counts) for x_counts in (False, True) for step in steps]
        return next((found for one in tries if (found := self._earliest(settled, resets, *one))), None)

    def _earliest(self, settled: int, resets: set[int], only_reset: bool, x_counts: bool) -> Divergence | None:
        names = [name for name in self.names if name in self._reset or not only_reset]
        found = {name: self._first_difference(name, settled, resets, x_counts) for name in names}
        earliest = min((clock for clock in found.values() if clock is not None), default=None)
        if earliest is None:
            return None
        seen = [
            (name, self.cpp(name, earliest), self.vhdl(name, earliest)) for name in names if found[name] == earliest
        ]
        registers = [(name, cpp, vhdl) for name, cpp, vhdl in seen if vhdl is not None]
        return Divergence(earliest, registers, earliest > self.clocks.start or self.clocks.start == 0)


def reset_in(text: str) -> set[str]:
    """The registers that the VHDL of a core resets."""
    branch = re.search(r"^ *if reset = '1' then\n(.*?)\n *end if;", text, re.MULTILINE | re.DOTALL)
    return set(re.findall(r"^ *(\w+) <= ", branch[1], re.MULTILINE)) if branch else set()
