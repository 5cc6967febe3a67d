# SPDX-License-Identifier: Apache-2.0
"""Damaged vector files are refused with the file, the line and the reason."""

import pytest

from flow.base import rtl
from flow.base.errors import FlowError
from flow.cosim import vectors

STIMULUS = "stereo-hls stimulus 2 config=tiny pixels=1 clocks=3\n3 01 ff\n0 00 00\n1 a0 0b\n"
EXPECTED = (
    "stereo-hls expected 2 config=tiny pixels=1 disparity_bits=8 outputs=2 latency=10\n50 0 0 0 03 1\n51 1 0 0 1f 0\n"
)


def written(tmp_path, text):
    path = tmp_path / "vectors.txt"
    path.write_text(text)
    return path


def test_good_files_are_read(tmp_path):
    assert vectors.read_stimulus(written(tmp_path, STIMULUS)) == [(True, True), (False, False), (True, False)]
    outputs, latency = vectors.read_expected(written(tmp_path, EXPECTED))
    assert outputs == [vectors.Expected(50, 0, 0, 0, 3, 1), vectors.Expected(51, 1, 0, 0, 31, 0)]
    assert latency == 10
    wide = (
        STIMULUS.replace("pixels=1", "pixels=2")
        .replace("01 ff", "0102 ff00")
        .replace("00 00", "0000 0000")
        .replace("a0 0b", "a0a1 0b0c")
    )
    assert vectors.read_stimulus(written(tmp_path, wide)) == [(True, True), (False, False), (True, False)]
    assert vectors.read_observed(written(tmp_path, "50 3 1\n51 X X\nend 60\n")) == (
        [vectors.Observed(50, 3, 1), vectors.Observed(51, "X", "X")],
        60,
    )


def test_pixels_of_more_bits(tmp_path):
    wide = STIMULUS.replace("clocks=3", "clocks=3 pixel_bits=10")
    wide = wide.replace("01 ff", "3ff 001").replace("00 00", "000 000").replace("a0 0b", "0a0 00b")
    kind = rtl.kind_of({"family": "block_matching", "pixel_bits": 10})
    path = written(tmp_path, wide)
    assert vectors.read_stimulus(path, kind) == [(True, True), (False, False), (True, False)]
    parameters = {"family": "block_matching", "pixels_per_clock": 1, "disparity_bits": 8, "pixel_bits": 10}
    vectors.check_fits(path, "tiny", parameters)
    with pytest.raises(FlowError, match="pixel_bits=10, but the core is tiny with pixel_bits=12"):
        vectors.check_fits(path, "tiny", parameters | {"pixel_bits": 12})
    with pytest.raises(FlowError, match="is not 'F LEFT RIGHT' with 2 digits"):
        vectors.read_stimulus(path)


def test_a_pair_of_pixels_of_more_bits(tmp_path):
    """Of a stage, whose outputs are the rectified pixels of both cameras."""
    path = written(
        tmp_path, EXPECTED.replace("bits=8", "bits=24").replace(" 03 ", " abc003 ").replace(" 1f ", " 00001f ")
    )
    assert [output.disparity for output in vectors.read_expected(path)[0]] == [0xABC003, 0x1F]
    parameters = {"family": "rectification", "pixels_per_clock": 1, "pixel_bits": 12}
    vectors.check_fits(path, "tiny", parameters)
    with pytest.raises(FlowError, match="disparity_bits=24, but the core is tiny with disparity_bits=20"):
        vectors.check_fits(path, "tiny", parameters | {"pixel_bits": 10})


@pytest.mark.parametrize(
    "text,reason",
    [
        ("", "line 1: not a 'stimulus'"),
        (EXPECTED, "line 1: not a 'stimulus'"),
        (STIMULUS.replace("stimulus 2", "stimulus 3"), "line 1: not a 'stimulus'"),
        (STIMULUS.replace("clocks=3", "clocks=4"), "promises 4 lines, but 3 follow"),
        (STIMULUS.replace("clocks=3", "clocks=many"), "no number clocks="),
        (STIMULUS.replace("pixels=1 ", ""), "pixels= must be 1, 2 or 4"),
        (STIMULUS.replace("pixels=1", "pixels=2"), "line 2: '3 01 ff' is not 'F LEFT RIGHT' with 4 digits"),
        (STIMULUS.replace("a0", "g0"), "line 4: '1 g0 0b'"),
        (STIMULUS.replace("3 01", "8 01"), "line 2: '8 01 ff'"),
    ],
)
def test_damaged_stimulus(tmp_path, text, reason):
    with pytest.raises(FlowError, match=reason) as caught:
        vectors.read_stimulus(written(tmp_path, text))
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    "text,reason",
    [
        (STIMULUS, "line 1: not a 'expected'"),
        (EXPECTED.replace("outputs=2", "outputs=1"), "promises 1 lines, but 2 follow"),
        (EXPECTED.replace("latency=10", "latency=ten"), "no number latency="),
        (EXPECTED.replace("51 1 0 0 1f 0", "51 1 0 0 1f"), "line 3: '51 1 0 0 1f'"),
        (EXPECTED.replace("51", "-51"), "line 3: '-51 1"),
    ],
)
def test_damaged_expectation(tmp_path, text, reason):
    with pytest.raises(FlowError, match=reason):
        vectors.read_expected(written(tmp_path, text))


@pytest.mark.parametrize(
    "text,reason",
    [
        ("", "did not finish"),
        ("50 3 1\n51 4 0\n", "did not finish"),
        ("50 3\nend 60\n", "line 1: '50 3'"),
    ],
)
def test_simulation_that_broke_off(tmp_path, text, reason):
    with pytest.raises(FlowError, match=reason) as caught:
        vectors.read_observed(written(tmp_path, text))
    assert caught.value.exit_code == 4


def test_missing_and_binary_files(tmp_path):
    with pytest.raises(FlowError, match="cannot read vector file .*nothing.txt: No such file"):
        vectors.read_stimulus(tmp_path / "nothing.txt")
    (tmp_path / "binary").write_bytes(b"\x89PNG\xff")
    with pytest.raises(FlowError, match="not a text file"):
        vectors.read_stimulus(tmp_path / "binary")
