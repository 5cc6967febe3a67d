# SPDX-License-Identifier: Apache-2.0
"""mutation.json beside the VHDL of a configuration: what its mutation run gave, and the table of all for the page."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TypedDict, get_type_hints

from ..base import committed, json_files
from ..base.configurations import configuration, designs
from ..base.markdown import code, number, replaced, table
from ..base.tools import ROOT
from ..synthesis import manifest

FILE, FORMAT = "mutation.json", "stereo-hls mutation 1"
PAGE = ROOT / "docs" / "cosimulation.md"
BEGIN, END = "<!-- mutation: made by scripts/mutate.py --page -->", "<!-- end of mutation -->"


class Result(TypedDict):
    """Of mutants of the core. Times are not kept: they differ from machine to machine."""

    command: str
    mutants: int
    killed: int
    equivalent: int
    argued: int
    survivors: list[str]


_KEPT = get_type_hints(Result)


def keep(config: str, result: Mapping[str, object]) -> None:
    """Puts the result of a run in place of an earlier one."""
    directory = committed.folder(config)
    entry = manifest.read(directory)
    kept = {key: result[key] for key in _KEPT}
    content = {"format": FORMAT, "configuration": config, "design": manifest.design(entry), "result": kept}
    committed.keep([manifest.change(entry, {FILE: json.dumps(content, indent=2, sort_keys=True) + "\n"})])


def read(directory: Path, entry: manifest.Manifest) -> Result | None:
    """None without a run on the VHDL that the manifest `entry` describes."""
    path = directory / FILE
    content = json_files.load_result(path, FORMAT)
    if content is None or content.get("design") != manifest.design(entry):
        return None
    result = content.get("result")
    if not json_files.fits(result, Result):
        raise json_files.damaged(path, FORMAT)
    kept: Result = result  # type: ignore[assignment]
    return kept


def page() -> str:
    """docs/cosimulation.md with its table made anew."""
    rows = []
    for name in committed.known_designs():
        if not (committed.folder(name) / FILE).is_file():
            continue
        kept = read(committed.folder(name), manifest.read(committed.folder(name)))
        if kept:
            counts = (kept["mutants"], kept["killed"], kept["equivalent"], kept["argued"], len(kept["survivors"]))
            rows.append(
                [code(name), configuration(name, designs())["family"], *map(number, counts), code(kept["command"])]
            )
    head = ["core", "family", "mutants", "noticed", "proved equivalent", "argued", "survived", "printed by"]
    return replaced(PAGE, BEGIN, END, table(head, rows))
