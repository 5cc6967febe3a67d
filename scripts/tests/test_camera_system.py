# SPDX-License-Identifier: Apache-2.0
"""examples/camera_system: two cameras to depths, against the software pipeline."""

import random
import re

import pytest

from camera_streams import changed, check_all_exact, played
from conftest import need
from cover import with_slow
from flow.base.configurations import option
from flow.base.errors import FlowError
from flow.base.tools import find_stereo_hls, run
from flow.implementation import figures
from flow.rendering import pictures
from flow.system import frame, pipeline, play, record, streams, summary, template
from flow_commands import call, refused

TINY, CHECKED, DEEP, VGA = (template.SYSTEMS[name] for name in ("tiny", "tiny_checked", "tiny_12bit", "vga"))
FOLDED, FOLDED_VGA = (template.SYSTEMS[name] for name in ("tiny_sgm_f8", "vga_sgm_f8"))
DENSE, FOLDED_DENSE, DENSE_VGA = (
    template.SYSTEMS[name] for name in ("tiny_dense", "tiny_sgm_f4_dense", "vga_sgm_f8_dense")
)
STAGE, CORE = pipeline.rows_of(TINY)
WIDTH, HEIGHT = CORE["width_px"], CORE["height_px"]
DEPTHS = pipeline.depth_table(TINY, streams.FOCAL_BASELINE)
LEAST_MHZ = 100
TABLES, DEPTH = template.FOLDER / "camera_tables.vhd", template.FOLDER / "camera_depth.vhd"


@pytest.fixture(scope="module")
def simulation():
    need("ghdl", "GHDL")
    need("verilator", "VERILATOR")
    return play.Verilated(TINY)


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return streams.material(TINY, 5, 12, tmp_path_factory.mktemp("frames"))


@pytest.mark.parametrize("name", template.SYSTEMS)
def test_committed_vhdl_follows_from_the_manifests(name):
    system = template.SYSTEMS[name]
    assert system.path.read_text() == template.text(system)
    assert call("camera_system.py", "--check").returncode == 0


@pytest.mark.parametrize(
    "words, sentence",
    [
        (["--system", "huge"], "unknown system 'huge'"),
        (["--implement"], "--implement, --frame and --streams take one --system"),
        (["--system", "tiny", "--frame"], "--frame is for systems of 640x480; tiny has 32x12"),
        (["--system", "tiny_12bit", "--frame"], "--frame is for pixels of 8 bits; tiny_12bit has 12"),
        (["--system", "tiny", "--streams", "0"], "--streams must be 1 or more"),
        (["--system", "tiny", "--record"], "--record keeps a result of"),
        (["--system", "vga", "--frame", "--record", "--pair", "x"], "--pair goes with --frame, without --record"),
        (
            ["--system", "vga", "--frame", "--pair", "no_such_folder"],
            "no_such_folder/left.png: No such file or directory",
        ),
        (["--system", "vga", "--implement", "--seeds", "0"], "--seeds must be 1 or more"),
        (["--system", "vga", "--frame", "--target", "ecp5"], "--target goes with --implement"),
        (["--system", "vga", "--implement", "--target", "xc7"], "unknown target 'xc7'; known are: ecp5, "),
        (
            ["--system", "vga", "--implement", "--target", "ecp5", "--record"],
            "--record keeps a result of the system's own",
        ),
    ],
)
def test_bad_options_are_refused(words, sentence):
    refused(call("camera_system.py", *words), 2, sentence)


@pytest.mark.parametrize("system", [VGA, FOLDED_VGA, DENSE_VGA], ids=lambda system: system.name)
def test_a_whole_frame_of_vga_is_exact(system):
    """As recorded; of the VHDL that is here, else there is no record."""
    found = record.read(system)
    assert found, f"run scripts/camera_system.py --system {system.name} --frame --record"
    core, seen = pipeline.rows_of(system)[1], found["frame"]
    assert (core["width_px"], core["height_px"], core["disparities"]) == (640, 480, 64)
    assert seen["mismatches"] == 0 and seen["depths"] == core["output_width_px"] * core["output_height_px"]
    assert seen["known"] > seen["depths"] // 2
    assert not template.beside_of(system).filled or seen["known"] + seen["filled"] == seen["depths"], "no holes"
    shown = call("camera_system.py", "--system", system.name, "--show").stdout
    assert f"{seen['latency']['last_clocks'] / pipeline.line_clocks(system):.2f} lines" in shown


@pytest.fixture
def routed_vga():
    found = record.read(VGA) or {}
    how = "scripts/camera_system.py --system vga --implement --seeds 1 2 3 --record"
    if "implementation" not in found:  # takes an hour: not a part of every change of the shell
        pytest.skip(f"SKIP: no place and route of the VHDL that is here is recorded: run {how}")
    return found["implementation"]["ecp5"]


def test_vga_reaches_its_clock(routed_vga):
    assert routed_vga["fmax_mhz"]["median"] >= LEAST_MHZ


def test_the_page_shows_the_clock_of_vga(routed_vga):
    result = routed_vga
    page = " ".join((template.FOLDER / "README.md").read_text().split())
    assert f"{result['fmax_mhz']['median']} MHz" in page and f"{figures.lut_count(result):,} LUT4" in page
    assert not result["memory_in_flip_flops"]


def test_latency_is_shown_at_the_routed_clock(monkeypatch):
    seen = record.Frame(
        command="",
        scene="a scene",
        depths=2,
        known=1,
        mismatches=0,
        clocks=9,
        latency=record.Latency(first_clocks=64, last_clocks=96),
    )
    routed = {"ecp5": {"fmax_mhz": {"median": 32.0}}}
    monkeypatch.setattr(record, "read", lambda system: {"implementation": routed})
    shown = "\n".join(summary.of_frame(TINY, seen))
    assert "64 clocks, 2.00 lines, 2.0 us" in shown and "96 clocks, 3.00 lines, 3.0 us" in shown


@pytest.mark.parametrize("system", [TINY, DEEP, FOLDED, DENSE, FOLDED_DENSE], ids=lambda system: system.name)
def test_500_frames_of_random_streams_are_exact(system):
    """As recorded."""
    found = record.read(system)
    assert found, f"run scripts/camera_system.py --system {system.name} --streams 500 --record"
    assert found["streams"]["frames"] >= 500 and streams.passed(found["streams"])


def test_a_record_of_another_design_does_not_count(monkeypatch, tmp_path):
    monkeypatch.setattr(record, "path", lambda system: tmp_path / "record.json")
    now = record.design(TINY)
    played = {"command": "", "frames": 1, "broken": 0, "exact": 1, "mismatches": 0, "hangs": 0}
    seen = {"command": "", "scene": "", "depths": 1, "known": 1, "mismatches": 0, "clocks": 1}
    seen["latency"] = {"first_clocks": 1, "last_clocks": 1}
    record.keep(TINY, "streams", played, now)
    assert record.read(TINY)["streams"] == played
    monkeypatch.setattr(record, "design", lambda system: now | {"hls/rtl/stereo_axis.vhd": "0"})
    assert record.read(TINY) is None
    with pytest.raises(FlowError, match="changed in the meantime"):
        record.keep(TINY, "frame", seen, now)
    record.keep(TINY, "frame", seen, record.design(TINY))
    assert "streams" not in record.read(TINY)


def test_wrong_depths_are_counted():
    right = [play.Frame(words=[1, 2, 3])]
    assert frame.mismatches(right, [1, 2, 3]) == 0
    assert frame.mismatches(right, [1, 9, 3]) == 1
    assert frame.mismatches(right, [1, 2]) == 2 and frame.mismatches([], [1, 2, 3]) == 3
    assert frame.mismatches(2 * right, [1, 2, 3]) == 3, "a frame too much"
    assert frame.mismatches([play.Frame(words=[1, 2, 3], error=True)], [1, 2, 3]) == 3


def test_depths_are_of_whole_numbers():
    assert DEPTHS == [0, 400, 200, 133, 100, 80, 67, 57]
    assert pipeline.depth_table(TINY, 16 * 70000)[1] == 0, "farther than 16 bits say"
    assert pipeline.depth_table(TINY, 16 * 400, 16)[:3] == [0, 0, 400]


def test_depths_of_subpixel_disparities():
    depths = pipeline.depth_table(CHECKED, streams.FOCAL_BASELINE)
    assert len(depths) == 16 * 8 and depths[16::16] == DEPTHS[1:] and depths[24] == 267


@pytest.mark.parametrize("gaps, skew, sink", [(0, 0, 0), (30, 0, 20), (20, 100, 20), (20, -150, 10)])
def test_every_frame_is_that_of_the_software(simulation, scene, tmp_path, gaps, skew, sink):
    seen = played(simulation, scene, tmp_path, gap_percent=gaps, skew_clocks=skew, sink=sink)
    assert set(seen.responses) == {play.OKAY}
    check_all_exact(seen, scene.frames)


def test_checks_and_subpixel(ghdl, tmp_path):
    """The same behind a core with every check and subpixel."""
    made = streams.material(CHECKED, 6, 4, tmp_path / "frames")
    known = [word >> 16 for words in made.frames for word in words]
    assert 0 < sum(known) < len(known)
    seen = played(play.InGhdl(CHECKED), made, tmp_path, gap_percent=20, skew_clocks=40, sink=20)
    check_all_exact(seen, made.frames)


@pytest.fixture(scope="module")
def deep_scene(tmp_path_factory):
    made = streams.material(DEEP, 6, 6, tmp_path_factory.mktemp("deep"))
    known = [word >> 16 for words in made.frames for word in words]
    assert 0 < sum(known) < len(known)
    assert max(pixel for pair in made.pairs for image in pair for row in image for pixel in row) == 4095
    return made


DEEP_STREAM = {"gap_percent": 20, "skew_clocks": -40, "blanking_clocks": streams.LEAST_BLANKING_CLOCKS, "sink": 10}


def test_pixels_of_12_bits(ghdl, verilator, deep_scene, tmp_path):
    """The same with wider lanes; the bits above the pixels show anything."""
    seen = played(play.Verilated(DEEP), deep_scene, tmp_path, **DEEP_STREAM)
    assert set(seen.responses) == {play.OKAY}
    check_all_exact(seen, deep_scene.frames)
    sent = re.findall(r"^[lr] \d+ (\w+) \d$", (tmp_path / "stream.txt").read_text(), re.MULTILINE)
    assert {len(lane) for lane in sent} == {4} and len({lane[0] for lane in sent}) == 16


def test_broken_streams_of_12_bits_give_no_wrong_frame(ghdl, verilator, deep_scene, tmp_path):
    simulation = play.Verilated(DEEP)
    for seed in range(3):
        verdict = streams.play_broken(simulation, deep_scene, seed, tmp_path / str(seed))
        assert verdict == (streams.FRAMES - streams.BROKEN, 0, 0), f"seed {seed}"


@pytest.mark.parametrize("gap_percent", [0, 20])
def test_cameras_that_pause_too_short_give_no_wrong_frame(ghdl, verilator, deep_scene, tmp_path, gap_percent):
    """Its core needs a gap between frames. Pauses below and above it, and those in which the next frame stands ready
    when it ends; too short ones cost frames, and these say so."""
    assert pipeline.rows_of(DEEP)[1]["gap_groups"] == 64
    simulation, exact = play.Verilated(DEEP), []
    for pause in (0, 32, 64, 96, 128, 160, 192, 224, 256, 288):
        conditions = {"gap_percent": gap_percent, "skew_clocks": -40, "blanking_clocks": pause}
        seen = played(simulation, deep_scene, tmp_path, **conditions)
        verdict = streams.judge(seen, deep_scene.frames, range(len(deep_scene.pairs)))
        assert verdict.mismatches == 0, f"{pause} clocks between frames"
        exact.append(verdict.exact)
    assert exact[-1] == len(deep_scene.pairs)


def test_a_gap_waits_for_the_rectification():
    assert template.gap_groups(128, 0) == 0
    assert template.gap_groups(128, 64) == 128
    assert template.gap_groups(128, 192) == 192


def test_a_rectification_of_other_pixels_is_refused():
    mixed = template.System("mixed", TINY.rectification, DEEP.matching)
    with pytest.raises(FlowError, match="rectify_tiny and tiny_12bit_all differ in pixel_bits: 8 and 12"):
        template.text(mixed)


# Of the system's own text.
DEEP_FAULTS = {
    "the highest bit of a pixel": (r"left_pixel => rectified_left", "left_pixel => '0' & rectified_left(10 downto 0)"),
    "the lowest bit of a pixel": (
        r"right_pixel => rectified_right",
        "right_pixel => rectified_right(11 downto 1) & '0'",
    ),
    "a joiner of 8 bits": (r"pixel_bits => 12", "pixel_bits => 8"),
}


@pytest.mark.parametrize("fault", with_slow(DEEP_FAULTS, ["a joiner of 8 bits"]))
def test_fault_of_pixels_of_12_bits_is_caught(ghdl, deep_scene, tmp_path, fault):
    pattern, replacement = DEEP_FAULTS[fault]
    files = changed(DEEP, DEEP.path, pattern, replacement, tmp_path)
    seen = played(play.InGhdl(DEEP, files), deep_scene, tmp_path, 3, **DEEP_STREAM)
    assert [shown.words for shown in seen.frames] != deep_scene.frames[:3]


def test_a_frame_of_12_bits_in_ghdl(ghdl, deep_scene, tmp_path):
    seen = played(play.InGhdl(DEEP), deep_scene, tmp_path, 2, **DEEP_STREAM)
    check_all_exact(seen, deep_scene.frames[:2])


def test_a_frame_in_ghdl(ghdl, scene, tmp_path):
    """The VHDL as it is, without synthesis before."""
    seen = played(play.InGhdl(TINY), scene, tmp_path, 1, gap_percent=20, skew_clocks=40, sink=20)
    assert set(seen.responses) == {play.OKAY}
    check_all_exact(seen, scene.frames[:1])


@pytest.mark.parametrize("seeds", with_slow([range(4), range(4, 10)], [range(4)]), ids=str)
def test_broken_streams_give_no_wrong_frame(simulation, scene, tmp_path, seeds):
    """Pixels and frames that one camera loses: a frame that does not say error is one of those that came in whole, in
    their order, and after each fault frames are exact again."""
    for seed in seeds:
        verdict = streams.play_broken(simulation, scene, seed, tmp_path / str(seed))
        whole = streams.FRAMES - streams.BROKEN
        assert verdict == (whole, 0, 0), f"seed {seed}: each fault costs its frame only"


def test_the_judge_sees_wrong_missing_and_short_frames():
    words = [[1, 2, 3], [4, 5, 6]]

    def judged(*frames):
        seen = [play.Frame(words=list(given), error=error) for given, error in frames]
        return streams.judge(play.Observation([], seen, ([], []), 0), words, [0, 1])

    assert judged((words[0], False), (words[1], False)) == (2, 0, 0)
    assert judged(([7, 7, 7], True), (words[1], False)) == (1, 0, 0)
    assert judged(([1, 2, 7], False), (words[1], False)) == (1, 1, 0), "a wrong depth"
    assert judged(([1, 2], True), (words[1], False)) == (1, 1, 0), "a frame that does not end"
    assert judged((words[0], False)) == (1, 0, 1), "the last frame is missing"
    assert judged((words[1], False), (words[0], False)) == (1, 1, 1), "the wrong order"
    assert judged() == (0, 0, 1)


def test_a_node_or_depth_outside_the_table_is_refused(simulation, scene, tmp_path):
    columns, rows = option(STAGE, "table_columns"), option(STAGE, "table_rows")
    outside = [
        (play.NODE_PLACE, columns),
        (play.NODE_OFFSETS, 77),
        (play.NODE_PLACE, rows << 16),
        (play.NODE_OFFSETS, 77),
        (play.DEPTH, len(DEPTHS) << 16 | 77),
    ]
    writes = [*play.table_writes(scene.tables, DEPTHS), *outside, (play.NODE_PLACE, 0), (0x1C, 0)]
    seen = simulation.play(writes, *streams.streams(scene.pairs[:2], random.Random(1)), tmp_path)
    assert seen.responses[-7:] == [0, 2, 0, 2, 2, 0, 2] and set(seen.responses[:-7]) == {play.OKAY}
    check_all_exact(seen, scene.frames[:2])


def test_latency(simulation, scene, tmp_path):
    """From a row's last pixel to its depths: the lag of both, and the clocks of the parts."""
    seen = played(simulation, scene, tmp_path, 3)
    found = frame.latency(seen)
    rows = option(STAGE, "lag_rows") + 1  # of the window below the row
    assert (rows - 1) * WIDTH < found["first_clocks"] < (rows + 2) * WIDTH
    assert found["last_clocks"] - found["first_clocks"] == CORE["output_width_px"] - 1


FAULTS = {
    "cameras swapped": (TABLES, r"node_right <= place\(31\);", "node_right <= not place(31);"),
    "offsets swapped": (TABLES, r"node_x <= s_axil_wdata\(15 downto 0\)", "node_x <= s_axil_wdata(31 downto 16)"),
    "a node in the wrong row": (TABLES, r"place\(30 downto 16\);", "place(30 downto 17) & '0';"),
    "unknown pixels in the last column": (
        DEPTH,
        r" known <= pixel_valid\(0\);",
        " known <= pixel_valid(0) and not disparity_end_of_line;",
    ),
    "a depth too late": (DEPTH, r"depth_valid <= valid;", "depth_valid <= disparity_valid;"),
}


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["cameras swapped", "a depth too late"]))
def test_fault_is_caught(ghdl, scene, tmp_path, fault):
    path, pattern, replacement = FAULTS[fault]
    faulty = play.InGhdl(TINY, changed(TINY, path, pattern, replacement, tmp_path))
    try:
        seen = played(faulty, scene, tmp_path, 3)
    except FlowError as error:
        assert "a beat before the first start of frame" in str(error)
        return
    assert [shown.words for shown in seen.frames if not shown.error] != scene.frames[:3]


CALIBRATION = """%YAML:1.0
---
M1: !!opencv-matrix {{rows: 3, cols: 3, dt: d, data: [ 30., 0., 15.5, 0., 30., 5.5, 0., 0., 1. ]}}
D1: !!opencv-matrix {{rows: 1, cols: 5, dt: d, data: [ -0.1, 0., 0., 0., 0. ]}}
M2: !!opencv-matrix {{rows: 3, cols: 3, dt: d, data: [ 30.5, 0., 15.2, 0., 30.5, 5.8, 0., 0., 1. ]}}
D2: !!opencv-matrix {{rows: 1, cols: 5, dt: d, data: [ -0.08, 0., 0., 0., 0. ]}}
R: !!opencv-matrix {{rows: 3, cols: 3, dt: d, data: [ 1., 0., 0., 0., 0.99995, -0.01, 0., 0.01, 0.99995 ]}}
T: !!opencv-matrix {{rows: 3, cols: 1, dt: d, data: [ -0.1, 0., 0. ]}}
""".replace("{{", "{").replace("}}", "}")


def test_calibrated_pair_end_to_end(simulation, tmp_path):
    """Tables and rectified images of `stereo_hls rectify`."""
    (tmp_path / "calibration.yml").write_text(CALIBRATION)
    generator = random.Random(2)
    pair = [streams.random_image(CORE, generator) for _ in range(2)]
    sources = [pipeline.write_pgm(tmp_path / f"{side}.pgm", image) for side, image in zip(("left", "right"), pair)]
    settings = [f"{name}={option(STAGE, name)}" for name in ("grid_px", "rows_above", "rows_below")]
    command = [find_stereo_hls(), "rectify", "--calibration", tmp_path / "calibration.yml", "--out", tmp_path / "made"]
    command += ["--left", sources[0], "--right", sources[1]] + [word for one in settings for word in ("--set", one)]
    run(command)
    tables = [pipeline.read_table(tmp_path / "made" / f"{side}_table.hex", STAGE) for side in ("left", "right")]
    assert any(node != (0, 0) for row in tables[0] for node in row)
    rectified = [tmp_path / "made" / f"{side}.png" for side in ("left", "right")]
    words = pipeline.depth_frame(TINY, *rectified, DEPTHS, tmp_path, pictures.load(rectified[0]).tolist())
    left, right = play.beats(pair[0]), play.beats(pair[1])
    seen = simulation.play(play.table_writes(tables, DEPTHS), left, right, tmp_path / "out")
    check_all_exact(seen, [words])
