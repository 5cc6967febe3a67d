# SPDX-License-Identifier: Apache-2.0
"""Proves narrower ranges for registers than the tool declares.

Each register starts with the range of its initial value; ranges grow until every register's next value fits its range.
What is left is an inductive invariant: no register can ever leave its range. A register that keeps growing (a counter,
whose bound comes from a comparison that ranges do not see) keeps its declared range.
"""

import heapq

from .expressions import Node, rebuild, walk
from .netlist import Netlist, Register

GROWTHS_ALLOWED = 16


def _leaf(register: Register, low: int, high: int) -> Node:
    ones = (1 << high.bit_length()) - 1 if low >= 0 else None
    return Node("register", (), register.name, low, high, ones)


def narrow_registers(netlist: Netlist) -> None:
    declared = {id(r.value): r for r in netlist.registers}
    current = {key: _leaf(r, r.initial, r.initial) for key, r in declared.items()}
    users: dict[int, list[Register]] = {}  # register -> registers whose next value reads it
    for r in netlist.registers:
        for node in walk([r.next]):
            if id(node) in declared:
                users.setdefault(id(node), []).append(r)
    growths = dict.fromkeys(current, 0)
    # In data-flow order, so that a range is final before the next block looks at it.
    place = {id(r.value): number for number, r in enumerate(netlist.registers)}
    waiting = list(range(len(netlist.registers)))
    while waiting:
        register = netlist.registers[heapq.heappop(waiting)]
        key = id(register.value)
        have, widest = current[key], register.value
        reached = rebuild(register.next, current, {})
        low, high = min(reached.low, have.low), max(reached.high, have.high)
        if (low, high) == (have.low, have.high):
            continue
        growths[key] += 1
        if growths[key] > GROWTHS_ALLOWED:
            low, high = widest.low, widest.high
        current[key] = _leaf(register, max(low, widest.low), min(high, widest.high))
        for user in users.get(key, []):
            if place[id(user.value)] not in waiting:
                heapq.heappush(waiting, place[id(user.value)])
    for key, register in declared.items():
        register.value = current[key]
    netlist.substitute(current)
