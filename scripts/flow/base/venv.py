# SPDX-License-Identifier: Apache-2.0
"""Python packages that no Debian package brings, in virtual environments of the project's own under build/."""

import os
import sys
from pathlib import Path

from .errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED, FlowError
from .locks import exclusive
from .tools import ROOT, Say, run

PYTHON = "/usr/bin/python3"
# What pip says when no server answers. A package that lacks the pinned version has others, and pip lists them.
UNREACHABLE = ("(from versions: none)", "Retrying (Retry(")


def ensure(name: str, requirements: Path, what: str, say: Say = print) -> Path:
    """The folder bin/ of build/NAME with everything that the file `requirements` names; installed when it is not there
    yet. `what`: the package in the words of the message."""
    folder, wanted = ROOT / "build" / name, requirements.read_text()
    stamp = folder / "requirements.txt"
    folder.parent.mkdir(parents=True, exist_ok=True)
    # Tests run side by side: the second one waits until the first has installed it.
    with exclusive(folder.with_suffix(".lock")):
        if not (os.access(folder / "bin" / "python3", os.X_OK) and stamp.is_file() and stamp.read_text() == wanted):
            say(f"installing {what} from PyPI into {folder.relative_to(ROOT)} ...")
            _install(folder, requirements, what)
            stamp.write_text(wanted)
    return folder / "bin"


def pinned(requirements: Path, package: str) -> str:
    """The line of the file `requirements` that names a package and its version."""
    for line in requirements.read_text().splitlines():
        if line.startswith(f"{package}=="):
            return line
    raise FlowError(f"{requirements} does not pin {package}")


def _install(folder: Path, requirements: Path, what: str) -> None:
    python = PYTHON if os.access(PYTHON, os.X_OK) else sys.executable
    log = folder.parent / f"{folder.name}.log"
    try:
        run([python, "-m", "venv", "--system-site-packages", folder], log=log)
    except FlowError:
        raise FlowError(
            f"cannot make {folder}; on Debian: apt-get install python3-venv; see {log}", EXIT_MISSING_TOOL
        ) from None
    try:
        install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]
        run([folder / "bin" / "python3", *install, requirements], log=log)
    except FlowError as error:
        said = log.read_text()
        if not any(words in said for words in UNREACHABLE):
            raise FlowError(f"cannot install {what}: {error}", EXIT_TOOL_FAILED) from None
        raise FlowError(
            f"{what} is not installed and cannot be fetched from PyPI (offline?); see {log}", EXIT_MISSING_TOOL
        ) from None
