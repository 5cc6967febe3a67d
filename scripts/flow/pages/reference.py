# SPDX-License-Identifier: Apache-2.0
"""docs/options.md and docs/configurations.md: every option and every named configuration, from their declarations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from ..base import committed
from ..base.configurations import Configuration, designs, options
from ..base.markdown import code, number, table
from ..base.tools import ROOT
from ..synthesis import manifest

OPTIONS, CONFIGURATIONS = ROOT / "docs" / "options.md", ROOT / "docs" / "configurations.md"
TEXTS = Path(__file__).parent / "texts"
PLACE = "@TABLES@"  # in the texts


def pages() -> dict[Path, str]:
    """{page: its text}"""
    rows = {name: row for name, row in designs().items() if row["use"] != committed.OWN}
    made = {name: manifest.read(committed.folder(name)) for name in committed.known_designs() if name in rows}
    texts = {OPTIONS: _options(rows, made), CONFIGURATIONS: _configurations(rows, made)}
    return {page: (TEXTS / page.name).read_text().replace(PLACE, text) for page, text in texts.items()}


class Cost(NamedTuple):
    """What one option changes: two configurations that differ in nothing else."""

    config: str
    base: str
    clocks: int
    memory_bits: int
    register_bits: int

    def text(self) -> str:
        changes = [(self.clocks, "clock"), (self.memory_bits, "memory bit"), (self.register_bits, "register bit")]
        counted = [f"{value:+,} {unit}{'s' if abs(value) != 1 else ''}" for value, unit in changes if value]
        return f"{', '.join(counted) or 'nothing'} ({code(self.config)} beside {code(self.base)})"


def costs(
    family: str, rows: Mapping[str, Configuration], made: Mapping[str, manifest.Manifest]
) -> Iterator[tuple[str, Cost]]:
    """(option, what it costs), of the configurations with the shortest names where several show it."""
    names = options()[family]
    of_family = [name for name in made if rows[name]["family"] == family]
    values: dict[str, dict[str, Any]] = {name: {key: dict(rows[name])[key] for key in names} for name in of_family}
    pairs = ((base, config) for base in of_family for config in of_family if base != config)
    for base, config in sorted(pairs, key=lambda pair: (len(pair[0] + pair[1]), pair)):
        different = [name for name in names if values[base][name] != values[config][name]]
        if len(different) == 1 and values[base][different[0]] == names[different[0]]["default"]:
            before, after = made[base]["tool_report"], made[config]["tool_report"]
            yield (
                different[0],
                Cost(
                    config,
                    base,
                    rows[config]["latency_clocks"] - rows[base]["latency_clocks"],
                    after["memory_bits"] - before["memory_bits"],
                    after["register_bits"] - before["register_bits"],
                ),
            )


def _options(rows: Mapping[str, Configuration], made: Mapping[str, manifest.Manifest]) -> str:
    families = options()
    found: dict[str, dict[str, list[str]]] = {}  # {option: {limits and default: families}}
    examples: dict[str, tuple[str, Cost]] = {}  # {option: (family, what it costs there)}
    for family, of_family in families.items():
        for name, option in of_family.items():
            found.setdefault(name, {}).setdefault(_limits(option), []).append(family)
        for name, one in costs(family, rows, made):
            examples.setdefault(name, (family, one))
    meanings = {
        name: option.get("meaning", "") for of_family in families.values() for name, option in of_family.items()
    }
    lines = []
    for name in sorted(found, key=lambda name: (-sum(map(len, found[name].values())), name)):
        for place, (limits, of) in enumerate(sorted(found[name].items(), key=lambda item: -len(item[1]))):
            default, _, reach = limits.partition("\n")
            first, example = place == 0, examples.get(name)
            lines.append(
                [
                    code(name) if first else "",
                    meanings[name] if first else "",
                    reach,
                    default,
                    "all" if len(of) == len(families) else ", ".join(sorted(of)),
                    example[1].text() if example and example[0] in of else "",
                ]
            )
    return table(["option", "what it is", "values", "default", "families", "for example"], lines)


def _limits(option: Mapping[str, Any]) -> str:
    """The default and the values, a line each."""
    default = str(option["default"]).lower() if isinstance(option["default"], bool) else str(option["default"])
    if "words" in option:
        return f"{default}\n{', '.join(option['words'])}"
    low, high = option["low"], option["high"]
    if low is not None and option["default"] < low:
        default = "none"
    if high is None:
        return f"{default}\n{'any number' if low is None else f'{low} or more'}"
    return f"{default}\n{'up to' if low is None else f'{low} ...'} {high}"


def _configurations(rows: Mapping[str, Configuration], made: Mapping[str, manifest.Manifest]) -> str:
    parts = []
    for family in sorted({row["family"] for row in rows.values()}):
        names = sorted(name for name, row in rows.items() if row["family"] == family)
        parts.append(f"## {family}\n\n{table(_HEADINGS, [_line(name, rows[name], made.get(name)) for name in names])}")
    return "\n\n".join(parts)


_HEADINGS = ["configuration", "use", "what it is", "options", "latency", "memory bits", "register bits"]


def _line(name: str, row: Configuration, entry: manifest.Manifest | None) -> Sequence[str]:
    report = entry["tool_report"] if entry else None
    return [
        code(name),
        row["use"],
        row["description"],
        ", ".join(row["options"]),
        number(row["latency_clocks"]),
        number(report["memory_bits"] if report else None),
        number(report["register_bits"] if report else None),
    ]
