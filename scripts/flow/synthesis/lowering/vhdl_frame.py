# SPDX-License-Identifier: Apache-2.0
"""What every VHDL file of a core has: its entity, and the functions that expressions call."""

from typing import NamedTuple

from ...base import rtl


class Entity(NamedTuple):
    """`generics`: {name: value}, in VHDL's order; others stop elaboration. They give the ports their widths."""

    name: str
    generics: dict[str, int]
    settings: tuple[rtl.Setting, ...] = ()

    def text(self) -> str:
        generics = ";\n".join(
            f"    {name} : {'positive' if value > 0 else 'natural'} := {value}" for name, value in self.generics.items()
        )
        checks = "\n".join(
            f'  assert {name} = {value} report "{self.name}: {name} is " & integer\'image({name}) & '
            f'" but this core has {value}" severity failure;'
            for name, value in self.generics.items()
        )
        return ENTITY.format(name=self.name, generics=generics, ports=self._ports(), checks=checks)

    def _ports(self) -> str:
        ports = ["    clock : in std_logic;", "    reset : in std_logic;  -- synchronous, active high"]
        all_ports = rtl.ports_with(self.settings)
        for port in all_ports:
            kind = rtl.port_type(port, self.generics["pixels_per_clock"], self.generics["disparity_bits"])
            end = "" if port is all_ports[-1] else ";"
            ports.append(
                f"    {port.name} : {port.direction} {kind}{end}" + (f"  -- {port.meaning}" if port.meaning else "")
            )
        return "\n".join(ports)


ENTITY = """\
entity {name} is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
{generics}
  );
  port (
{ports}
  );
begin
{checks}
end entity;
"""
HELPERS = """\
  -- the complement of a negative number: its magnitude less 1
  function folded(value : integer) return natural is
  begin
    if value < 0 then
      return -1 - value;
    end if;
    return value;
  end function;

  function positive_part(value : integer) return natural is
  begin
    if value < 0 then
      return 0;
    end if;
    return value;
  end function;

  function as_number(value : boolean) return natural is
  begin
    if value then
      return 1;
    end if;
    return 0;
  end function;

  -- as a fold and a carry: a negation and a choice would take twice the logic
  function magnitude(value : integer) return natural is
  begin
    return folded(value) + as_number(value < 0);
  end function;

  function as_bit(value : boolean) return std_logic is
  begin
    if value then
      return '1';
    end if;
    return '0';
  end function;
"""
