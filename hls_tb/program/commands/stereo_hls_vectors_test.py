# SPDX-License-Identifier: Apache-2.0
"""The commands vectors and trace: what a simulation sends and what it should see."""

import json

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, fail, succeed


def test_crop_takes_the_centre(tmp_path, pair):
    def pgm(name, value):
        pixels = bytes(value(x, y) for y in range(HEIGHT + 4) for x in range(WIDTH + 6))
        path = tmp_path / name
        path.write_bytes(f"P5\n{WIDTH + 6} {HEIGHT + 4}\n255\n".encode() + pixels)
        return path

    pair = ["--left", pgm("x.pgm", lambda x, y: x), "--right", pgm("y.pgm", lambda x, y: y)]
    succeed("vectors", "--config", "tiny", *pair, "--fit", "crop", "--out", tmp_path / "v")
    lines = (tmp_path / "v" / "stimulus.txt").read_text().splitlines()
    assert lines[1] == "3 03 02"
    assert lines[WIDTH * HEIGHT] == f"1 {WIDTH + 2:02x} {HEIGHT + 1:02x}"


def vectors(tmp_path, pair, *options, config="tiny"):
    succeed("vectors", "--config", config, *pair, "--out", tmp_path / "v", *options)
    return [(tmp_path / "v" / name).read_text().splitlines() for name in ("stimulus.txt", "expected.txt")]


@pytest.mark.parametrize("config, pixels", [("tiny", 1), ("tiny_p2", 2), ("tiny_p4", 4)])
def test_vectors_first_lines_and_counts(tmp_path, pair, config, pixels):
    stimulus, expected = vectors(tmp_path, pair, config=config)
    latency = json.loads(succeed("configurations", "--json"))[config]["latency_clocks"]
    groups = HEIGHT // pixels
    clocks, outputs = WIDTH * groups + WIDTH + latency + 4, 24 * groups
    assert stimulus[0] == f"stereo-hls stimulus 2 config={config} pixels={pixels} clocks={clocks}"
    assert (
        expected[0]
        == f"stereo-hls expected 2 config={config} pixels={pixels} disparity_bits=8 outputs={outputs} latency={latency}"
    )
    assert len(stimulus) == clocks + 1 and len(expected) == outputs + 1
    assert stimulus[1].startswith("3 ") and len(stimulus[1]) == 3 + 4 * pixels
    all_valid = (2**pixels - 1) << 2
    assert expected[1].split()[1:4] == ["0", "0", "0"] and int(expected[1].split()[5]) == all_valid + 1
    assert expected[-1].split()[1:4] == ["23", str(HEIGHT - pixels), "0"]
    assert int(expected[-1].split()[5]) == all_valid + 2
    assert len(expected[-1].split()[4]) == 2 * pixels


def test_vectors_of_several_rows_at_once_hold_the_same(tmp_path, pair):
    def rows_of(lines, pixels, left_to_right):
        """The words of `left_to_right` records a group, taken apart into rows: [y][x]."""
        rows = []
        for start in range(0, len(lines), left_to_right):
            group = lines[start : start + left_to_right]
            rows += [[word[2 * (pixels - 1 - p) :][:2] for word in group] for p in range(pixels)]
        return rows

    seen = []
    for config, pixels in (("tiny", 1), ("tiny_p4", 4)):
        stimulus, expected = vectors(tmp_path, pair, config=config)
        image = [line.split() for line in stimulus[1 : 1 + WIDTH * HEIGHT // pixels]]
        seen.append(
            [
                rows_of([line[1] for line in image], pixels, WIDTH),
                rows_of([line[2] for line in image], pixels, WIDTH),
                rows_of([line.split()[4] for line in expected[1:]], pixels, WIDTH - DISPARITIES),
            ]
        )
    assert seen[0] == seen[1]
    assert seen[0][0] == [
        [f"{v:02x}" for v in (tmp_path / "l.pgm").read_bytes()[-WIDTH * HEIGHT :][y * WIDTH :][:WIDTH]]
        for y in range(HEIGHT)
    ]


def test_vectors_of_rows_frames_and_stalls(tmp_path, pair):
    stimulus, expected = vectors(tmp_path, pair, "--rows", "2:6")
    assert sum(line[0] in "13" for line in stimulus[1:]) == WIDTH * 4
    assert len(expected) - 1 == 24 * 3
    stimulus, expected = vectors(tmp_path, pair, "--rows", "1:9", config="tiny_p4")
    assert sum(line[0] in "13" for line in stimulus[1:]) == WIDTH * 2
    assert len(expected) - 1 == 24
    _, expected = vectors(tmp_path, pair, "--frames", 2, "--stall-percent", 30)
    assert len(expected) - 1 == 2 * 24 * 12
    assert expected[-1].split()[3] == "1"
    assert vectors(tmp_path, pair, "--stall-percent", 30, "--seed", 5) != vectors(
        tmp_path, pair, "--stall-percent", 30, "--seed", 6
    )


@pytest.mark.parametrize("rows, says", [("0:6", "a multiple of the 4 pixels per clock"), ("0:4", "at least 8 rows")])
def test_vectors_of_rows_that_are_no_groups(tmp_path, pair, rows, says):
    fail(tmp_path, "vectors", "--config", "tiny_p4", *pair, "--out", tmp_path / "v", "--rows", rows, says=[rows, says])


def trace_columns(tmp_path, config, *options, clocks=300):
    succeed("trace", "--config", config, "--clocks", clocks, *options, "--out", tmp_path / "t")
    lines = (tmp_path / "t" / "trace.txt").read_text().splitlines()
    assert lines[0] == f"stereo-hls trace 1 config={config} clocks={clocks}" and len(lines) == clocks + 2
    rows = [line.split() for line in lines[2:]]
    names = lines[1].split()
    assert len(set(names)) == len(names)
    assert {len(row) for row in rows} == {len(names)}
    return dict(zip(names, zip(*([int(value, 16) for value in row] for row in rows))))


@pytest.mark.parametrize("stream", [["--frames", 2, "--stall-percent", 30], ["--broken", 8, "--seed", 5]])
def test_trace_of_images_is_of_the_stream_that_vectors_makes(tmp_path, pair, stream):
    """With resets too; and from any clock on."""
    stimulus, expected = vectors(tmp_path, pair, *stream)
    trace = trace_columns(tmp_path, "tiny", *pair, *stream, clocks=len(stimulus) - 1)
    flags = [int(line[0]) for line in stimulus[1:]]
    assert list(trace["in_valid"]) == [word & 1 for word in flags]
    outputs = [(int(line.split()[0]), int(line.split()[4], 16)) for line in expected[1:]]
    valid = [clock for clock, is_valid in enumerate(trace["out_disparity_valid"]) if is_valid]
    assert [(clock, trace["out_disparity"][clock]) for clock in valid] == outputs and outputs
    assert "--broken" not in stream or any(word & 4 for word in flags)
    first = len(flags) - 100
    later = trace_columns(tmp_path, "tiny", *pair, *stream, "--first-clock", first, clocks=100)
    assert later == {name: values[first:] for name, values in trace.items()}


def test_wrong_traces_of_images(tmp_path, pair):
    out = ["trace", "--config", "tiny", "--out", tmp_path / "t"]
    fail(tmp_path, *out, *pair[:2], says=["--left", "--right"])
    fail(tmp_path, *out, "--first-clock", 3, says=["--first-clock", "--left"])
    fail(tmp_path, *out, "--frames", 3, says=["--frames", "--left"])
    fail(tmp_path, *out, *pair, "--first-clock", 9999, says=["--first-clock 9999", "the stream has 436 clocks"])


@pytest.mark.parametrize("config, pixels", [("tiny", 1), ("tiny_p2", 2), ("tiny_p4", 4)])
def test_trace_names_what_the_registers_show(tmp_path, config, pixels):
    trace = trace_columns(tmp_path, config)
    lanes = [trace[f"raster_features_search_{p}"] for p in range(pixels)]
    words = [sum(value << 8 * p for p, value in enumerate(column)) for column in zip(*lanes)]
    assert words[1:] == list(trace["in_left_pixel"][:-1])  # a register shows its input one clock later
    assert trace["raster_features_reference_0"][1:] == tuple(word & 255 for word in trace["in_right_pixel"][:-1])
    assert trace["slice0shift_reference_1"][1:] == trace["rows_reference_1"][:-1]
    difference = trace["slice0cost_difference_1_0"]
    left, right = trace["slice0shift_search_1_0"], trace["slice0shift_reference_1"]
    assert list(difference[1:]) == [a - b for a, b in zip(left, right)][:-1]
    assert min(difference) < 0 < max(difference)
    # 8 disparities in slices of 3, 3 and 2; two levels of winners.
    for name in (
        "slice2shift_search_out_0",
        "slice2winner2_best_index_0_0",
        "slice2_best_index_0_0",
        "slice0window_partial_0_1_2",
        "slice0window_centre_output_column_0",
        "slice0_best_tag_end_of_line",
        "rows_ready_tag_border_column",
    ):
        assert name in trace
    assert not any(name.startswith("slice3") for name in trace)
    assert f"slice2_best_cost_{pixels - 1}_0" in trace and f"slice2_best_cost_{pixels}_0" not in trace


@pytest.mark.parametrize(
    "option, value",
    [
        ("--rows", "4"),
        ("--rows", "a:b"),
        ("--rows", "4:"),
        ("--rows", "4:4"),
        ("--rows", "4:5"),
        ("--rows", "0:13"),
        ("--frames", "0"),
        ("--stall-percent", "96"),
        ("--stall-percent", "-1"),
        ("--seed", "x"),
    ],
)
def test_vectors_options_out_of_range(tmp_path, pair, option, value):
    fail(tmp_path, "vectors", "--config", "tiny", *pair, "--out", tmp_path / "v", option, value, says=[value])
