# SPDX-License-Identifier: Apache-2.0
"""From annotated C++ to VHDL to a proven VHDL: the steps behind the commands in scripts/.

All of them run with this Python or a later one. Python 3.6 can read this file and the commands themselves, so that it
is told so."""

import sys

OLDEST_PYTHON = (3, 9)

if sys.version_info < OLDEST_PYTHON:
    sys.stderr.write(
        f"{sys.argv[0].rsplit('/', 1)[-1]}: needs Python {OLDEST_PYTHON[0]}.{OLDEST_PYTHON[1]} or later; "
        f"{sys.executable} is {sys.version.split()[0]}\n"
    )
    sys.exit(3)  # EXIT_MISSING_TOOL of base/errors.py, which such a Python cannot read
