# SPDX-License-Identifier: Apache-2.0
"""The program stereo_hls as its users meet it: files, messages and exit codes. Its command match:
stereo_hls_match_test.py."""

import json
import os
import shutil
import subprocess

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, PROGRAM, WIDTH, changed, fail, png_size, succeed


def test_version():
    assert succeed("--version").strip().count(".") == 2


def test_help_names_the_exit_codes():
    assert "Exit codes: 0 success; 1 internal failure; 2 wrong usage or input" in succeed("--help")


def test_a_start_loads_no_readers_of_images():
    """The libraries behind them take ten times as long to load as all others together."""
    process = subprocess.run(
        [PROGRAM], capture_output=True, text=True, env={**os.environ, "LD_TRACE_LOADED_OBJECTS": "1"}
    )
    assert "libopencv_core" in process.stdout
    assert "imgcodecs" not in process.stdout and "videoio" not in process.stdout


def test_a_program_without_its_modules(tmp_path):
    shutil.copy(PROGRAM, tmp_path / "stereo_hls")
    words = [tmp_path / "stereo_hls", "scene", "--config", "tiny", "--seed", "1", "--out", tmp_path / "out"]
    process = subprocess.run(words, capture_output=True, text=True)
    assert process.returncode == 3 and process.stderr.count("\n") == 1
    assert f"{tmp_path}/stereo_hls_images.so cannot be loaded; it belongs beside the program" in process.stderr
    assert not (tmp_path / "out").exists()


def test_configurations_as_json():
    table = json.loads(succeed("configurations", "--json"))
    assert {"ambrosch2007", "tiny"} <= table.keys()
    assert list(table) == sorted(table)
    tiny = table["tiny"]
    assert (tiny["width_px"], tiny["height_px"], tiny["disparities"]) == (WIDTH, HEIGHT, DISPARITIES)
    keys = {
        "width_px",
        "height_px",
        "disparities",
        "pixels_per_clock",
        "disparity_bits",
        "output_width_px",
        "output_height_px",
        "latency_clocks",
        "flush_groups",
        "gap_groups",
    }
    for values in table.values():
        assert keys | {"family", "use", "description", "options"} <= values.keys()
        if values["family"] == "block_matching":
            assert {"window_px", "slice_disparities", "cost_clocks", "winner_group"} <= values.keys()
    for name in ("tiny", "ambrosch2007"):
        assert table[name]["output_width_px"] == table[name]["width_px"] - table[name]["disparities"]
    assert [table[name]["pixels_per_clock"] for name in ("tiny", "tiny_p2", "tiny_p4")] == [1, 2, 4]
    # A row below the image, and of the window that is one column to the right of its centre.
    assert tiny["flush_groups"] == WIDTH and tiny["gap_groups"] == 0
    assert table["tiny_w8_recursive"]["gap_groups"] == 3 * WIDTH, "the rows below the centre of an 8x8 window"


def test_configurations_as_text():
    assert "tiny: 32x12, 8 disparities" in succeed("configurations")


def test_options_as_json():
    table, configurations = (json.loads(succeed(command, "--json")) for command in ("options", "configurations"))
    for row in configurations.values():
        assert table[row["family"]].keys() <= row.keys()
    assert table["block_matching"]["cost"] == {"default": "sad", "words": ["sad", "ssd", "census"]}
    assert table["block_matching"]["window_px"]["low"] == 1 and table["rectification"]["grid_px"]["default"] == 16


def test_options_as_text():
    lines = succeed("options").splitlines()
    assert "block_matching:" in lines and "  cost sad (sad, ssd, census)" in lines
    assert "  cost_clocks 3 (1 ... 3)" in lines and "  window_px 3 (at least 1)" in lines


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


def test_scene_is_determined_by_its_seed(tmp_path):
    def scene(name, seed):
        succeed("scene", "--out", tmp_path / name, "--seed", seed, "--width", 60, "--height", 40, "--disparities", 16)
        return {p.name: p.read_bytes() for p in (tmp_path / name).iterdir()}

    first = scene("a", 1)
    assert sorted(first) == [
        "disparity_left.png",
        "disparity_right.png",
        "left.png",
        "right.png",
        "visible_left.png",
        "visible_right.png",
    ]
    assert png_size(tmp_path / "a" / "left.png") == (60, 40)
    assert scene("b", 1) == first
    assert scene("c", 2)["left.png"] != first["left.png"]


def test_moving_scene_begins_with_the_pair_and_can_be_watched(tmp_path):
    size = ["--seed", 4, "--width", 120, "--height", 60, "--disparities", 16]
    succeed("scene", "--out", tmp_path / "pair", *size)
    moving = tmp_path / "moving"
    assert "7 frames" in succeed("scene", "--out", moving, *size, "--frames", 7)
    kinds = sorted(path.stem for path in (tmp_path / "pair").iterdir())
    assert sorted(path.name for path in moving.iterdir()) == kinds
    for kind in kinds:
        frames = sorted((moving / kind).iterdir())
        assert [path.name for path in frames] == [f"{number:05}.png" for number in range(7)]
        assert frames[0].read_bytes() == (tmp_path / "pair" / f"{kind}.png").read_bytes()
    assert len({path.read_bytes() for path in (moving / "disparity_right").iterdir()}) == 7
    words = ["--left", moving / "left", "--right", moving / "right", "--config", "tiny", "--set", "disparities=16"]
    assert "7 frames" in succeed("video", *words, "--out", tmp_path / "maps")


def test_scene_fits_a_configuration(tmp_path):
    succeed("scene", "--out", tmp_path / "s", "--seed", 3, "--config", "tiny")
    pair = ["--left", tmp_path / "s" / "left.png", "--right", tmp_path / "s" / "right.png"]
    assert "32x12" in succeed("match", "--config", "tiny", "--engine", "clocked", *pair, "--out", tmp_path / "m")


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


def test_unknown_configuration_lists_the_known(tmp_path, match):
    fail(tmp_path, *changed(match, "--config", "nope"), says=["nope", "ambrosch2007", "tiny"])
    fail(tmp_path, "scene", "--out", tmp_path / "s", "--seed", 1, "--config", "nope", says=["nope", "tiny"])


def test_folder_that_cannot_be_created(tmp_path, match):
    (tmp_path / "file").write_text("")
    fail(tmp_path, *changed(match, "--out", tmp_path / "file" / "out"), says=["--out", tmp_path / "file"])
    fail(tmp_path, *changed(match, "--out", tmp_path / "file"), says=["--out", tmp_path / "file"])


def test_names_that_the_system_refuses(tmp_path, match):
    """As in folders without rights, the look at the file itself fails."""
    name = tmp_path / ("x" * 300)
    fail(tmp_path, *changed(match, "--left", name), says=[name, "File name too long"])
    fail(tmp_path, *changed(match, "--out", name), says=["--out", name, "File name too long"])


def fail_to_print(folder, *arguments):
    """Nothing is written either."""
    before = sorted(folder.rglob("*"))
    with open("/dev/full", "w") as full:
        process = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, cwd=folder)
    assert process.returncode == 1
    assert process.stderr == "stereo_hls: internal failure: the result cannot be written to standard output\n"
    assert sorted(folder.rglob("*")) == before


@pytest.mark.parametrize(
    "command", [["configurations"], ["configurations", "--json"], ["scene", "--seed", "1", "--out", "deep/scene"]]
)
def test_a_result_that_does_not_reach_stdout_is_a_failure(tmp_path, command):
    fail_to_print(tmp_path, *command)


def test_results_of_a_pair_that_do_not_reach_stdout_are_a_failure(tmp_path, match, pair):
    fail_to_print(tmp_path, *match)
    truth = ["--truth-right", pair[1], "--border", "0"]
    fail_to_print(tmp_path, "evaluate", *pair, *truth, "--config", "tiny", "--json", "deep/e.json")


@pytest.mark.parametrize("out", ["deep/out", "deep/out.avi"])
def test_a_video_whose_summary_does_not_reach_stdout_is_a_failure(tmp_path, pair, out):
    for camera in ("l", "r"):
        (tmp_path / "cameras" / camera).mkdir(parents=True)
        (tmp_path / f"{camera}.pgm").rename(tmp_path / "cameras" / camera / "0.pgm")
    fail_to_print(tmp_path, "video", "--config", "tiny", "--left", "cameras/l", "--right", "cameras/r", "--out", out)


def test_a_failure_leaves_no_folder_behind(tmp_path, match):
    """Not those above the one that cannot be made either; folders that were there stay."""
    (tmp_path / "there").mkdir()
    fail(
        tmp_path,
        *changed(match, "--out", tmp_path / "there" / "made" / ("x" * 300)),
        says=["--out", "File name too long"],
    )
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    fail(tmp_path, *changed(match, "--out", tmp_path / "link"), says=["--out", tmp_path / "link"])


@pytest.mark.parametrize(
    "arguments, says",
    [
        ([], "subcommand"),
        (["match", "--left", "x"], "--config"),
        (["configurations", "--frobnicate"], "--frobnicate"),
        (["scene", "--out", "o", "--seed", "one"], "--seed"),
        (["scene", "--out", "o", "--seed", "-1"], "--seed"),
        (["scene", "--out", "o", "--seed", "1", "--config", "tiny", "--width", "9"], "--width"),
        (["scene", "--out", "o", "--seed", "1", "--width", "9"], "disparity range"),
        (["scene", "--out", "o", "--seed", "1", "--width", "9", "--frames", "2"], "disparity range"),
        (["scene", "--out", "o", "--seed", "1", "--frames", "0"], "--frames"),
        (["frobnicate"], "frobnicate: unknown command"),
        (["--frobnicate"], "--frobnicate: unknown command"),
    ],
)
def test_wrong_usage(tmp_path, arguments, says):
    fail(tmp_path, *arguments, says=[says])


@pytest.mark.parametrize("option, value", [("--engine", "slow"), ("--fit", "stretch"), ("--fit", "1")])
def test_words_that_are_no_choice(tmp_path, match, option, value):
    fail(tmp_path, *match, option, value, says=[option, value])


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


@pytest.mark.parametrize("seed", ["-1", str(2**64), "9" * 300, "1.5", "0x1"])
def test_seeds_that_would_be_another_number(tmp_path, seed):
    """A message fits a line."""
    words = [PROGRAM, "scene", "--config", "tiny", f"--seed={seed}", "--out", tmp_path / "out"]
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 2 and "not a whole number of 0 ... 18446744073709551615" in result.stderr
    assert not (tmp_path / "out").exists()


def test_an_empty_value_is_refused():
    words = [PROGRAM, "scene", "--config", "tiny", "--seed", "1", "--out="]
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 2 and "--out" in result.stderr, result.stderr


def test_a_pipe_as_image_is_refused(tmp_path):
    os.mkfifo(tmp_path / "left.png")
    words = [PROGRAM, "match", "--config", "tiny", "--left", tmp_path / "left.png", "--right", tmp_path / "left.png"]
    result = subprocess.run([*words, "--out", tmp_path / "out"], capture_output=True, text=True, timeout=20)
    assert result.returncode == 2 and "left.png: is a pipe or a device" in result.stderr
