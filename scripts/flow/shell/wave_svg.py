# SPDX-License-Identifier: Apache-2.0
"""Timing diagrams as SVG, drawn from what a simulation recorded: one value for each signal and clock."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple
from xml.sax.saxutils import escape

NAME_WIDTH, ROW_HEIGHT, WAVE_HEIGHT, SLANT = 130, 26, 16, 3
DIGIT_WIDTH = 7.5
STYLE = (
    "text{font:11px monospace;fill:#222}.v{font-size:9px;text-anchor:middle}"
    ".c{font-size:9px;fill:#888;text-anchor:middle}path{fill:none;stroke:#1f4e79;stroke-width:1.4}"
    ".g{stroke:#ddd;stroke-width:1}.x{fill:#e6e6e6;stroke:#bbb}.b{fill:#eaf2fa}"
)


class Signal(NamedTuple):
    """One row, a value for each clock."""

    name: str
    values: list[str | None]  # "0" and "1" of a line, the text of a word, None where nothing is meant
    is_word: bool = False


def _bit(values: list[str | None], left: int, top: int, clock_width: int) -> list[str]:
    """A line that is high or low."""
    parts: list[str] = []
    level = None
    for clock, value in enumerate(values):
        x, y = left + clock * clock_width, top + (0 if value == "1" else WAVE_HEIGHT)
        if level is None:
            parts.append(f"M{x} {y}")
        elif y != level:
            parts.append(f"L{x} {level}L{x + SLANT} {y}")
        parts.append(f"L{x + clock_width} {y}")
        level = y
    return [f'<path d="{"".join(parts)}"/>']


def _runs(values: list[str | None]) -> Iterator[tuple[int, int, str | None]]:
    """(first clock, clock behind the last, value) of clocks with the same value."""
    start = 0
    for clock in range(1, len(values) + 1):
        if clock == len(values) or values[clock] != values[start]:
            yield start, clock, values[start]
            start = clock


def _word(values: list[str | None], left: int, top: int, clock_width: int) -> list[str]:
    """Boxes with values; grey where nothing is meant (None)."""
    parts = []
    for start, end, value in _runs(values):
        x, width, middle = left + start * clock_width, (end - start) * clock_width, top + WAVE_HEIGHT / 2
        right, bottom = x + width, top + WAVE_HEIGHT
        kind = "x" if value is None else "b"
        upper = f"L{x + SLANT} {top}L{right - SLANT} {top}L{right} {middle}"
        lower = f"L{right - SLANT} {bottom}L{x + SLANT} {bottom}Z"
        parts.append(f'<path class="{kind}" d="M{x} {middle}{upper}{lower}"/>')
        if value is not None:
            parts.append(f'<text class="v" x="{x + width / 2}" y="{middle + 3}">{escape(value)}</text>')
    return parts


def svg(signals: list[Signal], clocks: list[int]) -> str:
    """`clocks`: their numbers."""
    texts = [text for signal in signals if signal.is_word for text in signal.values if text]
    clock_width = max(30, round(DIGIT_WIDTH * max(map(len, texts), default=0)))
    width = NAME_WIDTH + len(clocks) * clock_width + 10
    height = (len(signals) + 1) * ROW_HEIGHT + 10
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">',
        f'<style>{STYLE}</style><rect width="100%" height="100%" fill="#fff"/>',
    ]
    for place, clock in enumerate(clocks):
        x = NAME_WIDTH + place * clock_width
        number = f'<text class="c" x="{x + clock_width / 2}" y="16">{clock}</text>'
        parts.append(f'<path class="g" d="M{x} 22L{x} {height - 6}"/>{number}')
    for row, signal in enumerate(signals):
        top = (row + 1) * ROW_HEIGHT + 2
        parts.append(f'<text x="4" y="{top + WAVE_HEIGHT - 4}">{escape(signal.name)}</text>')
        draw = _word if signal.is_word else _bit
        parts += draw(signal.values, NAME_WIDTH, top, clock_width)
    return "\n".join([*parts, "</svg>", ""])


def cut(rows: list[dict[str, str]], first: int, last: int, lines: Iterable[str], words: dict[str, str]) -> str:
    """The picture of some clocks of a recording. `lines`: names of single bits; `words`: {name: the signal whose '1'
    gives it a meaning}. Names in the order of `lines` with each word behind its valid and ready."""
    part = rows[first : last + 1]
    signals = [Signal(name, [row[name] for row in part]) for name in lines]
    for name, meant in words.items():
        digits = -(-len(part[0][name]) // 4)
        texts = [f"{int(row[name], 2):0{digits}x}" if row[meant] == "1" else None for row in part]
        signals.append(Signal(name, texts, is_word=True))
    signals.sort(key=lambda signal: [*part[0]].index(signal.name))
    return svg(signals, list(range(first, first + len(part))))
