# SPDX-License-Identifier: Apache-2.0
"""Camera systems that show confidence, fill and the rectified left image beside each depth."""

import pytest

from camera_streams import changed, check_all_exact, played
from conftest import need
from cover import with_slow
from flow.base.configurations import configuration
from flow.base.errors import FlowError
from flow.implementation import figures
from flow.implementation.targets import TARGETS
from flow.system import beside, implementation, pipeline, play, record, streams, template

DENSE, FOLDED = (template.SYSTEMS[name] for name in ("tiny_dense", "tiny_sgm_f4_dense"))
IMAGE = template.FOLDER / "camera_image.vhd"
PAUSED = {"blanking_clocks": streams.LEAST_BLANKING_CLOCKS}
# A line at a pixel a clock, then a pause, so that it takes as long as its pairs in the core.
BURSTS = {"line_clocks": pipeline.line_clocks(FOLDED), "blanking_clocks": pipeline.pause_clocks(FOLDED)}


def bits(words, low, count):
    return [word >> low & (1 << count) - 1 for word in words]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    assert DENSE.matching == "tiny_dense", "the build makes the cores that tests name"
    made = streams.material(DENSE, 5, 12, tmp_path_factory.mktemp("dense"))
    words = [word for frame in made.frames for word in frame]
    measured, filled = bits(words, 16, 1), bits(words, 17, 1)
    assert min(sum(measured), sum(filled)) > len(words) // 20, "both kinds of pixels are seen"
    assert not any(map(int.__and__, measured, filled))
    sure = bits(words, 24, 8)
    assert len({*sure}) > 20 and not any(sure[at] for at, is_filled in enumerate(filled) if is_filled)
    assert len({*bits(words, 32, 8)}) > 200
    return made


@pytest.fixture(scope="module")
def folded_scene(tmp_path_factory):
    assert FOLDED.matching == "tiny_sgm_f4_dense", "the build makes the cores that tests name"
    return streams.material(FOLDED, 7, 6, tmp_path_factory.mktemp("folded"))


@pytest.fixture(scope="module")
def simulation():
    need("ghdl", "GHDL")
    need("verilator", "VERILATOR")
    return play.Verilated(DENSE)


def test_a_beat_by_hand():
    depths = list(range(1000, 1128))
    found = template.beside_of(DENSE)
    word = 0xC8 << 16 | 37  # confidence 200, disparity 37 sixteenths
    assert found.beat_bits == 40
    assert found.beat(word, 1, depths, 0x5A) == 0x5A << 32 | 200 << 24 | 1 << 16 | 1037
    assert found.beat(1 << 15 | 37, 0, depths, 0x5A) == 0x5A << 32 | 1 << 17 | 1037, (
        "filled: a depth that is not measured"
    )
    assert found.beat(37, 0, depths, 0x5A) == 0x5A << 32, "nothing known but the image"


def test_where_a_map_begins_in_the_image():
    """In full width where the window of 3x3 is inside, else behind the 8 disparities."""
    assert configuration("tiny_dense")["output_first_column"] == 1
    assert configuration("tiny_confidence")["output_first_column"] == 8


@pytest.mark.parametrize("gaps, skew, sink", [(0, 0, 0), (20, 100, 20), (20, -150, 10)])
def test_every_frame_is_that_of_the_software(simulation, scene, tmp_path, gaps, skew, sink):
    seen = played(simulation, scene, tmp_path, gap_percent=gaps, skew_clocks=skew, sink=sink, **PAUSED)
    assert set(seen.responses) == {play.OKAY}
    check_all_exact(seen, scene.frames)


@pytest.mark.parametrize("seeds", with_slow([range(3), range(3, 10)], [range(3)]), ids=str)
def test_broken_streams_give_no_wrong_frame(simulation, scene, tmp_path, seeds):
    for seed in seeds:
        verdict = streams.play_broken(simulation, scene, seed, tmp_path / str(seed))
        assert verdict == (streams.FRAMES - streams.BROKEN, 0, 0), f"seed {seed}: each fault costs its frame only"


@pytest.mark.slow
@pytest.mark.parametrize("ahead", [0, 1, -1])
def test_around_a_folded_core(ghdl, verilator, folded_scene, tmp_path, ahead):
    simulation = play.Verilated(FOLDED)
    skew = ahead * FOLDED.skew_lines * pipeline.line_clocks(FOLDED)
    seen = played(simulation, folded_scene, tmp_path, skew_clocks=skew, sink=10, **BURSTS)
    check_all_exact(seen, folded_scene.frames)
    verdict = streams.play_broken(simulation, folded_scene, ahead + 1, tmp_path / "broken")
    assert verdict == (streams.FRAMES - streams.BROKEN, 0, 0)


def test_a_frame_around_a_folded_core_in_ghdl(ghdl, folded_scene, tmp_path):
    seen = played(play.InGhdl(FOLDED), folded_scene, tmp_path, 1, sink=20, **BURSTS)
    check_all_exact(seen, folded_scene.frames[:1])


# What else may stand beside depths, alone.
OTHERS = {
    "confidence and image": template.System("other", "rectify_tiny", "tiny_confidence", left_image=True),
    "fill": template.System("other", "rectify_tiny", "tiny_fill"),
    "image of 12 bits": template.System("other", "rectify_tiny_12bit", "tiny_12bit_all", left_image=True),
}


@pytest.mark.parametrize("other", with_slow(OTHERS, ["confidence and image"]))
def test_parts_of_it_alone(ghdl, tmp_path, other):
    system = OTHERS[other]
    made = streams.material(system, 3, 2, tmp_path / "frames")
    text = tmp_path / system.path.name
    text.write_text(template.text(system))
    files = [text if path == system.path else path for path in template.vhdl_files(system)]
    seen = played(play.InGhdl(system, files), made, tmp_path, gap_percent=20, skew_clocks=40, sink=20, **PAUSED)
    check_all_exact(seen, made.frames)


def test_an_image_beside_depths_of_the_right_one_is_refused():
    with pytest.raises(FlowError, match="beside depths of a core with the left reference only"):
        template.text(template.System("right", "rectify_tiny", "tiny", left_image=True))


def test_an_image_of_frames_that_a_core_holds_whole_is_refused():
    row = configuration("tiny_dense") | {"groups_to_first_output": 32 * 12}
    with pytest.raises(FlowError, match="the frames are too small for an image beside the depths"):
        beside.kept_pixels(row)


def test_a_system_of_more_ports_than_its_device_has_pins_is_routed_between_registers():
    system = template.SYSTEMS["vga_sgm_f8_dense"]
    found = implementation.target_of(system, system.target)
    assert found.family.few_pins and found.device == TARGETS[system.target].device
    assert not TARGETS[system.target].family.few_pins, "the same device for others"
    assert not implementation.target_of(DENSE, "ecp5").family.few_pins


def test_a_dense_system_serves_cameras_on_a_small_device():
    """As recorded; by hand from the sizes of a frame and of its pause."""
    system = template.SYSTEMS["vga_sgm_f8_dense"]
    found = record.read(system) or {}
    if "implementation" not in found:  # takes an hour: not a part of every change of the shell
        how = f"scripts/camera_system.py --system {system.name} --implement --seeds 1 2 3 --record"
        pytest.skip(f"SKIP: no place and route of the VHDL that is here is recorded: run {how}")
    result = found["implementation"][system.target]
    assert result["device"] == "LFE5U-45F-6BG381" and not result["memory_in_flip_flops"]
    mhz = result["fmax_mhz"]["median"]
    assert mhz * 1e6 / 8 / (640 * 480 + 10880 + 5834 + 2 * 640) >= 30  # last rows of both cores, two lines
    page = " ".join((template.FOLDER / "README.md").read_text().split())
    assert f"{mhz} MHz" in page and f"{figures.lut_count(result):,} LUT4" in page


FAULTS = {
    "an image one pixel late": (IMAGE, r"1 \+ first_column", "first_column"),
    "an image one row early": (IMAGE, r"1 \+ first_column", "1 + first_column + width_px"),
    "an image as narrow as the map": (IMAGE, r"1 \+ width_px - output_width_px", "1"),
    "an image that stands still when a pixel pauses": (
        IMAGE,
        r"if disparity_valid = '1' then",
        "if disparity_valid = '1' and rectified_valid = '1' then",
    ),
    "an image of too few pixels": (DENSE.path, r"kept => 237", "kept => 236"),
    "the right image": (DENSE.path, r"rectified_pixel => rectified_left", "rectified_pixel => rectified_right"),
    "the confidence of the neighbour": (DENSE.path, r"image_pixel & depth_marks", "image_pixel & marks"),
    "a confidence without its lowest bit": (
        DENSE.path,
        r"word_tdata\(24 downto 17\)",
        "word_tdata(24 downto 18) & '0'",
    ),
    "filled pixels without a depth": (DENSE.path, r" or disparity\(15\)", ""),
    "filled pixels as measured ones": (DENSE.path, r" and not depth_marks\(0\)", ""),
    "measured pixels as filled ones": (DENSE.path, r"word_tdata\(16 downto 16\)", "word_tdata(33 downto 33)"),
}


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["an image one pixel late", "the confidence of the neighbour"]))
def test_fault_is_caught(ghdl, scene, tmp_path, fault):
    faulty = play.InGhdl(DENSE, changed(DENSE, *FAULTS[fault], tmp_path))
    seen = played(faulty, scene, tmp_path, 3, gap_percent=20, sink=10, **PAUSED)
    assert [shown.error for shown in seen.frames] == [False] * 3
    assert [shown.words for shown in seen.frames] != scene.frames[:3]


def test_an_image_of_the_wrong_row_after_a_broken_frame_is_caught(ghdl, verilator, scene, tmp_path):
    """A map that begins as many pixels behind the one before it as the shell flushes between whole frames."""
    flushed = (302 + 3) % 237  # groups of both cores, and three columns beside the map; modulo what is kept
    kept_on = f"""if disparity_start_of_frame = '1' and line_ended = '1' then
          shown <= later(shown, {flushed});
        elsif disparity_start_of_frame = '1' then"""
    files = changed(DENSE, IMAGE, r"if disparity_start_of_frame = '1' then", kept_on, tmp_path)
    faulty = play.Verilated(DENSE, files)
    check_all_exact(played(faulty, scene, tmp_path / "whole", **PAUSED), scene.frames)
    verdict = streams.play_broken(faulty, scene, 0, tmp_path / "broken")
    assert verdict.mismatches and verdict.exact < streams.FRAMES - streams.BROKEN
