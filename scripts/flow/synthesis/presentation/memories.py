# SPDX-License-Identifier: Apache-2.0
"""Memory cells, each with the signals that go into it, as blocks with signals of their own; neighbours that differ in
their numbers only as one `for ... generate`, and back."""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile

from . import loops
from .words import Words, folded, joined, split

_SINGLE = re.compile(
    r"""  (?P<label>\w+)_read_enable <= (?P<read_enable>.*);
  (?P=label)_read_address <= (?P<read_address>.*);
  (?P=label)_write_address <= (?P<write_address>.*);
  (?P=label)_write_data <= (?P<write_data>.*);
  (?P=label) : entity work\.(?P<unit>\w+)
    generic map \(depth => (?P<depth>\d+), width => (?P<width>\d+), address_bits => (?P<address_bits>\d+)\)
    port map \(
      clock => clock, read_enable => (?P=label)_read_enable,
      read_address => (?P=label)_read_address, read_data => (?P<read_data>\w+),
      write_address => (?P=label)_write_address, write_data => (?P=label)_write_data\);
"""
)
_INPUTS = ("read_enable", "read_address", "write_address", "write_data")
_GENERICS = ("depth", "width", "address_bits")
# A kit gives the unit another name. The register comes last.
_FIELDS = (*_INPUTS, *_GENERICS, "unit", "read_data")
LOCAL = {*_INPUTS, "cell"}  # names inside of the blocks
_SUFFIX = "_memory"
_CLOCK = "clock"
# In the order of the entity.
_PORTS = ("read_enable", "read_address", "read_data", "write_address", "write_data")
_ORDER = f"  -- Memories: ({', '.join(_GENERICS)}), ({', '.join((_CLOCK, *_PORTS))})"
_TEXT = re.compile(
    r"  (\w+) : (?:block|for (\w+) in (\d+) (to|downto) (\d+) generate)\n(.*?)  end (?:block|generate);\n", re.DOTALL
)
_ASSIGNED = re.compile(r"^    (\w+) <= (.*?);$", re.MULTILINE | re.DOTALL)
_UNIT = re.compile(r"entity work\.(\w+)")
_NAMED = re.compile(r"(\w+) => ((?:[^,()]|\([^()]*\))+)")
_ACTUAL = re.compile(r"(?:[^,()\s]|\([^()]*\))+")


@dataclass(frozen=True)
class Memory:
    fields: Mapping[str, Words]

    @property
    def words(self) -> Words:
        return tuple(word for name in _FIELDS for word in (*self.fields[name], ";"))

    @property
    def generics(self) -> list[Words]:
        return [self.fields[name] for name in _GENERICS]

    @property
    def label(self) -> str:
        """Of a cell whose register is a signal of its own."""
        return "".join(self.fields["read_data"]) + _SUFFIX

    def types(self) -> dict[str, str]:
        """Of the signals that go into it."""
        address = f"unsigned({int(self.fields['address_bits'][0]) - 1} downto 0)"
        data = f"unsigned({int(self.fields['width'][0]) - 1} downto 0)"
        return dict(zip(_INPUTS, ("boolean", address, address, data)))

    def text(self) -> str:
        said = {name: joined(words) for name, words in self.fields.items()}
        label = self.label
        return (
            "".join(f"  {label}_{name} <= {said[name]};\n" for name in _INPUTS)
            + f"  {label} : entity work.{said['unit']}\n"
            f"    generic map (depth => {said['depth']}, width => {said['width']}, "
            f"address_bits => {said['address_bits']})\n"
            "    port map (\n"
            f"      clock => clock, read_enable => {label}_read_enable,\n"
            f"      read_address => {label}_read_address, read_data => {said['read_data']},\n"
            f"      write_address => {label}_write_address, write_data => {label}_write_data);\n"
        )


def _of_words(words: Words) -> Memory:
    fields = {}
    for name in _FIELDS:
        end = words.index(";")
        fields[name], words = words[:end], words[end + 1 :]
    return Memory(fields)


def read(concurrent: Sequence[str], names: Iterable[str] = ()) -> tuple[list[str], list[Memory]]:
    """(lines of the ports, memories), as the lowering writes them; no memories where one has another form, or one of
    the core's `names` would be hidden in their blocks."""
    text = "\n".join(concurrent) + "\n"
    found = list(_SINGLE.finditer(text))
    memories = [Memory({name: tuple(split(match[name])) for name in _FIELDS}) for match in found]
    head = text[: found[0].start()] if found else text
    lines = head.splitlines()
    is_known = written(lines, memories) == list(concurrent) and LOCAL.isdisjoint(names)
    return (lines, memories) if is_known else (list(concurrent), [])


def written(ports: list[str], memories: Iterable[Memory]) -> list[str]:
    """As the lowering writes them."""
    return [*ports, *(line for memory in memories for line in (*memory.text().splitlines(), ""))]


# --- there ------------------------------------------------------------------------------------------------------------


def presented(memories: Sequence[Memory], variable: str, known: Container[str], taken: Iterable[str]) -> list[str]:
    """With references to `known` arrays in their fields. `taken`: names that are no label."""
    lines = [_ORDER, ""] if memories else []
    used = set(taken)
    at = 0
    while at < len(memories):
        size, steps = loops.longest([memory.words for memory in _alike(memories[at:])])
        name = memories[at].fields["read_data"][0]
        place = _place(memories[at].fields["read_data"])
        generated = _generated(memories[at], size, steps, variable) if size > 1 else None
        label = next(one for one in _labels(name if generated else place, place) if one not in used)
        used.add(label)
        if generated:
            header, memory = generated
            lines += _framed(f"{label} : {header}", "generate", memory, known)
        else:
            size = 1
            lines += _framed(f"{label} : block", "block", memories[at], known)
        at += size
    return lines


def _labels(*names: str) -> Iterable[str]:
    return [*(f"{name}{_SUFFIX}" for name in names), *(f"{names[-1]}{_SUFFIX}_{number}" for number in range(2, 1000))]


def _alike(memories: Sequence[Memory]) -> Iterable[Memory]:
    """Those from the first one on that have its size."""
    return takewhile(lambda one: one.generics == memories[0].generics, memories)


def _place(reference: Words) -> str:
    """`held_3` of `held(3)`"""
    return "_".join(word for word in reference if word not in ("(", ",", ")"))


def _generated(memory: Memory, size: int, steps: Sequence[int], variable: str) -> tuple[str, Memory] | None:
    """(range of a `generate`, the memory with its variable), where it goes through neighbouring registers"""
    numbers = loops.numbers_of(memory.words)
    before = len(numbers) - len(loops.numbers_of((*memory.fields["read_data"], ";")))
    moving = [(number, step) for number, step in list(zip(numbers, steps))[before:] if step]
    if len(moving) != 1 or abs(moving[0][1]) != 1:
        return None
    first, direction = moving[0]
    last = first + direction * (size - 1)
    values = [
        (number - step * direction * first, {variable: step * direction} if step else {})
        for number, step in zip(numbers, steps)
    ]
    word = "to" if direction > 0 else "downto"
    shown = _of_words(loops.with_numbers(memory.words, values))
    return f"for {variable} in {first} {word} {last} generate", shown


def _is_signal(words: Words, known: Container[str]) -> bool:
    """Or a constant: what a port takes in VHDL-93."""
    return len(words) == 1 or (words[0] in known and words.index(")") == len(words) - 1)


def _framed(start: str, end: str, memory: Memory, known: Container[str]) -> list[str]:
    said = {name: joined(words) for name, words in memory.fields.items()}
    own = [name for name in _INPUTS if not _is_signal(memory.fields[name], known)]
    types = memory.types()
    lines = [f"  {start}"]
    for kind in dict.fromkeys(types[name] for name in own):
        lines.append(f"    signal {', '.join(name for name in own if types[name] == kind)} : {kind};")
    lines.append("  begin")
    for name in own:
        lines += folded(f"    {name} <= {said[name]};")
    sources = {name: name if name in own else said[name] for name in (*_INPUTS, "read_data")}
    ports = ", ".join(sources[name] for name in _PORTS)
    generics = ", ".join(said[name] for name in _GENERICS)
    lines += [f"    cell : entity work.{said['unit']} generic map ({generics})"]
    return [*lines, *folded(f"      port map ({_CLOCK}, {ports});"), f"  end {end};", ""]


# --- and back ---------------------------------------------------------------------------------------------------------


def back(concurrent: Sequence[str]) -> tuple[list[str], list[Memory]]:
    """(lines of the ports, memories) of presented text; the memories still refer to arrays."""
    text = "\n".join(concurrent) + "\n"
    found = list(_TEXT.finditer(text))
    if not found:
        return list(concurrent), []
    memories = []
    for match in found:
        _, variable, first, _, last, body = match.groups()
        memory = _read(body)
        if variable is None:
            memories.append(memory)
            continue
        step = 1 if int(first) <= int(last) else -1
        for number in range(int(first), int(last) + step, step):
            memories.append(_of_words(loops.evaluated(memory.words, {variable: number})))
    return text[: found[0].start()].replace(f"{_ORDER}\n\n", "").splitlines(), memories


def _read(body: str) -> Memory:
    _, assignments = body.split("  begin\n", 1)
    assigned = [(name, " ".join(value.split())) for name, value in _ASSIGNED.findall(assignments)]
    values = dict(assigned)
    _, generics, ports = re.split(r"generic map|port map", " ".join(assignments.split()))
    sizes = _actuals(generics.strip()[1:-1], _GENERICS)
    actuals = _actuals(ports.strip()[1:-2], (_CLOCK, *_PORTS))
    # `Memory.text` writes the connections that every memory has: they must be these.
    if (
        len(values) != len(assigned)
        or len(sizes) != len(_GENERICS)
        or len(actuals) != len(_PORTS) + 1
        or actuals[0] != _CLOCK
        or any(name in values and actual != name for name, actual in zip(_PORTS, actuals[1:]))
    ):
        raise ValueError("a memory is connected in another way")
    said = dict(zip(_GENERICS, sizes)) | dict(zip(_PORTS, actuals[1:]))
    said |= values
    [said["unit"]] = _UNIT.findall(body)
    return Memory({name: tuple(split(said[name])) for name in _FIELDS})


def _actuals(text: str, names: Sequence[str]) -> list[str]:
    """Of a list in the order of these names, or with them, as cores had it before."""
    if "=>" not in text:
        return _ACTUAL.findall(text)
    said = dict(_NAMED.findall(text))
    return [said[name] for name in names] if said.keys() == set(names) else []


def in_words(memory: Memory, change: Callable[[Words], Words]) -> Memory:
    """With each of its values changed."""
    return Memory({name: change(words) for name, words in memory.fields.items()})
