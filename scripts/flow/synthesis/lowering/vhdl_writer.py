# SPDX-License-Identifier: Apache-2.0
"""Writes a netlist as one architecture, valid as VHDL-93 and VHDL-2008: ports, registers, memory cells and one clocked
process."""

from __future__ import annotations

from collections import Counter
from collections.abc import ItemsView, Iterable

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import Node, walk
from .netlist import Memory, Netlist, Register
from .reset import control_registers, memory_read_register, split_hold
from .vhdl_frame import HELPERS, Entity
from .vhdl_text import Names, Writer, is_wide, type_of, without_outer_parentheses

LINE = 120
__all__ = ["Entity", "VhdlWriter"]
_VARIABLE_KINDS = {
    "lt": "is_less",
    "ge": "is_not_less",
    "eq": "is_equal",
    "ne": "differs",
    "add": "sum",
    "sub": "difference",
    "mul": "product",
    "mux": "choice",
    "and": "all",
    "or": "any",
    "not": "inverse",
    "abs": "magnitude",
    "folded": "folded_value",
    "positive": "positive_value",
}


class VhdlWriter:
    def __init__(self, netlist: Netlist, header: str, entity: Entity) -> None:
        self.netlist, self.header, self.entity = netlist, header, entity
        self.output_bits = {port.name: entity.bits(port) for port in entity.kind.ports}
        self.names: Names = {id(r.value): (r.name, is_wide(r.value)) for r in netlist.registers}
        self.reads = {id(m): memory_read_register(netlist, m) for m in netlist.memories}
        for register, _ in self.reads.values():
            self.names[id(register.value)] = (register.name, True)
        self.in_memory = {id(register) for register, _ in self.reads.values()}
        for name, node in netlist.inputs.items():
            self.names[id(node)] = (f"in_{name}", is_wide(node))
        self.variables: dict[str, str] = {}  # name -> type
        self.text = Writer(self.names)
        self.uses = Counter(id(a) for n in walk(netlist.roots()) for a in n.args)
        self.uses.update(id(root) for root in netlist.roots())

    def write(self) -> str:
        process = self._process()  # first: it finds the variables
        parts = [
            self.header,
            "library ieee;",
            "use ieee.std_logic_1164.all;",
            "use ieee.numeric_std.all;",
            "",
            self.entity.text(),
            f"architecture rtl of {self.entity.name} is",
            HELPERS,
            self._declarations(),
            "begin",
            self._ports(),
            self._memories(),
            process,
            "end architecture;",
        ]
        return "\n".join(parts) + "\n"

    # --- declarations -------------------------------------------------------------------------------------------------

    def _declarations(self) -> str:
        lines = [f"  signal in_{name} : {type_of(node.low, node.high)};" for name, node in self.netlist.inputs.items()]
        for block, registers in self._blocks():
            lines.append(f"  -- {block}")
            by_type: dict[str, list[str]] = {}
            for r in registers:
                kind = type_of(r.value.low, r.value.high)
                if id(r) in self.in_memory:
                    kind = f"unsigned({r.value.width - 1} downto 0)"
                by_type.setdefault(kind, []).append(r.name)
            for kind, names in by_type.items():
                lines += _wrapped("  signal ", names, f" : {kind};")
        for memory in self.netlist.memories:
            lines += [f"  signal {port} : {kind};" for port, kind, _ in self._memory_inputs(memory)]
        return "\n".join(lines) + "\n"

    def _blocks(self) -> ItemsView[str, list[Register]]:
        """Registers by C++ block, in data-flow order: the order they come in."""
        blocks: dict[str, list[Register]] = {}
        for register in self.netlist.registers:
            blocks.setdefault(register.name.split("_")[0], []).append(register)
        return blocks.items()

    def _ports(self) -> str:
        lines = []
        for name, node in self.netlist.inputs.items():
            # Through bits: what a bubble brings may be neither 0 nor 1, which to_integer would warn of in every clock.
            bits = f"to_integer(unsigned(to_stdlogicvector(to_bitvector({name}))))"
            word = f"unsigned({name})" if is_wide(node) else bits
            value = f"{name} = '1'" if node.is_bit else word
            lines.append(f"  in_{name} <= {value};")
        for name, node in self.netlist.outputs.items():
            if name in self.netlist.words:
                lines.append(f"  {name} <= std_logic_vector({self.text.word(node, self.output_bits[name])});")
            else:
                lines.append(f"  {name} <= as_bit({without_outer_parentheses(self.text.condition(node))});")
        return "\n".join(lines) + "\n"

    def _memories(self) -> str:
        lines: list[str] = []
        for memory in self.netlist.memories:
            name, bits = memory.name, _address_bits(memory)
            lines += [f"  {port} <= {value};" for port, _, value in self._memory_inputs(memory)]
            lines += [
                f"  {name} : entity work.line_memory",
                f"    generic map (depth => {memory.depth}, width => {memory.width}, address_bits => {bits})",
                "    port map (",
                f"      clock => clock, read_enable => {name}_read_enable,",
                f"      read_address => {name}_read_address, read_data => {self.reads[id(memory)][0].name},",
                f"      write_address => {name}_write_address, write_data => {name}_write_data);",
                "",
            ]
        return "\n".join(lines)

    def _memory_inputs(self, memory: Memory) -> list[tuple[str, str, str]]:
        """(signal, type, value) of what goes into a memory: VHDL-93 takes no expression in a port map."""
        name, bits = memory.name, _address_bits(memory)
        enable = self.reads[id(memory)][1]
        enabled = "true" if enable is None else without_outer_parentheses(self.text.condition(enable))
        inputs = [(f"{name}_read_enable", "boolean", enabled)]
        for port, node in (("read_address", memory.read_address), ("write_address", memory.write_address)):
            if id(node) not in self.names:
                raise FlowError(f"an address of memory {name} does not come from a register", EXIT_TOOL_FAILED)
            value = f"to_unsigned({self.text.number(node)}, {bits})"
            inputs.append((f"{name}_{port}", f"unsigned({bits - 1} downto 0)", value))
        word = self.text.word(memory.write_data, memory.width)
        return [*inputs, (f"{name}_write_data", f"unsigned({memory.width - 1} downto 0)", word)]

    # --- the clocked process ------------------------------------------------------------------------------------------

    def _process(self) -> str:
        control = control_registers(self.netlist)
        body = []
        for block, registers in self._blocks():
            body.append(f"      -- {block}")
            for condition, members in self._by_enable(registers).items():
                body += self._group(condition, members)
        resets = [
            f"        {r.name} <= {_constant(r)};"
            for r in self.netlist.registers
            if id(r.value) in control and id(r) not in self.in_memory
        ]
        variables: dict[str, list[str]] = {}
        for name, kind in self.variables.items():
            variables.setdefault(kind, []).append(name)
        declared = [
            line for kind, names in variables.items() for line in _wrapped("    variable ", names, f" : {kind};")
        ]
        return "\n".join(
            [
                "  process (clock)",
                *declared,
                "  begin",
                "    if rising_edge(clock) then",
                *body,
                "      if reset = '1' then",
                *resets,
                "      end if;",
                "    end if;",
                "  end process;",
            ]
        )

    def _by_enable(self, registers: Iterable[Register]) -> dict[Node | None, list[Register]]:
        groups: dict[Node | None, list[Register]] = {}
        for register in registers:
            if id(register) not in self.in_memory:
                groups.setdefault(split_hold(register)[0], []).append(register)
        return groups

    def _group(self, condition: Node | None, members: list[Register]) -> list[str]:
        lines: list[str] = []
        indent = "      "
        assigned = []
        for register in members:
            value = split_hold(register)[1]
            assigned.append((register, value))
            lines += self._variables(value, register.name)
        if condition is not None:
            lines += self._variables(condition, members[0].name, is_assigned=False)
            lines.append(f"{indent}if {without_outer_parentheses(self.text.condition(condition))} then")
            indent += "  "
        lines += self._assignments("<=", [(r.name, r.value, value) for r, value in assigned], indent)
        if condition is not None:
            lines.append("      end if;")
        return lines

    def _assignments(self, sign: str, targets: list[tuple[str, Node, Node]], indent: str) -> list[str]:
        """Of (name, what it is, its next value). Choices by the same condition share one `if`."""
        lines: list[str] = []
        choices: dict[str, list[tuple[str, Node, Node]]] = {}  # by the text of their condition
        for name, target, value in targets:
            if value.op == "mux" and id(value) not in self.names:
                test = without_outer_parentheses(self.text.condition(value.args[0]))
                choices.setdefault(test, []).append((name, target, value))
            else:
                lines += _folded(f"{indent}{name} {sign} {self._plain_text(value, target)};")
        for test, chosen in choices.items():
            lines += _folded(f"{indent}if {test} then")
            for branch in (1, 2):
                lines += [] if branch == 1 else [f"{indent}else"]
                for name, target, value in chosen:
                    lines += _folded(f"{indent}  {name} {sign} {self._plain_text(value.args[branch], target)};")
            lines.append(f"{indent}end if;")
        return lines

    def _variables(self, root: Node, user: str, is_assigned: bool = True) -> list[str]:
        """Assignments of the variables that `root` needs and that are not yet there. is_assigned: where `root` is a
        choice it becomes an `if` of its own."""
        lines: list[str] = []
        for node in walk([root]):
            if id(node) in self.names or not node.args:
                continue
            if self._needs_variable(node, is_assigned and node is root):
                lines += self._assign_variable(node, user)
        return lines

    def _needs_variable(self, node: Node, is_root: bool) -> bool:
        if node.op == "mux":
            return self.uses[id(node)] > 1 or not is_root
        simple = node.op in ("wrap", "shr", "shl") and id(node.args[0]) in self.names
        return self.uses[id(node)] > 1 and not simple and node.op != "not"

    def _assign_variable(self, node: Node, user: str) -> list[str]:
        base = f"{user}_{_VARIABLE_KINDS.get(node.op, 'value')}"
        name, number = base, 2
        while name in self.variables:
            name, number = f"{base}_{number}", number + 1
        lines = self._assignments(":=", [(name, node, node)], "      ")
        self.variables[name] = type_of(node.low, node.high)
        self.names[id(node)] = (name, is_wide(node))
        return lines

    def _plain_text(self, node: Node, target: Node) -> str:
        """As a value of the target's type."""
        if target.is_bit:
            return without_outer_parentheses(self.text.condition(node))
        if is_wide(target):
            return self.text.word(node, target.width)
        return without_outer_parentheses(self.text.number(node))


def _address_bits(memory: Memory) -> int:
    return max(1, (memory.depth - 1).bit_length())


def _constant(register: Register) -> str:
    """The value that a reset gives."""
    if register.value.is_bit:
        return "true" if register.initial else "false"
    if is_wide(register.value):
        return f"to_unsigned({register.initial}, {register.value.width})"
    return str(register.initial)


def _wrapped(start: str, names: list[str], end: str) -> list[str]:
    """Declarations of many names, as few lines as fit."""
    lines: list[str] = []
    line: list[str] = []
    for name in names:
        if line and len(start) + len(", ".join(line + [name])) + len(end) > LINE:
            lines.append(start + ", ".join(line) + end)
            line = []
        line.append(name)
    return lines + [start + ", ".join(line) + end]


def _folded(line: str) -> list[str]:
    """A long statement on several lines, broken at blanks."""
    lines = []
    indent = " " * (len(line) - len(line.lstrip(" ")) + 2)
    while len(line) > LINE and " " in line[len(indent) + 8 : LINE]:
        at = line.rindex(" ", 0, LINE)
        lines.append(line[:at])
        line = indent + line[at + 1 :]
    return lines + [line]
