# SPDX-License-Identifier: Apache-2.0
"""Carry chains of a mapped ECP5 netlist, built again with less around them.

Of the four inputs of a half (ecp5_half.py) yosys uses three for an addition or subtraction. It leaves everything else
to look-up tables and to nextpnr, which spends a whole CCU2C for each carry that comes from or goes to the fabric. Here

- look-up tables in front of a chain move into it where p and g can still be said (the complement of a number that is
  added, `x or y` that is compared);
- halves that nothing reads go, and the lowest ones where the carry above them is known;
- where only the last sum is read, as in a comparison, the two lowest bits share one half;
- a carry that comes in starts in a half of its own where there is one to spare;
- a carry that nobody reads is not connected.

The function stays the same: each step is checked on the truth tables.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import Any

from .ecp5_cells import inputs, remove_unread_luts
from .ecp5_half import (
    PINS,
    Bit,
    Cell,
    Half,
    constant,
    first_carry,
    identity,
    look_up,
    opposite,
    tabulate,
    with_input,
    with_opposite_carry,
)


@dataclass
class Chain:
    cells: list[str]
    start: Bit
    halves: list[Half]
    end: Bit | None  # the net of a carry that leaves it


class CarryPacker:
    """Of one flattened module."""

    def __init__(self, module: dict[str, Any]) -> None:
        self.module = module
        self.cells: dict[str, Cell] = module["cells"]
        self.ports, self.names = module["ports"], module["netnames"]
        self.readers: dict[Bit, int] = defaultdict(int)
        self.luts: dict[Bit, str] = {}  # net -> look-up table that drives it
        self.next_net = 1 + max(bit for net in self.names.values() for bit in net["bits"] if isinstance(bit, int))
        for port in self.ports.values():
            for bit in port["bits"]:
                self.readers[bit] += 1
        for name, cell in self.cells.items():
            if cell["type"] == "LUT4":
                self.luts[cell["connections"]["Z"][0]] = name
            for bit in inputs(cell):
                self.readers[bit] += 1
        self.aliases: dict[Bit, Bit] = {}  # net -> net that has the same value

    def run(self) -> None:
        chains = self._chains()
        for chain in chains:
            self._trim(chain)
        self._absorb(chains)
        for chain in chains:
            self._start_within(chain)
            self._join_lowest(chain)
            self._make_even(chain)
            self._write(chain)
        self._rename()
        remove_unread_luts(self.module)

    # --- reading ------------------------------------------------------------------------------------------------------

    def _chains(self) -> list[Chain]:
        carries = {name: cell for name, cell in self.cells.items() if cell["type"] == "CCU2C"}
        drivers = {bit: name for name, cell in carries.items() for bit in cell["connections"].get("COUT", [])}
        followers: dict[str, str] = {}
        for name, cell in carries.items():
            before = drivers.get(cell["connections"]["CIN"][0])
            # A carry that is also read elsewhere ends its chain: nextpnr leads it out either way.
            if before is not None and self.readers[cell["connections"]["CIN"][0]] == 1:
                followers[before] = name
        chains = []
        for name in carries.keys() - set(followers.values()):
            names = [name]
            while names[-1] in followers:
                names.append(followers[names[-1]])
            chains.append(self._chain(names))
        return sorted(chains, key=lambda chain: chain.cells[0])

    def _chain(self, names: list[str]) -> Chain:
        halves = []
        for name in names:
            for half in "01":
                cell = self.cells[name]
                through = look_up(cell, f"INIT{half}", tuple(pin + half for pin in PINS))
                low = dict(cell, parameters={"low": cell["parameters"][f"INIT{half}"][-4:]})
                carry = look_up(low, "low", (f"A{half}", f"B{half}"))
                halves.append(Half(through, carry, self._read_net(cell, f"S{half}")))
        first, last = self.cells[names[0]], self.cells[names[-1]]
        return Chain(names, first["connections"]["CIN"][0], halves, self._read_net(last, "COUT"))

    def _read_net(self, cell: Cell, port: str) -> Bit | None:
        bits = cell["connections"].get(port)
        return bits[0] if bits and self.readers[bits[0]] else None

    # --- changes ------------------------------------------------------------------------------------------------------

    def _absorb(self, chains: list[Chain]) -> None:
        """Moves look-up tables into the halves that read them, where all their readers can take them in."""
        users: dict[Bit, list[tuple[Chain, int]]] = defaultdict(list)
        for chain in chains:
            for place, half in enumerate(chain.halves):
                for net in half.nets:
                    users[net].append((chain, place))
        changed = True
        while changed:  # what does not fit may do so when its neighbour has moved
            changed = False
            for net in [net for net in users if net in self.luts]:
                if users[net] and self._pins_that_read(net) == self.readers[net]:
                    changed |= self._moved(net, users)

    def _moved(self, net: Bit, users: dict[Bit, list[tuple[Chain, int]]]) -> bool:
        """Moves the look-up table of a net into all halves that read it, if it fits into each."""
        inner = look_up(self.cells[self.luts[net]], "INIT", tuple(PINS))
        halves = []
        for chain, place in users[net]:
            half = chain.halves[place]
            carry = None if half.carry is None else with_input(half.carry, net, inner)
            halves.append(Half(with_input(half.through, net, inner), carry, half.out))
            if halves[-1].fit() is None:
                return False
        for (chain, place), half in zip(users[net], halves):
            chain.halves[place] = half
            for source in inner.nets:
                if (chain, place) not in users[source]:
                    users[source].append((chain, place))
        users[net] = []
        return True

    def _pins_that_read(self, net: Bit) -> int:
        """Pins of chain halves, but for carries, that a net goes to."""
        return sum(
            bits == [net]
            for name in self.carry_readers.get(net, ())
            for port, bits in self.cells[name]["connections"].items()
            if port[0] in PINS
        )

    @property
    def carry_readers(self) -> dict[Bit, set[str]]:
        if not hasattr(self, "_carry_readers"):
            found: dict[Bit, set[str]] = defaultdict(set)
            for name, cell in self.cells.items():
                if cell["type"] == "CCU2C":
                    for bit in inputs(cell):
                        found[bit].add(name)
            self._carry_readers = found
        return self._carry_readers

    @staticmethod
    def _trim(chain: Chain) -> None:
        """Highest halves that nothing reads; lowest ones of which only a known carry is read."""
        halves = chain.halves
        if chain.end is None:
            while halves and halves[-1].out is None:
                halves.pop()
            if halves:
                halves[-1] = Half(halves[-1].through, None, halves[-1].out)
        while len(halves) > 1 and halves[0].out is None and isinstance(chain.start, str):
            carry = first_carry(halves[0], chain.start)
            if len(carry.nets) == 0:
                chain.start = str(carry.ones)
            elif carry == identity(carry.nets[0]):
                chain.start = carry.nets[0]
            else:
                return
            halves.pop(0)

    def _start_within(self, chain: Chain) -> None:
        """Where the lowest sum is a net that is there already, as in an increment by a sign, its half is free to start
        the carry."""
        if len(chain.halves) < 2 or chain.halves[0].out is None or isinstance(chain.start, str):
            return
        half, start = chain.halves[0], chain.start
        nets = tuple(dict.fromkeys((*half.nets, start)))
        total = tabulate(nets, lambda values: half.through.at(values) ^ values[start])
        first = Half(constant(0), first_carry(half, start), None)
        if len(total.nets) == 1 and total == identity(total.nets[0]) and first.fit() is not None:
            self.aliases[chain.halves[0].out] = total.nets[0]
            chain.halves[0] = first
            chain.start = "x"

    @staticmethod
    def _join_lowest(chain: Chain) -> None:
        """The two lowest bits in one half where only the last sum is read. Where that takes the opposite carry, all
        halves get it."""
        halves = chain.halves
        if len(halves) < 3 or chain.start not in ("0", "1") or chain.end is not None:
            return
        if any(half.out is not None for half in halves[:-1]):
            return
        for inverted in (False, True):
            if inverted:
                halves = [with_opposite_carry(half) for half in halves]
            start = int(chain.start == "1") ^ inverted
            low, high = halves[:2]
            nets = tuple(dict.fromkeys(low.nets + high.nets))
            if start == 1 or len(nets) > 4:
                continue
            first = first_carry(low, str(start))
            assert high.carry is not None  # only the last half has none
            carry = tabulate(nets, lambda v, h=high, f=first: f.at(v) if h.through.at(v) else h.carry.at(v))
            joined = Half(opposite(carry), constant(1), None)
            if all(half.fit() is not None for half in [joined, *halves[2:]]):
                chain.halves, chain.start = [joined, *halves[2:]], "0"
                return

    @staticmethod
    def _make_even(chain: Chain) -> None:
        """nextpnr leads each carry in and out by a CCU2C of its own; a half that would be empty does it for nothing."""
        halves = chain.halves
        if chain.end is not None:
            halves.append(Half(constant(0), None, chain.end))
            chain.end = None
        if len(halves) % 2 and chain.start != "x":
            halves.insert(0, Half(constant(0), identity(chain.start), None))
            chain.start = "x"
        if len(halves) % 2:
            halves.append(Half(constant(0), None, None))

    # --- writing ------------------------------------------------------------------------------------------------------

    def _write(self, chain: Chain) -> None:
        old = [self.cells.pop(name) for name in chain.cells]
        carry, halves = chain.start, chain.halves
        for number, pair in enumerate(zip(halves[::2], halves[1::2])):
            name = chain.cells[number] if number < len(chain.cells) else f"{chain.cells[0]}_more_{number}"
            model = old[min(number, len(old) - 1)]
            last = number == len(halves) // 2 - 1
            connections: dict[str, list[Bit]] = {"CIN": [carry]}
            parameters = {"INJECT1_0": "NO", "INJECT1_1": "NO"}
            for side, half in zip("01", pair):
                fitted = half.fit()
                assert fitted is not None
                pins, init = fitted
                connections |= {pin + side: [net] for pin, net in zip(PINS, pins)}
                connections[f"S{side}"] = ["x" if half.out is None else half.out]
                parameters[f"INIT{side}"] = f"{init:016b}"
            carry = self._new_net() if not last else chain.end if chain.end is not None else "x"
            connections["COUT"] = [carry]  # nextpnr takes x for no net
            directions = {port: "output" if port[0] == "S" or port == "COUT" else "input" for port in connections}
            self.cells[name] = dict(model, parameters=parameters, port_directions=directions, connections=connections)

    def _new_net(self) -> Bit:
        self.next_net += 1
        return self.next_net - 1

    def _rename(self) -> None:
        def final(bit: Bit) -> Bit:
            while bit in self.aliases:
                bit = self.aliases[bit]
            return bit

        for holder in (*self.ports.values(), *self.names.values()):
            holder["bits"] = [final(bit) for bit in holder["bits"]]
        for cell in self.cells.values():
            for port, bits in cell["connections"].items():
                if cell["port_directions"][port] != "output":
                    cell["connections"][port] = [final(bit) for bit in bits]
