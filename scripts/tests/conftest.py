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


@pytest.fixture
def ghdl():
    return need("ghdl", "GHDL")


@pytest.fixture
def verilator():
    return need("verilator", "VERILATOR")


@pytest.fixture
def yosys():
    return need("yosys", "YOSYS")
