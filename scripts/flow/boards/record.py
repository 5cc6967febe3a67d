# SPDX-License-Identifier: Apache-2.0
"""examples/boards/measured.json: area and clock of the bit streams, each with a digest of what it was made of, and the
table of the page."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any, NamedTuple, TypedDict

from ..base import committed, files, json_files
from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.markdown import code, number, replaced, table
from ..shell import board_vhdl, design
from ..synthesis import manifest
from .boards import BOARDS, Board

FILE, FORMAT = board_vhdl.FOLDER / "measured.json", "stereo-hls boards 1"
PAGE = board_vhdl.FOLDER / "README.md"
BEGIN, END = "<!-- area and clock: made by scripts/build_example.py --page -->", "<!-- end of area and clock -->"
SEED = 1  # of place and route


class Figures(TypedDict):
    lut_sites: int
    flip_flops: int
    block_rams: int
    fmax_mhz: float


class Built(NamedTuple):
    """What was made."""

    figures: Figures
    bit_stream: Path


class Kept(Figures):
    design: str  # digest


def digest(board: Board, config: str) -> str:
    """Of all that decides what is built, but the versions of the tools. Of a generated core the structure, not the
    names in it."""
    entry = manifest.read(committed.folder(config))
    by_hand = [*board_vhdl.BY_HAND, *design.shell_files(), board_vhdl.FOLDER / board.constraints]
    parts = [
        board.clock_mhz,
        board.target.family.name,
        board.target.options,
        sorted(board.generics().items()),
        board.held_high,
        [manifest.digest(path) for path in by_hand],
        board_vhdl.core_text(config),
        sorted(manifest.design(entry).items()),
    ]
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def _load() -> dict[str, Any]:
    """{board: {configuration: figures with their digest}}"""
    content = json_files.load_result(FILE, FORMAT)
    builds: dict[str, Any] = content.get("builds", {}) if content else {}
    if not json_files.fits(builds, dict[str, dict[str, Kept]]):
        raise json_files.damaged(FILE, FORMAT)
    return builds


def read(board: Board, config: str) -> Figures | None:
    """None where there is no record, or one of another design."""
    entry = _load().get(board.name, {}).get(config)
    if entry is None or entry["design"] != digest(board, config):
        return None
    entry.pop("design")
    kept: Figures = entry
    return kept


def keep(board: Board, config: str, built: Built, made_of: str) -> None:
    """`made_of`: digest() when the build was begun."""
    if made_of != digest(board, config):
        raise FlowError(f"the design of {board.name} changed in the meantime; nothing recorded", EXIT_MISMATCH)
    builds = _load()
    of_board = builds.setdefault(board.name, {})
    of_board[config] = {**built.figures, "design": made_of}
    content = {"format": FORMAT, "builds": builds}
    files.write(FILE, json.dumps(content, indent=2, sort_keys=True) + "\n")


def configurations(board: Board) -> tuple[str, str]:
    """Those of the page."""
    return board.config, board_vhdl.CONFIG


def page() -> str:
    """examples/boards/README.md with its table made anew."""
    rows = []
    for board in BOARDS.values():
        holds = board.target.holds
        assert holds is not None
        for config in configurations(board):
            kept = read(board, config)
            area = [f"{number(kept['lut_sites'])} of {number(holds.lut_sites)}"] if kept else ["-"]
            area += [number(kept["flip_flops"]), f"{kept['block_rams']} of {holds.block_rams}"] if kept else ["-", "-"]
            clock = number(kept["fmax_mhz"], 2) if kept else "-"
            rows.append([code(board.name), code(config), *area, clock, str(board.clock_mhz)])
    head = ["board", "core", "LUT sites", "flip-flops", "block RAMs", "clock reached, MHz", "needed, MHz"]
    return replaced(PAGE, BEGIN, END, table(head, rows))
