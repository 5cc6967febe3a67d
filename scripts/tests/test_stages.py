# SPDX-License-Identifier: Apache-2.0
"""Stages in front of a matching core go through the same flow: their VHDL against their C++, and faults put into it."""

import subprocess

import pytest

from cover import with_slow
from flow.base import committed, rtl
from flow.base.configurations import configurations, designs
from flow.base.errors import FlowError
from flow.base.ghdl import STANDARD
from flow.cosim import regression, vectors
from flow.synthesis import manifest
from flow_commands import altered_rtl, call, random_pair, refused, report

TINY, DEEP = "rectify_tiny", "rectify_tiny_12bit"
STAGES = sorted(set(designs()) - set(configurations()))
RECTIFICATION = rtl.STAGES["rectification"]

# One or more in each block.
FAULTS = {
    "counter: a frame one row higher": (r"(counter_next_frame_is_equal_2 := counter_group = )11;", r"\g<1>10;"),
    "delay: a register bypassed": (r"(delay_held_5_left <= )delay_held_4_left;", r"\1delay_held_3_left;"),
    "grid: the next node": (r"(grid_node_column <= counter_column) / 4;", r"\1 / 8;"),
    "grid: a weight in the wrong clock": (
        r"(grid_weight_y_held_3 <= )grid_weight_y_held_2;",
        r"\1grid_weight_y_held_1;",
    ),
    "offsets: the wrong memory": (
        r"leftoffsets_nodes_even_odd_ready_word\(15 downto 0\)",
        "leftoffsets_nodes_even_even_ready_word(15 downto 0)",
    ),
    "offsets: those of the other camera": (
        r"(righttaps_offset_y <= )rightoffsets_y_row_value;",
        r"\1leftoffsets_y_row_value;",
    ),
    "taps: a fraction's bit": (r"(lefttaps_weight_x <= lefttaps_source_x mod) 32;", r"\1 16;"),
    "taps: to the left": (r"(lefttaps_taps_column <= .* \+ 6502)5", r"\g<1>4"),
    "taps: a column too many": (r"(lefttaps_column_shown_1 <= sample_leaves) and .*;", r"\1;"),
    "taps: a row too many": (r"(lefttaps_row_shown_1 <= \(lefttaps_taps_row_sum <) 7\)", r"\1 8)"),
    "sampler: weights swapped": (
        r"(leftsampler_pixel_left_part <= )leftsampler_weight_y_held_3;",
        r"\1leftsampler_weight_x_held_3;",
    ),
    "sampler: no rounding": (r"(leftsampler_pixel_row_base <= .*/ 512\)) \+ 1\)", r"\1 + 0)"),
    "valid a clock early": (r"(valid_held_3 <= )valid_held_2;", r"\1valid_held_1;"),
    "the first pixel of a frame": (r"(starts_held_2 <= )starts_held_1;", r"\1false;"),
}


# What fewer bits would do to pixels of 12.
DEEP_FAULTS = {
    "delay: the highest bit": (r"(delay_held_1_left <= delay_held_0_left);", r"\1 mod 2048;"),
    "sampler: the highest bit of what is kept": (
        r"(leftsampler_rows_written <= sample_kept_pixels_left);",
        r"\1 mod 2048;",
    ),
    "sampler: the lowest bit of what is kept": (
        r"(rightsampler_rows_written <= sample_kept_pixels_right);",
        r"\1 / 2 * 2;",
    ),
    "the lowest bit of what leaves": (
        r"(rectified_left <= .*)to_unsigned\(leftsampler_pixel_row_value, 12",
        r"\1to_unsigned(leftsampler_pixel_row_value / 2 * 2, 12",
    ),
}


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    return random_pair(tmp_path_factory.mktemp("pair"), TINY, levels=256)


@pytest.fixture(scope="module")
def deep_pair(tmp_path_factory):
    return random_pair(tmp_path_factory.mktemp("deep"), DEEP, levels=4096, brightest=4095)


def cosim(pair, out, *options, config=TINY):
    """Of the pair alone, which has known outputs."""
    words = ["--config", config, "--left", pair[0], "--right", pair[1], "--out", out, "--stimulus", "scene"]
    return call("cosim.py", *words, *options)


@pytest.mark.parametrize("config", with_slow([TINY, DEEP], [DEEP]))
def test_the_stress_stream(ghdl, tmp_path, config):
    process = call("cosim.py", "--config", config, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    assert report(tmp_path)["compared"] > 20 * 32 * 12


def test_there_are_stages():
    assert STAGES == ["rectify_tiny", "rectify_tiny_12bit", "rectify_tiny_40", "rectify_vga"]
    assert {committed.folder(name).parent.name for name in STAGES} == set(rtl.STAGES)
    assert not set(STAGES) & set(committed.known_configurations()) and set(STAGES) < set(committed.known_designs())
    assert set(STAGES) < set(regression.select(["all"]))


PAIRS = [(TINY, "pair"), (DEEP, "deep_pair")]


@pytest.mark.parametrize("simulator", ["ghdl", "verilator"])
@pytest.mark.parametrize("stream", [("--frames", 3), ("--frames", 3, "--stall-percent", 30), ("--broken", 30)])
@pytest.mark.parametrize("config, images", with_slow(PAIRS, PAIRS[:1]))
def test_vhdl_is_the_core(request, tmp_path, simulator, stream, config, images):
    request.getfixturevalue(simulator)
    process = cosim(request.getfixturevalue(images), tmp_path, *stream, "--simulator", simulator, config=config)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path)
    assert result["passed"] and result["compared"] == result["expected"] > 3 * 32 * 12
    if "--frames" in stream:
        assert result["frames"] == 3 and result["latency_clocks"] == designs()[config]["latency_clocks"]
    if stream == ("--frames", 3):
        assert result["clocks_per_frame"] == 32 * 12


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["valid a clock early", "sampler: no rounding"]))
def test_fault_is_caught(ghdl, pair, tmp_path, fault):
    made = altered_rtl(tmp_path / "rtl", TINY, *FAULTS[fault])
    process = cosim(pair, tmp_path / "out", "--frames", 12, "--stall-percent", 10, "--rtl", made)
    assert process.returncode in (1, 4), f"{fault} was not caught: {process.stdout}"


@pytest.mark.parametrize("fault", with_slow(DEEP_FAULTS, ["the lowest bit of what leaves"]))
def test_fault_of_pixels_of_12_bits_is_caught(ghdl, deep_pair, tmp_path, fault):
    made = altered_rtl(tmp_path / "rtl", DEEP, *DEEP_FAULTS[fault])
    process = cosim(deep_pair, tmp_path / "out", "--frames", 2, "--rtl", made, config=DEEP)
    assert process.returncode == 1, f"{fault} was not caught: {process.stdout}"


def test_a_generated_scene_has_the_pixels_of_its_stage(ghdl, tmp_path):
    process = call("cosim.py", "--config", DEEP, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    stimulus = (tmp_path / "stimulus.txt").read_text().splitlines()
    assert stimulus[0].endswith(" pixel_bits=12")
    sent = {int(line.split()[1], 16) for line in stimulus[1:]}
    assert max(sent) > 255 and len({value % 16 for value in sent}) == 16


def test_a_failure_says_which_pixels_differ(ghdl, pair, tmp_path):
    made = altered_rtl(tmp_path / "rtl", TINY, *FAULTS["taps: a column too many"])
    process = cosim(pair, tmp_path / "out", "--frames", 2, "--rtl", made)
    assert process.returncode == 1
    assert "expected rectified_left and rectified_right" in process.stdout
    assert (tmp_path / "out" / "failure.gtkw").is_file() and "gtkwave" in process.stdout
    shown = (tmp_path / "out" / "failure.gtkw").read_text()
    assert ".node_column[15:0]" in shown and ".rectified_left[7:0]" in shown


def test_stimulus_writes_every_node_first(pair, tmp_path):
    """Both tables whole before the first pixel, within the table, and nodes while frames are under way."""
    cosim(pair, tmp_path, "--frames", 2)
    row, nodes, first, later = designs()[TINY], set(), None, 0
    for line in (tmp_path / "stimulus.txt").read_text().splitlines()[1:]:
        flags, _, _, column, line_of_nodes, *_ = (int(word, 16) for word in line.split())
        first = len(nodes) if flags & 1 and first is None else first
        if flags & 8:
            nodes.add((flags >> 4, column, line_of_nodes))
            later += first is not None
    columns, rows = row["table_columns"], row["table_rows"]
    assert nodes == {(right, i, j) for right in (0, 1) for i in range(columns) for j in range(rows)}
    assert first == len(nodes) and later > 0


@pytest.mark.parametrize(
    "line",
    ["20 00 00 0000 0000 0000 0000", "3 00 00 0000 0000 0000 0000", "03 00 00 0000", "03 00 00 0 0000 0000 0000"],
)
def test_damaged_stimulus(tmp_path, line):
    path = tmp_path / "stimulus.txt"
    path.write_text(f"stereo-hls stimulus 2 config={TINY} pixels=1 clocks=1\n{line}\n")
    words = "is not 'F LEFT RIGHT NODE_COLUMN NODE_ROW NODE_X NODE_Y' with 2 or 4 digits"
    with pytest.raises(FlowError, match=words):
        vectors.read_stimulus(path, RECTIFICATION)


@pytest.mark.parametrize("generic", RECTIFICATION.generics)
def test_a_wrong_generic_stops_elaboration(ghdl, tmp_path, generic):
    step, value = [ghdl, "-a", STANDARD, *map(str, manifest.core_files(TINY))], designs()[TINY][generic]
    assert subprocess.run(step, cwd=tmp_path).returncode == 0
    step = [ghdl, "-r", STANDARD, committed.entity(TINY), f"-g{generic}={value + 1}"]
    process = subprocess.run(step, cwd=tmp_path, capture_output=True, text=True)
    assert process.returncode != 0
    assert f"{generic} is {value + 1} but this core has {value}" in process.stdout + process.stderr


def test_an_edited_table_of_configurations_makes_it_stale(monkeypatch):
    row = designs()[TINY]
    assert manifest.stale_reasons(TINY, row) == []
    assert "its row in rectification/configurations.hpp changed" in manifest.stale_reasons(
        TINY, row | {"rows_above": 4}
    )


def test_what_is_for_matching_cores_is_refused(tmp_path):
    refused(call("implement.py", "--config", TINY, "--shell"), 2, "is a stage and has no shell")
    refused(call("cosim.py", "--config", TINY, "--simulator", "original", "--out", tmp_path), 2, "is a stage")
    for command in ("instantiate.py", "verify_axi.py"):
        refused(call(command, "--config", TINY), 2, TINY)
