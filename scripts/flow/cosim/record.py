# SPDX-License-Identifier: Apache-2.0
"""generated_rtl/NAME/cosimulation.json: what the co-simulations of that VHDL gave, for the pages."""

import json

from ..base import files, json_files
from ..base.tools import GENERATED_RTL
from ..synthesis import manifest

FILE = "cosimulation.json"
FORMAT = "stereo-hls cosimulation 1"
_KEPT = {
    "command": str,
    "passed": bool,
    "expected": int,
    "compared": int,
    "mismatches": int,
    "frames": int,
    "clocks": int,
}


def keep(report):
    """Adds a report of cosim.run_job; the last one of each simulator stays."""
    directory = GENERATED_RTL / report["config"]
    entry = manifest.read(directory)
    runs = read(directory, entry) | {report["simulator"]: {key: report[key] for key in _KEPT}}
    content = {"format": FORMAT, "configuration": report["config"], "vhdl_digest": entry["files"], "runs": runs}
    files.write(directory / FILE, json.dumps(content, indent=2, sort_keys=True) + "\n")


def read(directory, entry):
    """{simulator: what is kept of its report} of the VHDL that the manifest `entry` describes; those of other VHDL do not count."""
    path = directory / FILE
    content = json_files.load_result(path, FORMAT)
    if content is None:
        return {}
    runs = content.get("runs")
    if not isinstance(runs, dict) or not all(
        isinstance(run, dict) and all(isinstance(run.get(key), kind) for key, kind in _KEPT.items())
        for run in runs.values()
    ):
        raise json_files.damaged(path, FORMAT)
    return runs if content.get("vhdl_digest") == entry["files"] else {}
