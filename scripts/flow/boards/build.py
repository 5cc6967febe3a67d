# SPDX-License-Identifier: Apache-2.0
"""The design for a board, from VHDL to a bit stream: `ghdl --synth`, yosys, nextpnr, the packer of the family."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

from ..base import committed, ghdl, places
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Say, Word, find_tool, run
from ..implementation import nextpnr, yosys
from ..implementation.families.family import TOP as CORE, RoutedFamily
from ..shell import board_vhdl
from ..synthesis import manifest
from ..synthesis.presentation import scalars
from .boards import Board
from .record import SEED, Built, Figures


def build(board: Board, config: str, work: Path, seed: int = SEED, say: Say = print) -> Built:
    """Makes everything in the folder `work`."""
    board_vhdl.sizes(config)  # refuses what the board's design cannot hold, before a folder is emptied
    places.emptied_folder(work)
    family = board.target.family
    assert isinstance(family, RoutedFamily)
    router = nextpnr.find_nextpnr(family, say)
    say("ghdl --synth ...")
    files = scalars.files(board_vhdl.files(config, work))
    (work / f"{board_vhdl.TOP}.v").write_text(ghdl.to_verilog(files, work, board_vhdl.TOP, board.generics()))
    say("yosys ...")
    without_bypass = yosys.memories_without_bypass(manifest.read(committed.folder(config))["parameters"])
    (work / "synthesis.ys").write_text(_synthesis(family, without_bypass, board.held_high))
    run([*yosys.find_yosys(say), "-s", "synthesis.ys"], cwd=work, log=work / "yosys.log")
    say("nextpnr ...")
    shutil.copy(board_vhdl.FOLDER / board.constraints, work)
    bit_stream = f"{board.name}{family.bit_stream}"
    # Relative names: that of PyPI is WebAssembly and sees nothing of the machine's folders.
    files_in: list[Word] = ["--json", "netlist.json", *family.constraint_options(board.constraints)]
    files_out: list[Word] = ["--report", "report.json", family.routed_option, "routed"]
    wanted: list[Word] = ["--freq", board.clock_mhz, "--seed", seed, "--timing-allow-fail"]
    run([router, *board.target.options, *wanted, *files_in, *files_out], cwd=work, log=work / "nextpnr.log")
    say(f"{family.packer} ...")
    options = family.packer_options(board.target.options, "routed", bit_stream)
    run([_find_packer(family, router), *options], cwd=work, log=work / "packer.log")
    return _read(family, work, work / bit_stream)


def _find_packer(family: RoutedFamily, router: str) -> str:
    """Beside the router, as PyPI installs it, or in PATH."""
    beside = Path(router).with_name(family.packer_beside)
    return str(beside) if beside.is_file() else find_tool(family.packer, family.packer.upper())


def _synthesis(family: RoutedFamily, without_bypass: str, held_high: tuple[str, ...]) -> str:
    """yosys's commands, those of implement.py for the core, for the whole board."""

    def of_top(commands: str) -> str:
        return commands.replace(f"-top {CORE}", f"-top {board_vhdl.TOP}")

    lines = [f"read_verilog {board_vhdl.TOP}.v", of_top(family.prepare)]
    for pin in held_high:
        lines += [f"add -output {pin} 1 {board_vhdl.TOP}", f"connect -set {pin} 1'1 {board_vhdl.TOP}"]
    lines += [f"setattr -set no_rw_check 1 {without_bypass}"] if without_bypass else []
    lines += [of_top(family.synthesis), family.buffers or "opt_clean", "write_json netlist.json"]
    return "\n".join(lines) + "\n"


def _read(family: RoutedFamily, work: Path, bit_stream: Path) -> Built:
    try:
        report: dict[str, Any] = json.loads((work / "report.json").read_text())
        cells = json.loads((work / "netlist.json").read_text())["modules"][board_vhdl.TOP]["cells"].values()
        figures: Figures = {
            "lut_sites": family.lut_sites(report["utilization"]),
            "flip_flops": sum(cell["type"].startswith(family.ffs) for cell in cells),
            "block_rams": sum(cell["type"].startswith(family.block_rams) for cell in cells),
            "fmax_mhz": nextpnr.fmax_mhz(report),
        }
        return Built(figures, bit_stream)
    except (OSError, ValueError, KeyError, StopIteration) as error:
        raise FlowError(
            f"nextpnr wrote no usable report ({error}); see {work / 'nextpnr.log'}", EXIT_TOOL_FAILED
        ) from None
