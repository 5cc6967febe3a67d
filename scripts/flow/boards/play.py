# SPDX-License-Identifier: Apache-2.0
"""board_top in a simulator, played over its serial line."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from ..base import places
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.files import write
from ..base.tools import ROOT, Word
from ..shell import board_vhdl
from ..simulation import simulators
from ..simulation.simulation import Simulation
from ..simulation.simulators import Design

WATCHDOG_SECONDS = 600
CLOCKS_PER_BIT = 4  # the least of uart_receiver; a board has more
NO_STOP_BIT = 256  # a byte of zeros without it
WRAPPER = "board_played"
CPP_BENCH = ROOT / "hls_tb" / "boards" / "board_bench.cpp"
SIMULATORS = ("ghdl", "verilator")
MOST_PIXELS_IN_GHDL = 5000  # of an image


def simulator_for(sizes: Mapping[str, int]) -> str:
    """Where the user names none."""
    return "ghdl" if sizes["width_px"] * sizes["height_px"] <= MOST_PIXELS_IN_GHDL else "verilator"


class Answer(NamedTuple):
    sent: list[int]  # bytes that came back; -1 where one had no stop bit
    leds: str  # in the end, the highest first


def design(config: str, simulator: str, files: Sequence[Path] | None = None) -> Design:
    """`files`: others than the project's own for the board around the core."""
    folder = places.build_folder() / "boards" / "text" / config
    folder.mkdir(parents=True, exist_ok=True)
    around = list(files or board_vhdl.BY_HAND)
    made_of = board_vhdl.files(config, folder)[: -len(board_vhdl.BY_HAND)] + around
    if simulator == "ghdl":
        return Design("tb_board_top", [*made_of, board_vhdl.BENCH])
    wrapper = folder / f"{WRAPPER}.vhd"
    write(wrapper, _wrapper())
    return Design(WRAPPER, [*made_of, wrapper], [CPP_BENCH])


def _wrapper() -> str:
    """board_top with the generics of the bench."""
    ports = {"clock": "in", "button": "in", "rx": "in", "tx": "out"}
    generics = {"clock_hz": 1_000_000 * CLOCKS_PER_BIT, "baud": 1_000_000, "quiet_ms": 1}
    lines = ["library ieee;", "use ieee.std_logic_1164.all;", "", f"entity {WRAPPER} is", "  port ("]
    lines += [*(f"    {name} : {way} std_logic;" for name, way in ports.items())]
    lines += ["    led : out std_logic_vector(7 downto 0));", "end entity;", "", f"architecture played of {WRAPPER} is"]
    lines += ["begin", "  board : entity work.board_top"]
    lines += [f"    generic map ({', '.join(f'{name} => {value}' for name, value in generics.items())})"]
    lines += [f"    port map ({', '.join(f'{name} => {name}' for name in (*ports, 'led'))});", "end architecture;", ""]
    return "\n".join(lines)


class Played:
    """The board with a configuration's core, built once and played any number of times."""

    def __init__(self, config: str, simulator: str = "ghdl", files: Sequence[Path] | None = None) -> None:
        root = places.build_folder() / "boards" / simulator / config
        self._simulation = Simulation(simulators.SIMULATORS[simulator], design(config, simulator, files), root)
        self._simulation.build()
        self._in_vhdl = simulator == "ghdl"

    def play(self, given: Iterable[int], self_test: bool = False, **generics: Word) -> Answer:
        """`given`: bytes, NO_STOP_BIT, or -n for a pause of n bits; `self_test`: wait for it first; `generics`: of the
        bench in VHDL."""
        with tempfile.TemporaryDirectory() as name:
            bytes_file, answer_file = Path(name) / "given.txt", Path(name) / "answer.txt"
            bytes_file.write_text("".join(f"{number}\n" for number in given))
            told: dict[str, Word] = {"given": bytes_file, "answer": answer_file}
            if self._in_vhdl:
                told |= {"self_test": str(self_test).lower(), "clocks_per_bit": CLOCKS_PER_BIT, **generics}
            else:
                told["maps"] = int(self_test)
            self._simulation.run_bench(told, WATCHDOG_SECONDS, writes=answer_file)
            lines = answer_file.read_text().splitlines()
        if not lines or not lines[-1].startswith("leds "):
            raise FlowError("the simulation of the board did not end", EXIT_TOOL_FAILED)
        return Answer([int(line) for line in lines[:-1]], lines[-1].split()[1])
