# SPDX-License-Identifier: Apache-2.0
"""Arguments that most commands share."""

import pytest

from stereo_hls_program import write_image


@pytest.fixture
def pair(tmp_path):
    left, right = write_image(tmp_path / "l.pgm", seed=1), write_image(tmp_path / "r.pgm", seed=2)
    return ["--left", left, "--right", right]


@pytest.fixture
def match(tmp_path, pair):
    return ["match", "--config", "tiny", "--out", tmp_path / "out", *pair]
