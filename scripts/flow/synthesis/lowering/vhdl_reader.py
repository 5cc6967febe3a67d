# SPDX-License-Identifier: Apache-2.0
"""Reads the structural VHDL that Bambu writes: the datapath's instances and the controller's states.

Only the shapes that the tool writes are understood; anything else is an error that quotes it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn, Union

from ...base.errors import EXIT_TOOL_FAILED, FlowError

_NAME = r"\\[^\\]+\\|\w+"


Part = tuple[int, int, str]  # (high, low, actual) of a formal that is connected in parts
Actual = Union[str, list[Part]]


@dataclass(frozen=True)
class Signal:
    width: int
    signed: bool = False


@dataclass(frozen=True)
class Instance:
    name: str
    kind: str
    generics: dict[str, str]
    ports: dict[str, Actual]  # by formal


@dataclass(frozen=True)
class State:
    outputs: dict[str, int]  # control signal -> 0 or 1, with the start signal at 1
    next: str


@dataclass(frozen=True)
class Design:
    signals: dict[str, Signal]  # ports of the datapath included
    instances: list[Instance]
    states: dict[str, State]
    reset_state: str


def fail(what: str, text: str = "") -> NoReturn:
    quoted = " ".join(text.split())[:160]
    raise FlowError(f"cannot read the tool's VHDL: {what}{': ' + quoted if quoted else ''}", EXIT_TOOL_FAILED)


def plain(name: str) -> str:
    """An identifier without the backslashes of VHDL's extended form."""
    return name.strip("\\")


def read_design(path: Path) -> Design:
    try:
        text = re.sub(r"--[^\n]*", "", path.read_text())
    except OSError as error:
        fail(f"{path}: {error.strerror}")
    datapath = _section(text, r"entity datapath_\w+ is", r"end datapath_\w+_arch;")
    controller = _section(text, r"entity controller_\w+ is", r"end controller_\w+_arch;")
    ports, rest = re.split(r"\bend datapath_\w+;", datapath, maxsplit=1)
    declarations, body = re.split(r"\nbegin\b", _without_components(rest), maxsplit=1)
    signals = {plain(name): kind for name, kind in _declared(ports + declarations)}
    states, reset_state = _read_states(controller)
    return Design(signals, _read_instances(body), states, reset_state)


def _section(text: str, start: str, end: str) -> str:
    match = re.search(f"{start}.*?{end}", text, re.DOTALL)
    return match.group() if match else fail(f"no part from '{start}' to '{end}'")


def _without_components(text: str) -> str:
    return re.sub(r"\bcomponent\b.*?\bend component;", "", text, flags=re.DOTALL)


def _declared(text: str) -> Iterator[tuple[str, Signal]]:
    pattern = rf"({_NAME}) : (?:in |out )?(std_logic_vector|std_logic|unsigned|signed) *(?:\((\d+) downto 0\))?"
    for name, kind, high in re.findall(pattern, text):
        yield name, Signal(int(high) + 1 if high else 1, kind == "signed")


# --- instances --------------------------------------------------------------------------------------------------------


def _read_instances(body: str) -> list[Instance]:
    """`NAME : KIND [generic map (...)] port map (...);` one after the other, and nothing else but joined signals."""
    head = re.compile(rf"\s*({_NAME}) : ({_NAME})\s+(generic map|port map)\s*\(")
    instances, at = [], 0
    while match := head.match(body, at):
        generics = {}
        inside, at = _parenthesised(body, match.end() - 1)
        if match.group(3) == "generic map":
            generics = {name: actual for name, _, actual in _associations(inside)}
            follow = re.compile(r"\s*port map\s*\(").match(body, at) or fail("no port map", body[at : at + 200])
            inside, at = _parenthesised(body, follow.end() - 1)
        instances.append(Instance(plain(match.group(1)), plain(match.group(2)), generics, _ports(inside)))
        at = body.index(";", at) + 1
    left = re.sub(r"\bend \S+;", "", body[at:]).strip()
    if left:
        fail("a statement that is no instance", left)
    return instances


def _parenthesised(text: str, at: int) -> tuple[str, int]:
    """The text between the parenthesis at `at` and its partner, and the place after that."""
    depth = 0
    for place in re.compile(r"[()]").finditer(text, at):
        depth += 1 if place.group() == "(" else -1
        if depth == 0:
            return text[at + 1 : place.start()], place.end()
    fail("unbalanced parentheses", text[at : at + 200])


def _associations(text: str) -> Iterator[tuple[str, str | None, str]]:
    """(formal, index text or None, actual) of each association in a map."""
    depth, start, parts = 0, 0, []
    for place in re.compile(r"[(),]").finditer(text):
        if place.group() == "," and depth == 0:
            parts.append(text[start : place.start()])
            start = place.end()
        else:
            depth += {"(": 1, ")": -1, ",": 0}[place.group()]
    parts.append(text[start:])
    for part in parts:
        match = re.fullmatch(rf"\s*({_NAME})\s*(?:\(([^)]*)\))?\s*=>\s*(.*?)\s*", part, re.DOTALL)
        if not match:
            fail("an association", part)
        yield plain(match.group(1)), match.group(2), match.group(3)


def _ports(text: str) -> dict[str, Actual]:
    ports: dict[str, Actual] = {}
    for formal, index, actual in _associations(text):
        if index is None:
            ports[formal] = actual
            continue
        bounds = [int(bound) for bound in index.split(" downto ")]
        parts = ports.setdefault(formal, [])
        if isinstance(parts, str):
            fail(f"port {formal} is connected as a whole and in parts", text)
        parts.append((bounds[0], bounds[-1], actual))
    return ports


# --- states -----------------------------------------------------------------------------------------------------------


def _read_states(text: str) -> tuple[dict[str, State], str]:
    reset = re.search(r"reset *= *'0'\) then\s*present_state <= (\w+);", text) or fail(
        "no reset state in the controller"
    )
    defaults, case = re.split(
        r"\bcase present_state is", _section(text, r"comb_logic0: process", r"end process"), maxsplit=1
    )
    start = {plain(name): int(value) for name, value in re.findall(rf"({_NAME}) <= '([01])';", defaults)}
    states = {}
    for name, body in re.findall(r"when (S_\w+) =>(.*?)(?=\bwhen )", case, re.DOTALL):
        states[name] = _read_state(name, body, start)
    return states, reset.group(1)


def _read_state(name: str, body: str, defaults: dict[str, int]) -> State:
    """What a state does when the start signal is 1; don't-care values ('X') count as 0."""
    conditional = re.search(r"if *\(start_port /= '1'\) then(.*?)else(.*?)end if;", body, re.DOTALL)
    if conditional:
        body = body.replace(conditional.group(), conditional.group(2))
    if re.search(r"\bif\b", body):
        fail(f"state {name} has a condition that is not the start signal", body)
    following = re.findall(r"next_state <= (\w+);", body)
    if len(following) != 1:
        fail(f"state {name} has {len(following)} next states", body)
    outputs = dict(defaults)
    for signal, value in re.findall(rf"({_NAME}) <= '([01X])';", body):
        outputs[plain(signal)] = int(value == "1")
    return State(outputs, following[0])
