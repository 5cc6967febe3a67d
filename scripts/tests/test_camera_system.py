# SPDX-License-Identifier: Apache-2.0
"""examples/camera_system: two cameras to depths, against the software pipeline."""

import random
import re

import pytest

from conftest import need
from flow.base.configurations import option
from flow.base.errors import FlowError
from flow.base.tools import find_stereo_hls, run
from flow.system import pipeline, play, template
from flow_commands import call, refused

TINY = template.SYSTEMS["tiny"]
STAGE, CORE = pipeline.rows_of(TINY)
WIDTH, HEIGHT = CORE["width_px"], CORE["height_px"]
DEPTHS = pipeline.depth_table(16 * 400)
TABLES, DEPTH = template.FOLDER / "camera_tables.vhd", template.FOLDER / "camera_depth.vhd"


def random_table(generator, reach):
    columns, rows = option(STAGE, "table_columns"), option(STAGE, "table_rows")
    return [
        [pipeline.Node(generator.randint(-reach, reach), generator.randint(-reach, reach)) for _ in range(columns)]
        for _ in range(rows)
    ]


def random_image(generator):
    return [[generator.randrange(256) for _ in range(WIDTH)] for _ in range(HEIGHT)]


def expected(pair, tables, folder):
    folder.mkdir(parents=True)
    paths = [
        pipeline.write_pgm(folder / f"{side}.pgm", pipeline.rectified(image, table, STAGE))
        for side, image, table in zip(("left", "right"), pair, tables)
    ]
    return pipeline.depth_frame(TINY, *paths, DEPTHS, folder)


@pytest.fixture(scope="module")
def simulation():
    need("ghdl", "GHDL")
    need("verilator", "VERILATOR")
    return play.Verilated(TINY)


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    """Tables, pairs, and the frames that must come of them."""
    generator, folder = random.Random(5), tmp_path_factory.mktemp("frames")
    tables = [random_table(generator, 160), random_table(generator, 160)]
    pairs = [(random_image(generator), random_image(generator)) for _ in range(12)]
    return tables, pairs, [expected(pair, tables, folder / str(at)) for at, pair in enumerate(pairs)]


def streams(pairs, generator, gap_percent=0, skew_clocks=0, blanking_clocks=0):
    """Both cameras' beats; the same gaps, more before each frame, and the right one some clocks later."""
    left, right = [], []
    for pair in pairs:
        gaps = [generator.randrange(4) if generator.randrange(100) < gap_percent else 0 for _ in range(WIDTH * HEIGHT)]
        gaps[0] += blanking_clocks
        for stream, image in ((left, pair[0]), (right, pair[1])):
            stream += [beat._replace(gap=gap) for beat, gap in zip(play.beats(image), gaps)]
    late = right if skew_clocks > 0 else left
    late[0] = late[0]._replace(gap=late[0].gap + abs(skew_clocks))
    return left, right


def lose(stream, at, count):
    """Beats that a camera does not send; those behind them come when they would have come."""
    clocks = sum(beat.gap + 1 for beat in stream[at : at + count])
    del stream[at : at + count]
    stream[at] = stream[at]._replace(gap=stream[at].gap + clocks)


def check_all_exact(seen, frames):
    assert [frame.error for frame in seen.frames] == [False] * len(frames)
    for number, (frame, words) in enumerate(zip(seen.frames, frames)):
        assert frame.words == words, f"frame {number}"


@pytest.mark.parametrize("name", template.SYSTEMS)
def test_committed_vhdl_follows_from_the_manifests(name):
    system = template.SYSTEMS[name]
    assert system.path.read_text() == template.text(system)
    assert call("camera_system.py", "--check").returncode == 0


def test_bad_names_are_refused():
    refused(call("camera_system.py", "--system", "huge"), 2, "unknown system 'huge'")


def test_depths_are_of_whole_numbers():
    assert DEPTHS[:4] == [0, 400, 200, 133] and DEPTHS[255] == 2
    assert pipeline.depth_table(16 * 70000)[1] == 0, "farther than 16 bits say"
    assert pipeline.depth_table(16 * 400, 16)[:3] == [0, 0, 400]


@pytest.mark.parametrize("gaps, skew, sink", [(0, 0, 0), (30, 0, 20), (20, 100, 20), (20, -150, 10)])
def test_every_frame_is_that_of_the_software(simulation, scene, tmp_path, gaps, skew, sink):
    tables, pairs, frames = scene
    left, right = streams(pairs, random.Random(1), gaps, skew)
    seen = simulation.play(play.table_writes(tables, DEPTHS), left, right, tmp_path, (sink, 3))
    assert set(seen.responses) == {play.OKAY}
    check_all_exact(seen, frames)


def test_broken_streams_give_no_wrong_frame(simulation, scene, tmp_path):
    """Pixels and frames that one camera loses: a frame that does not say error is one of those that came in whole, in
    their order, and after each fault frames are exact again."""
    tables, pairs, frames = scene
    exact = 0
    for seed in range(10):
        generator = random.Random(seed)
        order = [generator.randrange(len(pairs)) for _ in range(12)]
        left, right = streams([pairs[number] for number in order], generator, 20, generator.randrange(-100, 100), 400)
        for frame in sorted(generator.sample((1, 4, 7), 2), reverse=True):  # never on both sides of one frame
            count = generator.choice((1, WIDTH, WIDTH * HEIGHT))
            at = frame * WIDTH * HEIGHT + generator.randrange(WIDTH * HEIGHT - count + 1)  # of this frame only
            lose(generator.choice((left, right)), at, count)
        seen = simulation.play(play.table_writes(tables, DEPTHS), left, right, tmp_path / str(seed), (10, seed))
        at = 0
        for frame in seen.frames:
            assert len(frame.words) == len(frames[0]), "a frame that begins has all its beats"
            if frame.error:
                continue
            while at < len(order) and frames[order[at]] != frame.words:
                at += 1
            assert at < len(order), f"seed {seed}: a frame that was not sent"
            at, exact = at + 1, exact + 1
        assert frames[order[-1]] == seen.frames[-1].words and not seen.frames[-1].error
    print(exact, "frames exact of", 10 * 12)
    assert exact == 10 * (12 - 2), "each fault costs its frame only"


def test_a_node_outside_the_table_is_refused(simulation, scene, tmp_path):
    tables, pairs, frames = scene
    columns, rows = option(STAGE, "table_columns"), option(STAGE, "table_rows")
    outside = [
        (play.NODE_PLACE, columns),
        (play.NODE_OFFSETS, 77),
        (play.NODE_PLACE, rows << 16),
        (play.NODE_OFFSETS, 77),
    ]
    writes = [*play.table_writes(tables, DEPTHS), *outside, (0x1C, 0)]
    seen = simulation.play(writes, *streams(pairs[:2], random.Random(1)), tmp_path)
    assert seen.responses[-5:] == [0, 2, 0, 2, 2] and set(seen.responses[:-5]) == {play.OKAY}
    check_all_exact(seen, frames[:2])


def test_latency(simulation, scene, tmp_path):
    """From a row's last pixel to its first depth: the lag of both, and the clocks of the parts."""
    tables, pairs, _ = scene
    seen = simulation.play(play.table_writes(tables, DEPTHS), *streams(pairs[:3], random.Random(1)), tmp_path)
    clocks = seen.frames[1].line_starts[2] - seen.line_ends[1][HEIGHT + 2]
    rows = option(STAGE, "lag_rows") + 1  # of the window below the row
    assert (rows - 1) * WIDTH < clocks < (rows + 3) * WIDTH


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


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_is_caught(verilator, scene, tmp_path, fault):
    path, pattern, replacement = FAULTS[fault]
    text, count = re.subn(pattern, replacement, path.read_text())
    assert count == 1
    (tmp_path / path.name).write_text(text)
    files = [tmp_path / path.name if file == path else file for file in template.vhdl_files(TINY)]
    tables, pairs, frames = scene
    faulty = play.Verilated(TINY, files)
    try:
        seen = faulty.play(play.table_writes(tables, DEPTHS), *streams(pairs[:3], random.Random(1)), tmp_path)
    except FlowError as error:
        assert "a beat before the first start of frame" in str(error)
        return
    assert [frame.words for frame in seen.frames if not frame.error] != frames[:3]


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
    pair = [random_image(generator), random_image(generator)]
    sources = [pipeline.write_pgm(tmp_path / f"{side}.pgm", image) for side, image in zip(("left", "right"), pair)]
    settings = [f"{name}={option(STAGE, name)}" for name in ("grid_px", "rows_above", "rows_below")]
    command = [find_stereo_hls(), "rectify", "--calibration", tmp_path / "calibration.yml", "--out", tmp_path / "made"]
    command += ["--left", sources[0], "--right", sources[1]] + [word for one in settings for word in ("--set", one)]
    run(command)
    tables = [pipeline.read_table(tmp_path / "made" / f"{side}_table.hex", STAGE) for side in ("left", "right")]
    assert any(node != (0, 0) for row in tables[0] for node in row)
    words = pipeline.depth_frame(
        TINY, tmp_path / "made" / "left.png", tmp_path / "made" / "right.png", DEPTHS, tmp_path
    )
    left, right = play.beats(pair[0]), play.beats(pair[1])
    seen = simulation.play(play.table_writes(tables, DEPTHS), left, right, tmp_path / "out")
    check_all_exact(seen, [words])
