# SPDX-License-Identifier: Apache-2.0
"""What the tests of all commands share."""

import pytest

from stereo_hls_program import PROGRAM, write_image


@pytest.fixture(scope="session", autouse=True)
def program():
    if not PROGRAM:
        pytest.skip("SKIP: the program stereo_hls is missing; set STEREO_HLS to it")


@pytest.fixture
def pair(tmp_path):
    left, right = write_image(tmp_path / "l.pgm", seed=1), write_image(tmp_path / "r.pgm", seed=2)
    return ["--left", left, "--right", right]


@pytest.fixture
def match(tmp_path, pair):
    return ["match", "--config", "tiny", "--out", tmp_path / "out", *pair]


@pytest.fixture
def depth(tmp_path):
    return ["depth", "--config", "study", "--out", tmp_path / "out", "--calibration"]


@pytest.fixture
def evaluate(pair, tmp_path):
    return ["evaluate", *pair, "--border", 0, "--json", tmp_path / "e.json"]
