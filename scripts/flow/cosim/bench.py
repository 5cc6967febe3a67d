# SPDX-License-Identifier: Apache-2.0
"""The benches for a kind of design: hls_tb/cosim/ has them for any ports, and here is what stands for these.

A line of a stimulus has first the flags, bit 0 valid, bit 1 start of frame, bit 2 reset, then the other inputs of one
bit; behind them a field for each wider input. The word of an output line is made of the outputs that the kind names,
its flags of the others: first those of one bit, then the wider ones."""

from pathlib import Path

from ..base import rtl
from ..base.rtl import Kind, Port
from ..base.tools import ROOT

FOLDER = ROOT / "hls_tb" / "cosim"
VHDL, CPP, CPP_SHARED = FOLDER / "tb_stereo_core.vhd", FOLDER / "verilator_bench.cpp", FOLDER / "bench_stimulus.hpp"
ORIGINAL = FOLDER / "bambu_original.vhd"
SETTING_BITS = 16
_FIRST_FLAGS = ("valid", "start_of_frame", "reset")


class Ports:
    """Of a kind of design with so many lanes."""

    def __init__(self, kind: Kind, pixels: int, disparity_bits: int) -> None:
        self.kind, self.pixels, self.disparity_bits = kind, pixels, disparity_bits
        inputs = [port for port in kind.ports if port.direction == "in"]
        self.flags = [*_FIRST_FLAGS, *(p.name for p in inputs if p.is_flag and p.name not in _FIRST_FLAGS)]
        self.flag_digits = -(-len(self.flags) // 4)
        self.fields = [port for port in inputs if not port.is_flag]
        self.word = [port for name in kind.word for port in kind.ports if port.name == name]
        others = [p for p in kind.ports if p.direction == "out" and p not in self.word and p.name != kind.valid]
        self.shown_flags = sorted(others, key=lambda port: not port.is_flag)

    def bits(self, port: Port) -> int:
        return rtl.port_bits(port, self.pixels, self.disparity_bits)

    def _field_bits(self, port: Port) -> int:
        """As wide as the port in whole digits, but a setting, which may have any width, has a whole word."""
        return -(-self.bits(port) // 4) * 4 if port.bits is None else SETTING_BITS

    def line_pattern(self) -> str:
        """Of a line of a stimulus; its group 1 are the flags."""
        return " ".join([f"([0-9a-f]{{{self.flag_digits}}})", *(f"[0-9a-f]{{{n}}}" for n in self._digits())])

    def line(self) -> str:
        """What such a line is, for a sentence."""
        names = ["F", *(port.name.removesuffix("_pixel").upper() for port in self.fields)]
        return f"'{' '.join(names)}' with {' or '.join(map(str, sorted(set(self._digits()))))} digits"

    def _digits(self) -> list[int]:
        return [self._field_bits(port) // 4 for port in self.fields]

    def vhdl(self, config: str) -> str:
        """The text of the VHDL bench."""
        stands_for = {
            "ENTITY": self.kind.entity(config),
            "PORT_SIGNALS": "\n".join(self._signal(port) for port in self.kind.ports),
            "PORT_MAP": ",\n      ".join(f"{port.name} => {port.name}" for port in self.kind.ports),
            "FIELD_VARIABLES": "\n".join(
                f"    variable {port.name}_field : std_logic_vector({self._field_bits(port) - 1} downto 0);"
                for port in self.fields
            ),
            "FLAG_BITS": str(4 * self.flag_digits),
            "READ_FIELDS": "\n".join(map(self._read, self.fields)),
            "SET_FLAGS": "\n".join(f"      {name} <= flags({bit});" for bit, name in enumerate(self.flags)),
            "VALID": self.kind.valid,
            "WORD": " & ".join(port.name for port in self.word),
            "SHOWN_FLAGS": " & ".join(port.name for port in reversed(self.shown_flags)),
        }
        return _filled(VHDL.read_text(), stands_for)

    def _read(self, port: Port) -> str:
        field = f"{port.name}_field"
        return f"      hread(stimulus_line, {field});\n      {port.name} <= {field}({self.bits(port) - 1} downto 0);"

    def _signal(self, port: Port) -> str:
        kind = rtl.port_type(port, self.pixels, self.disparity_bits)
        zero = "" if port.direction == "out" else " := '0'" if port.is_flag else " := (others => '0')"
        return f"  signal {port.name} : {kind}{zero};"

    def cpp(self) -> dict[str, str]:
        """{name: header} of those that a C++ bench includes."""
        return {CPP_SHARED.name: CPP_SHARED.read_text(), "bench_ports.hpp": self._ports()}

    def _ports(self) -> str:
        sets = [f"   model.{name} = fields[0] >> {bit} & 1;" for bit, name in enumerate(self.flags)]
        sets += [f"   drive(model.{port.name}, fields[{at}]);" for at, port in enumerate(self.fields, 1)]
        return "\n".join(
            [
                "// Made by scripts/flow/cosim/bench.py.",
                '#include "Vdesign.h"',
                "",
                f"constexpr int kFields = {1 + len(self.fields)};",
                "/// Ports are as wide as the pixels of one clock.",
                "template <class Port>",
                "void drive(Port& port, unsigned long long value) {",
                "   port = static_cast<Port>(value);",
                "}",
                "inline void drive_inputs(Vdesign& model, const unsigned long long (&fields)[kFields]) {",
                *sets,
                "}",
                f"inline bool is_valid(const Vdesign& model) {{ return model.{self.kind.valid}; }}",
                "inline unsigned long long word(const Vdesign& model) {",
                f"   return {self._joined(list(reversed(self.word)))};",
                "}",
                "inline unsigned long long shown_flags(const Vdesign& model) {",
                f"   return {self._joined(self.shown_flags)};",
                "}",
                "",
            ]
        )

    def _joined(self, ports: list[Port]) -> str:
        """As one number, the first port in its lowest bits."""
        parts, low = [], 0
        for port in ports:
            parts.append(f"static_cast<unsigned long long>(model.{port.name}) << {low}")
            low += self.bits(port)
        return " | ".join(parts)


def _filled(template: str, stands_for: dict[str, str]) -> str:
    text = template
    for name, value in stands_for.items():
        text = text.replace(f"@{name}@", value)
    return text


def makers() -> list[Path]:
    """What decides how a bench looks."""
    return [Path(__file__), Path(rtl.__file__)]
