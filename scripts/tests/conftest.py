# SPDX-License-Identifier: Apache-2.0
"""What all tests of the flow share."""

import os
import random
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

from flow.base import venv  # noqa: E402 -- the path comes first
from flow.base.errors import EXIT_MISSING_TOOL, FlowError  # noqa: E402
from flow.pages.plan_algorithms import algorithms  # noqa: E402
from flow.planning import compared, search  # noqa: E402

SEED = int(os.environ.get("STEREO_TEST_SEED", "20070925"))


@pytest.fixture
def rng(request):
    """A generator with the printed seed, different for each test."""
    print(f"STEREO_TEST_SEED={SEED}")
    return random.Random(f"{SEED} {request.node.name}")


def need(name, variable=None):
    """Skips the test, naming the tool, when it is not installed."""
    path = shutil.which(os.environ.get(variable or "") or name)
    if path is None:
        pytest.skip(f"SKIP: {name} is not installed")
    return path


def where_reachable(install):
    """What `install` gives. A skip only where a tool is missing or PyPI is out of reach: a package that cannot be
    installed for another reason is a fault."""
    try:
        return install()
    except FlowError as error:
        if error.exit_code != EXIT_MISSING_TOOL:
            raise
        pytest.skip(f"SKIP: {error}")


@pytest.fixture
def ghdl():
    return need("ghdl", "GHDL")


@pytest.fixture
def verilator():
    return need("verilator", "VERILATOR")


@pytest.fixture
def nvc():
    return need("nvc", "NVC")


@pytest.fixture
def yosys():
    return need("yosys", "YOSYS")


@pytest.fixture(scope="session")
def planner():
    """Of all measured cores, as plan.py has it."""
    return search.Planner(algorithms())


@pytest.fixture(scope="session")
def errors(planner):
    """The estimate of each, left out of its own, beside its measurement."""
    return compared.compare(planner.known)


@pytest.fixture(scope="session")
def fusesoc():
    requirements = ROOT / "scripts" / "requirements-fusesoc.txt"
    return where_reachable(lambda: venv.ensure("venv-fusesoc", requirements, "fusesoc"))
