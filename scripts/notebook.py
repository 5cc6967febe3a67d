#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the Python module, runs a notebook with it, and writes the notebook with its results and its pictures."""

import base64
import json
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files, places, python_module
from flow.base.errors import EXIT_OK, EXIT_TOOL_FAILED, ArgumentParser, FlowError, run_command
from flow.base.options import a_path
from flow.base.tools import ROOT, run

NOTEBOOK = ROOT / "examples" / "notebook" / "quality_cost.ipynb"


def main() -> int:
    parser = ArgumentParser(prog="notebook.py", description=__doc__)
    parser.add_argument("notebook", nargs="?", type=a_path, default=NOTEBOOK, help="default: %(default)s")
    parser.add_argument(
        "--out", type=a_path, default=ROOT / "build" / "notebook", help="folder (default build/notebook)"
    )
    options = parser.parse_args()
    if not options.notebook.is_file():
        raise FlowError(f"{options.notebook}: there is no such file")
    out, stem = options.out.resolve(), options.notebook.stem
    if out == options.notebook.resolve().parent:
        raise FlowError(f"--out {options.out}: the notebook itself would be replaced; name another folder")
    places.results_folder(out, (f"{stem}.ipynb", f"{stem}_1.png", f"{stem}.log", "jupyter"))
    programs = python_module.install()
    for path in write(execute(programs, options.notebook.resolve(), out), out / stem):
        print(path)
    return EXIT_OK


def execute(programs: Path, notebook: Path, out: Path) -> dict:
    """The notebook with its outputs. Jupyter's own files go to `out`, and not to the user's home."""
    kept = {name: str(out / "jupyter") for name in ("IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR")}
    os.environ.update(kept, JUPYTER_PLATFORM_DIRS="1")
    log, result = out / f"{notebook.stem}.log", out / "jupyter" / notebook.name
    result.parent.mkdir(exist_ok=True)
    try:
        run([programs / "jupyter-execute", "--kernel_name=python3", f"--output={result}", notebook], log=log)
    except FlowError as error:
        raise FlowError(f"{notebook.name}: {error}", EXIT_TOOL_FAILED) from None
    filled: dict = json.loads(result.read_text())
    return filled


def write(notebook: dict, stem: Path) -> list[Path]:
    """Writes NAME.ipynb and NAME_1.png ...; gives their paths."""
    paths = [stem.with_suffix(".ipynb")]
    files.write(paths[0], json.dumps(notebook, indent=1) + "\n")
    outputs = [output for cell in notebook["cells"] for output in cell.get("outputs", [])]
    pictures = [output["data"]["image/png"] for output in outputs if "image/png" in output.get("data", {})]
    for number, picture in enumerate(pictures, 1):
        paths.append(stem.with_name(f"{stem.name}_{number}.png"))
        files.write(paths[-1], base64.b64decode(picture))
    return paths


if __name__ == "__main__":
    run_command(main)
