# SPDX-License-Identifier: Apache-2.0
"""The demo in a fresh, minimal system of each distribution that the project names; minutes. What an own machine has and
its list of packages has not, such as make once, shows only there."""

import re
from pathlib import Path

import pytest

from flow.base.tools import ROOT, find_stereo_hls
from flow_commands import call

SUITES = ("bookworm", "trixie")  # Debian 12 and 13
CONFIGURES = ("scripts/setup.sh --packages-only", "cmake --preset release -Wno-dev")


def _is_own(suite):
    release = Path("/etc/os-release")
    return release.exists() and f"VERSION_CODENAME={suite}\n" in release.read_text()


@pytest.mark.parametrize("suite", SUITES)
def test_demo(suite):
    """In the distribution of this machine the demo takes the program that was built here, and the build there is only
    configured."""
    if _is_own(suite):
        built = Path(find_stereo_hls()).parent
        process = call("try_distribution.sh", "--built", built, suite, *CONFIGURES, "scripts/demo.sh")
    else:
        process = call("try_distribution.sh", suite, "scripts/demo.sh")
    if process.returncode == 3 and "SKIP: " in process.stderr:
        pytest.skip(process.stderr[process.stderr.index("SKIP: ") :].strip())
    said = process.stdout + process.stderr
    assert process.returncode == 0, said[-4000:]
    assert "\nscripts/demo.sh: passed, " in said and "PASS: VHDL against C++ core" in said
    assert re.search(r"^Debian \S+ \(\w+\), root, commit ", said, re.MULTILINE)
    assert "GHDL -" not in said, "a version of each tool"
    assert not (ROOT / "build" / "distributions" / suite).exists(), "the system is gone"
