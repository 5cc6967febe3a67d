# SPDX-License-Identifier: Apache-2.0
"""Whether two cores are the same but for names, comments and the order of their statements.

Each signal and variable is described by its type and by what is assigned to it. In that description, the names of
others give way to their own descriptions, round after round, until no round tells more of them apart (colour
refinement). Ports keep their names, so every output hangs on what it hung on before. Arrays and loops count as the
signals and statements that they stand for.
"""

import hashlib
import re
from collections.abc import Callable, Iterable, Iterator
from operator import itemgetter

from ..base.errors import FlowError
from .presentation.present import expand

_TOKEN = re.compile(r"--[^\n]*|\s+|(:=|<=|>=|/=|=>|\*\*|'[01]'|\"[^\"]*\"|\w+|.)")
Words = list[str]
_CARRIED = ("read_enable", "read_address", "write_address")  # ports of a memory cell that take a value by a signal
_AS_BITS = re.compile(r"to_stdlogicvector\(to_bitvector\((\w+)\)\)")  # the same for every 0 and 1


def structure_digest(vhdl: str) -> str:
    """Of the text of one core, as the lowering writes it or as it is presented."""
    try:
        return Structure(expand(vhdl)).digest()
    except (ValueError, LookupError) as error:
        raise FlowError(f"unknown form of VHDL: {error}") from None


class Structure:
    def __init__(self, vhdl: str) -> None:
        self.kinds: dict[str, str] = {}  # of signals and variables
        self.definitions: dict[str, Words] = {}  # what is assigned to each signal, variable or output
        words = [match[1] for match in _TOKEN.finditer(_AS_BITS.sub(r"\1", vhdl)) if match[1]]
        entity, architecture = words.index("entity"), words.index("architecture")
        self.ports = _ports(words[entity:architecture])
        declarations = words.index("signal", architecture)
        body = words.index("begin", declarations)
        self.functions = words[words.index("is", architecture) + 1 : declarations]
        self._declarations(words[declarations:body])
        self._concurrent(words[body + 1 :])

    def digest(self) -> str:
        colours = {name: _hash([kind]) for name, kind in self.kinds.items()}
        said = {word: word for words in self.definitions.values() for word in words}  # names: their colours
        said |= {kind: kind for kind in self.kinds.values()} | {"": ""} | colours
        described = {name: self._described(name) for name in [*self.kinds, *self.definitions]}
        classes = 0
        while classes < len(set(colours.values())):
            classes = len(set(colours.values()))
            colours = {name: _hash(described[name](said)) for name in self.kinds}
            said |= colours
        outputs = {name: _hash(described[name](said)) for name in self.definitions if name not in self.kinds}
        ends = [f"{name} {colour}" for name, colour in sorted(outputs.items())]
        return _hash([*self.functions, *self.ports, *ends, *sorted(colours.values())])

    def _described(self, name: str) -> Callable[[dict[str, str]], Iterable[str]]:
        """What gives the words that describe a name, out of a table of words."""
        kind, words = self.kinds.get(name, ""), self.definitions.get(name, [])
        return itemgetter(kind, *words) if words else lambda said: [said[kind]]

    def _declarations(self, words: Words) -> None:
        for statement in _statements(words):
            if statement[0] in ("signal", "variable"):
                colon = statement.index(":")
                kind = " ".join(statement[colon + 1 :])
                self.kinds.update({name: kind for name in statement[1:colon] if name != ","})

    def _assign(self, name: str, words: Words) -> None:
        """Several branches may assign to one variable; they come in their order."""
        self.definitions.setdefault(name, []).extend([*words, ";"])

    def _concurrent(self, words: Words) -> None:
        while words[0] != "end":
            if words[0] == "process":
                end = _index(words, "end", "process")
                self._process(words[:end])
                words = words[end + 3 :]
                continue
            end = words.index(";")
            statement, words = words[:end], words[end + 1 :]
            if statement[1] == "<=":
                self._assign(statement[0], statement[1:])
            else:  # label : entity work.cell generic map (...) port map (... read_data => name, ...)
                made = statement[_index(statement, "read_data", "=>") + 2]
                self._assign(made, self._cell(statement[2:]))

    def _cell(self, words: Words) -> Words:
        """A memory cell with what goes into it in place of the signals that only carry it there, and without the bits
        of its addresses where they are what its depth needs."""
        bits = max(1, (int(words[_index(words, "depth", "=>") + 2]) - 1).bit_length())
        said: Words = []
        for part in _parts(words):
            if part == ["address_bits", "=>", str(bits)]:
                continue
            if part[1:2] == ["=>"] and part[0] in _CARRIED:
                value = self._carried(part[2], bits) if len(part) == 3 else part[2:]
                part = [*part[:2], *_plain(value)]
            said += [*part, ","]
        return said

    def _carried(self, name: str, address_bits: int) -> Words:
        """What is assigned to a signal that a port of a memory takes; the name where it is a register."""
        words = self.definitions.get(name, [])
        if words[:1] != ["<="]:
            return [name]
        value, kind = words[1:-1], self.kinds[name]
        if value[0] == "to_unsigned":
            if value[-3:] != [",", str(address_bits), ")"] or kind != f"unsigned ( {address_bits - 1} downto 0 )":
                return [name]
            value = value[2:-3]
        del self.definitions[name], self.kinds[name]
        return value

    def _process(self, words: Words) -> None:
        begin = words.index("begin")
        variables = words.index("variable") if "variable" in words[:begin] else begin
        self._declarations(words[variables:begin])
        open_ifs: list[Words] = []  # the words of their branches so far
        for statement in _sequence(words[begin + 1 :]):
            if statement[0] == "if":
                open_ifs.append(statement)
            elif statement[0] in ("elsif", "else"):
                open_ifs[-1] = open_ifs[-1] + statement
            elif statement[0] == "end":
                open_ifs.pop()
            else:
                path = [word for branches in open_ifs for word in branches]
                for branch, assignment in _branches(statement):
                    self._assign(assignment[0], [*path, *branch, *assignment[1:]])


def _branches(assignment: Words) -> list[tuple[Words, Words]]:
    """(branch, assignment): `x <= a when c else b` as the if statement that says the same."""
    if "when" not in assignment:
        return [([], assignment)]
    when, otherwise = assignment.index("when"), assignment.index("else")
    test = ["if", *assignment[when + 1 : otherwise], "then"]
    return [(test, assignment[:when]), ([*test, "else"], [*assignment[:2], *assignment[otherwise + 1 :]])]


def _parts(words: Words) -> Iterator[Words]:
    """The lists of a cell's generics and ports, between their commas."""
    part: Words = []
    depth = 0
    for word in words:
        depth += {"(": 1, ")": -1}.get(word, 0)
        if word == "," and depth == 1 or word == "(" and depth == 1 or word == ")" and depth == 0:
            yield part
            part = []
        else:
            part.append(word)


def _plain(words: Words) -> Words:
    """An expression without the parentheses around all of it."""
    depth = 0
    for at, word in enumerate(words):
        depth += {"(": 1, ")": -1}.get(word, 0)
        if depth == 0:
            return _plain(words[1:-1]) if at == len(words) - 1 and at else words
    return words


def _ports(entity: Words) -> Words:
    start = _index(entity, "port", "(")
    return entity[start : start + _index(entity[start:], ")", ";")]


def _index(words: Words, *wanted: str) -> int:
    """Of the first place where these words follow each other."""
    for at in range(len(words) - len(wanted) + 1):
        if words[at : at + len(wanted)] == list(wanted):
            return at
    raise FlowError(f"unknown form of VHDL: no '{' '.join(wanted)}'")


def _statements(words: Words) -> Iterator[Words]:
    while words:
        end = words.index(";")
        yield words[:end]
        words = words[end + 1 :]


def _sequence(words: Words) -> Iterator[Words]:
    """Assignments, `if c then`, `elsif c then`, `else`, `end if`, each by itself."""
    statement: Words = []
    for word in words:
        if word == ";":
            yield statement
            statement = []
        else:
            statement.append(word)
            # `else` inside an assignment is a conditional value.
            if word == "then" or (word == "else" and len(statement) == 1):
                yield statement
                statement = []


def _hash(words: Iterable[str]) -> str:
    return hashlib.sha256("\0".join(words).encode()).hexdigest()
