# SPDX-License-Identifier: Apache-2.0
"""The Python module stereo_hls (hls_tb/python), built from these sources in a virtual environment of its own."""

import os
import re
from pathlib import Path

from . import venv
from .errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED, FlowError
from .locks import exclusive
from .tools import ROOT, Say, Word, find_stereo_hls, run

REQUIREMENTS = ROOT / "scripts" / "requirements-python.txt"
_HEADER = "import sysconfig; print(sysconfig.get_path('include') + '/Python.h')"


def install(say: Say = print) -> Path:
    """The folder bin/ of build/venv-python, with the module as the sources are now."""
    programs = venv.ensure("venv-python", REQUIREMENTS, "what builds the Python module", say)
    python = programs / "python3"
    if not os.path.isfile(run([python, "-c", _HEADER]).strip()):
        raise FlowError("Python.h not found; on Debian: apt-get install python3-dev", EXIT_MISSING_TOOL)
    say("building the Python module into build/python ...")
    log = ROOT / "build" / "python-module.log"
    # The packages that build it are in the environment already: so they have the same path each time, and what is
    # compiled stays.
    words: list[Word] = [
        "-m",
        "pip",
        "install",
        "--disable-pip-version-check",
        "--no-build-isolation",
        "--no-deps",
        *(f"--config-settings=cmake.define.{name}={value}" for name, value in of_native_build().items()),
        ROOT,
    ]
    with exclusive(ROOT / "build" / "python-module.lock"):
        try:
            run([python, *words], log=log)
        except FlowError:
            raise FlowError(f"the Python module cannot be built; see {log}", EXIT_TOOL_FAILED) from None
    return programs


def of_native_build() -> dict[str, str]:
    """What is given to CMake as the native build has it: with the same compiler, of the same name, and the same options
    another build finds most objects in the compiler cache. By itself the module takes the compiler that made Python."""
    try:
        cache = Path(find_stereo_hls()).with_name("CMakeCache.txt").read_text()
    except (FlowError, OSError):  # the module does not need that build
        return {"STEREO_WERROR": "OFF"}
    return dict(re.findall(r"^(STEREO_WERROR|CMAKE_CXX_COMPILER):\w+=(.+)$", cache, re.MULTILINE))


def site_packages(programs: Path) -> Path:
    """Where the module stands, for an interpreter of the same version."""
    return Path(run([programs / "python3", "-c", "import sysconfig; print(sysconfig.get_path('platlib'))"]).strip())
