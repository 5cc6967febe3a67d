# SPDX-License-Identifier: Apache-2.0
"""The program stereo_hls as its users meet it: files, messages and exit codes. Env STEREO_HLS names the program."""

import json
import os
import random
import subprocess

import pytest

PROGRAM = os.environ.get("STEREO_HLS", "")
WIDTH, HEIGHT, DISPARITIES = 32, 12, 8  # configuration tiny, checked below

pytestmark = pytest.mark.skipif(not PROGRAM, reason="the program stereo_hls is missing: set STEREO_HLS to it")


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def succeed(*arguments):
    result = run(*arguments)
    assert result.returncode == 0, result.stderr
    assert result.stderr == ""
    return result.stdout


def fail(folder, *arguments, says):
    """Exit code 2, one line on stderr with all of `says` in it, nothing written."""
    before = sorted(folder.rglob("*"))
    result = run(*arguments)
    assert result.returncode == 2, result.stderr
    assert result.stderr.count("\n") == 1 and result.stderr.startswith("stereo_hls: "), result.stderr
    for words in says:
        assert str(words) in result.stderr
    assert sorted(folder.rglob("*")) == before


def write_image(path, width=WIDTH, height=HEIGHT, channels=1, maximum=255, seed=1):
    """A random PGM or PPM file."""
    count = width * height * channels * (1 if maximum < 256 else 2)
    kind = b"P5" if channels == 1 else b"P6"
    pixels = random.Random(seed).randbytes(count)
    path.write_bytes(kind + f"\n{width} {height}\n{maximum}\n".encode() + pixels)
    return path


def png_size(path):
    header = path.read_bytes()[:24]
    assert header.startswith(b"\x89PNG")
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")


@pytest.fixture
def pair(tmp_path):
    left, right = write_image(tmp_path / "l.pgm", seed=1), write_image(tmp_path / "r.pgm", seed=2)
    return ["--left", left, "--right", right]


@pytest.fixture
def match(tmp_path, pair):
    return ["match", "--config", "tiny", "--out", tmp_path / "out", *pair]


def changed(arguments, option, value):
    arguments = list(arguments)
    arguments[arguments.index(option) + 1] = value
    return arguments


def test_version():
    assert succeed("--version").strip().count(".") == 2


def test_help_names_the_exit_codes():
    assert "Exit codes: 0 success; 1 internal failure; 2 wrong usage or input" in succeed("--help")


def test_configurations_as_json():
    table = json.loads(succeed("configurations", "--json"))
    assert {"ambrosch2007", "tiny"} <= table.keys()
    assert list(table) == sorted(table)
    tiny = table["tiny"]
    assert (tiny["width_px"], tiny["height_px"], tiny["disparities"]) == (WIDTH, HEIGHT, DISPARITIES)
    keys = {"width_px", "height_px", "disparities", "window_px", "pixels_per_clock", "slice_disparities", "cost_clocks",
            "winner_group", "output_width_px", "output_height_px", "latency_clocks", "memory_bits"}
    for values in table.values():
        assert values.keys() == keys
        assert values["output_width_px"] == values["width_px"] - values["disparities"]
    assert [table[name]["pixels_per_clock"] for name in ("tiny", "tiny_p2", "tiny_p4")] == [1, 2, 4]
    # The right image's delay, and 2 stored rows of both images; 5 of them with 4 rows at once.
    assert tiny["memory_bits"] == DISPARITIES * 8 + 2 * WIDTH * 8 * 2
    assert table["tiny_p4"]["memory_bits"] == DISPARITIES * 8 * 4 + 2 * WIDTH * 8 * 5


def test_configurations_as_text():
    assert "tiny: 32x12, 8 disparities" in succeed("configurations")


@pytest.mark.parametrize("config", ["tiny", "tiny_p2", "tiny_p4"])
def test_match_engines_agree(tmp_path, match, config):
    match = changed(match, "--config", config)
    fast = succeed(*match, "--engine", "fast")
    clocked = succeed(*changed(match, "--out", tmp_path / "clocked"), "--engine", "clocked")
    assert "32x12" in fast and "fast model" in fast and " ms" in fast
    assert "clocked core" in clocked
    for name in ("disparity.png", "disparity_color.png"):
        assert png_size(tmp_path / "out" / name) == (WIDTH - DISPARITIES, HEIGHT)
    pictures = ["disparity.png", "disparity_color.png", "overview.png"]
    for name in pictures:
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "clocked" / name).read_bytes()
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted([*pictures, "match.json"])


def match_facts(tmp_path):
    return json.loads((tmp_path / "out" / "match.json").read_text())


def test_match_writes_its_facts(tmp_path, match, pair):
    succeed(*match)
    facts = match_facts(tmp_path)
    assert facts.pop("milliseconds") >= 0
    assert facts == {
        "format": "stereo-hls match 1", "config": "tiny", "engine": "fast", "left": str(pair[1]), "right": str(pair[3]),
        "fit": "none", "width_px": WIDTH, "height_px": HEIGHT, "disparities": DISPARITIES, "window_px": 3,
        "output_width_px": WIDTH - DISPARITIES, "output_height_px": HEIGHT}


def test_overview_enlarges_small_images_only(tmp_path, match):
    succeed(*match)
    width, height = png_size(tmp_path / "out" / "overview.png")
    assert width > 3 * 7 * WIDTH and 7 * HEIGHT < height < 9 * HEIGHT + 40, "tiny is enlarged seven times"
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 300, 200))
    succeed(*match)
    width, height = png_size(tmp_path / "out" / "overview.png")
    assert 3 * 300 < width < 4 * 300 and 200 < height < 250


@pytest.mark.parametrize("width, height", [(DISPARITIES + 1, 1), (DISPARITIES + 1, 700), (1500, 1)])
def test_overview_of_odd_sizes(tmp_path, match, width, height):
    for option, name in (("--left", "odd_l.pgm"), ("--right", "odd_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, width, height))
    succeed(*match)
    size = png_size(tmp_path / "out" / "overview.png")
    assert size[0] > 3 * width and size[1] > height


def gray_image(path, value, width=WIDTH, height=HEIGHT):
    """A PGM file with value(x, y) at each pixel."""
    pixels = bytes(value(x, y) for y in range(height) for x in range(width))
    path.write_bytes(f"P5\n{width} {height}\n255\n".encode() + pixels)
    return path


def test_match_counts_bad_pixels(tmp_path, match):
    """A pair shifted by 3 has disparity 3 everywhere but where the shift leaves the image."""
    ground = [[random.Random(x * 100 + y).randrange(256) for x in range(WIDTH + 3)] for y in range(HEIGHT)]
    match = changed(match, "--left", gray_image(tmp_path / "l.pgm", lambda x, y: ground[y][x]))
    match = changed(match, "--right", gray_image(tmp_path / "r.pgm", lambda x, y: ground[y][x + 3]))
    # Row 2: off by one, which is allowed; row 3: off by two; row 4: off, but not visible.
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 3 + {2: 1, 3: 2, 4: 2}.get(y, 0))
    visible = gray_image(tmp_path / "v.pgm", lambda x, y: 0 if y == 4 else 255)
    out = succeed(*match, "--truth", truth, "--visible", visible)
    columns = WIDTH - DISPARITIES
    assert f"bad pixels (> 1 px): {columns} of {columns * (HEIGHT - 1)} visible ones (9.09 %)" in out
    assert match_facts(tmp_path)["truth"] == {
        "disparity": str(truth), "visible": str(visible), "tolerance_px": 1, "compared_px": columns * (HEIGHT - 1),
        "bad_px": columns}


def test_match_on_the_generated_scene_is_mostly_right(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    for option, name in (("--left", "left.png"), ("--right", "right.png")):
        match = changed(match, option, tmp_path / "s" / name)
    succeed(*match, "--truth", tmp_path / "s" / "disparity_right.png", "--visible", tmp_path / "s" / "visible_right.png")
    truth = match_facts(tmp_path)["truth"]
    assert 0 < truth["compared_px"] <= (WIDTH - DISPARITIES) * HEIGHT and truth["bad_px"] < 0.1 * truth["compared_px"]


def test_truth_that_does_not_fit(tmp_path, match):
    image = write_image(tmp_path / "t.pgm")
    other = write_image(tmp_path / "other.pgm", WIDTH - 1, HEIGHT)
    fail(tmp_path, *match, "--truth", image, says=["--visible"])
    fail(tmp_path, *match, "--visible", image, says=["--truth"])
    fail(tmp_path, *match, "--truth", other, "--visible", image, says=["--truth", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", image, "--visible", other, says=["--visible", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", tmp_path / "no.png", "--visible", image, says=["no.png", "no such file"])


def test_match_fast_takes_any_size_and_says_so(tmp_path, match):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    assert "50x20, not the 32x12 of tiny" in succeed(*match)
    assert png_size(tmp_path / "out" / "disparity.png") == (50 - DISPARITIES, 20)


@pytest.mark.parametrize("fit, verb", [("crop", "cropped"), ("resize", "resized")])
def test_match_fits_images_and_says_so(tmp_path, match, fit, verb):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    out = succeed(*match, "--engine", "clocked", "--fit", fit)
    assert f"images {verb} from 50x20 to" in out
    assert png_size(tmp_path / "out" / "disparity.png") == (WIDTH - DISPARITIES, HEIGHT)
    fail(tmp_path, *match, "--engine", "clocked", says=["50x20", "32x12", "--fit crop"])


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


def test_colour_is_converted_and_said(tmp_path, match):
    color = write_image(tmp_path / "color.ppm", channels=3)
    assert f"{color}: colour image converted to grey" in succeed(*changed(match, "--left", color))


def test_scene_is_determined_by_its_seed(tmp_path):
    def scene(name, seed):
        succeed("scene", "--out", tmp_path / name, "--seed", seed, "--width", 60, "--height", 40, "--disparities", 16)
        return {p.name: p.read_bytes() for p in (tmp_path / name).iterdir()}

    first = scene("a", 1)
    assert sorted(first) == ["disparity_right.png", "left.png", "right.png", "visible_right.png"]
    assert png_size(tmp_path / "a" / "left.png") == (60, 40)
    assert scene("b", 1) == first
    assert scene("c", 2)["left.png"] != first["left.png"]


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
    clocks, outputs = WIDTH * groups + WIDTH + 1 + latency + 4, 24 * groups
    assert stimulus[0] == f"stereo-hls stimulus 1 config={config} pixels={pixels} clocks={clocks}"
    assert expected[0] == f"stereo-hls expected 2 config={config} pixels={pixels} disparity_bits=8 outputs={outputs} latency={latency}"
    assert len(stimulus) == clocks + 1 and len(expected) == outputs + 1
    assert stimulus[1].startswith("3 ") and len(stimulus[1]) == 3 + 4 * pixels
    assert expected[1].split()[1:4] == ["0", "0", "0"] and expected[1].split()[5] == "1"
    assert expected[-1].split()[1:4] == ["23", str(HEIGHT - pixels), "0"] and expected[-1].split()[5] == "2"
    assert len(expected[-1].split()[4]) == 2 * pixels


def test_vectors_of_several_rows_at_once_hold_the_same(tmp_path, pair):
    def rows_of(lines, pixels, left_to_right):
        """The words of `left_to_right` records a group, taken apart into rows: [y][x]."""
        rows = []
        for start in range(0, len(lines), left_to_right):
            group = lines[start:start + left_to_right]
            rows += [[word[2 * (pixels - 1 - p):][:2] for word in group] for p in range(pixels)]
        return rows

    seen = []
    for config, pixels in (("tiny", 1), ("tiny_p4", 4)):
        stimulus, expected = vectors(tmp_path, pair, config=config)
        image = [line.split() for line in stimulus[1:1 + WIDTH * HEIGHT // pixels]]
        seen.append([rows_of([line[1] for line in image], pixels, WIDTH),
                     rows_of([line[2] for line in image], pixels, WIDTH),
                     rows_of([line.split()[4] for line in expected[1:]], pixels, WIDTH - DISPARITIES)])
    assert seen[0] == seen[1]
    assert seen[0][0] == [[f"{v:02x}" for v in (tmp_path / "l.pgm").read_bytes()[-WIDTH * HEIGHT:][y * WIDTH:][:WIDTH]]
                          for y in range(HEIGHT)]


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
        tmp_path, pair, "--stall-percent", 30, "--seed", 6)


@pytest.mark.parametrize("rows, says", [("0:6", "a multiple of the 4 pixels per clock"), ("0:4", "at least 8 rows")])
def test_vectors_of_rows_that_are_no_groups(tmp_path, pair, rows, says):
    fail(tmp_path, "vectors", "--config", "tiny_p4", *pair, "--out", tmp_path / "v", "--rows", rows, says=[rows, says])


def trace_columns(tmp_path, config):
    succeed("trace", "--config", config, "--clocks", 300, "--out", tmp_path / "t")
    lines = (tmp_path / "t" / "trace.txt").read_text().splitlines()
    assert lines[0] == f"stereo-hls trace 1 config={config} clocks=300" and len(lines) == 302
    rows = [line.split() for line in lines[2:]]
    names = lines[1].split()
    assert len(set(names)) == len(names)
    assert {len(row) for row in rows} == {len(names)}
    return dict(zip(names, zip(*([int(value, 16) for value in row] for row in rows))))


@pytest.mark.parametrize("config, pixels", [("tiny", 1), ("tiny_p2", 2), ("tiny_p4", 4)])
def test_trace_names_what_the_registers_show(tmp_path, config, pixels):
    trace = trace_columns(tmp_path, config)
    lanes = [trace[f"raster_left_{p}"] for p in range(pixels)]
    words = [sum(value << 8 * p for p, value in enumerate(column)) for column in zip(*lanes)]
    assert words[1:] == list(trace["in_left_pixel"][:-1])  # a register shows its input one clock later
    assert trace["raster_right"][1:] == trace["in_right_pixel"][:-1]
    assert trace["slice0shift_right_1"][1:] == trace["rows_right_1"][:-1]
    difference = trace["slice0cost_difference_1_0"]
    left, right = trace["slice0shift_left_1_0"], trace["slice0shift_right_1"]
    assert list(difference[1:]) == [a - b for a, b in zip(left, right)][:-1]
    assert min(difference) < 0 < max(difference)
    # 8 disparities in slices of 3, 3 and 2; two levels of winners.
    for name in ("slice2shift_left_out_0", "slice2winner2_index_0_0", "slice2best_disparity_0",
                 "slice0window_partial_0_1_2", "slice0window_centre_0_valid", "slice0best_tag_end_of_line",
                 "rows_ready_tag_border_column"):
        assert name in trace
    assert not any(name.startswith("slice3") for name in trace)
    assert f"slice2best_cost_{pixels - 1}" in trace and f"slice2best_cost_{pixels}" not in trace


def test_missing_and_unreadable_files(tmp_path, match):
    fail(tmp_path, *changed(match, "--left", tmp_path / "none.png"), says=[tmp_path / "none.png", "no such file"])
    text = tmp_path / "text.png"
    text.write_text("not an image")
    fail(tmp_path, *changed(match, "--right", text), says=[text, "not an image"])
    fail(tmp_path, *changed(match, "--right", tmp_path), says=[tmp_path, "not an image"])


def test_damaged_png(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    damaged = tmp_path / "damaged.png"
    damaged.write_bytes((tmp_path / "s" / "left.png").read_bytes()[:120])
    fail(tmp_path, *changed(match, "--left", damaged), says=[damaged, "not an image"])


def test_sizes_that_differ(tmp_path, match):
    other = write_image(tmp_path / "other.pgm", WIDTH, HEIGHT + 1)
    fail(tmp_path, *changed(match, "--right", other), says=["differ in size", other, "32x13", "32x12"])


def test_sixteen_bit_images(tmp_path, match):
    deep = write_image(tmp_path / "deep.pgm", maximum=65535)
    fail(tmp_path, *changed(match, "--left", deep), says=[deep, "16 bits", "8-bit"])


def test_width_not_above_the_disparity_range(tmp_path, match):
    for option, name in (("--left", "l8.pgm"), ("--right", "r8.pgm")):
        match = changed(match, option, write_image(tmp_path / name, DISPARITIES, HEIGHT))
    fail(tmp_path, *match, says=["l8.pgm", "8 pixels wide", "8 disparities"])


def test_crop_of_images_too_small(tmp_path, match):
    for option, name in (("--left", "ls.pgm"), ("--right", "rs.pgm")):
        match = changed(match, option, write_image(tmp_path / name, WIDTH + 9, HEIGHT - 1))
    fail(tmp_path, *match, "--fit", "crop", says=["--fit crop", "41x11", "32x12"])


def test_unknown_configuration_lists_the_known(tmp_path, match):
    fail(tmp_path, *changed(match, "--config", "nope"), says=["nope", "ambrosch2007", "tiny"])
    fail(tmp_path, "scene", "--out", tmp_path / "s", "--seed", 1, "--config", "nope", says=["nope", "tiny"])


def test_folder_that_cannot_be_created(tmp_path, match):
    (tmp_path / "file").write_text("")
    fail(tmp_path, *changed(match, "--out", tmp_path / "file" / "out"), says=["--out", tmp_path / "file"])
    fail(tmp_path, *changed(match, "--out", tmp_path / "file"), says=["--out", tmp_path / "file"])


def test_file_that_cannot_be_replaced(tmp_path, match):
    (tmp_path / "out" / "disparity_color.png").mkdir(parents=True)
    fail(tmp_path, *match, says=["--out", "disparity_color.png"])


@pytest.mark.parametrize("arguments, says", [
    ([], "subcommand"),
    (["match", "--left", "x"], "--config"),
    (["configurations", "--frobnicate"], "--frobnicate"),
    (["scene", "--out", "o", "--seed", "one"], "--seed"),
    (["scene", "--out", "o", "--seed", "1", "--config", "tiny", "--width", "9"], "--width"),
    (["scene", "--out", "o", "--seed", "1", "--width", "9"], "disparity range"),
    (["frobnicate"], "subcommand"),
])
def test_wrong_usage(tmp_path, arguments, says):
    fail(tmp_path, *arguments, says=[says])


@pytest.mark.parametrize("option, value", [
    ("--engine", "slow"), ("--fit", "stretch"), ("--fit", "1")])
def test_words_that_are_no_choice(tmp_path, match, option, value):
    fail(tmp_path, *match, option, value, says=[option, value])


@pytest.mark.parametrize("option, value", [
    ("--rows", "4"), ("--rows", "a:b"), ("--rows", "4:"), ("--rows", "4:4"), ("--rows", "4:5"), ("--rows", "0:13"),
    ("--frames", "0"), ("--stall-percent", "96"), ("--stall-percent", "-1"), ("--seed", "x")])
def test_vectors_options_out_of_range(tmp_path, pair, option, value):
    fail(tmp_path, "vectors", "--config", "tiny", *pair, "--out", tmp_path / "v", option, value, says=[value])
