# SPDX-License-Identifier: Apache-2.0
"""A camera system around a core of several clocks a pixel pair: cameras send lines faster than it takes them."""

import pytest

from camera_streams import changed, check_all_exact, played
from conftest import need
from cover import with_slow
from flow.system import pipeline, play, record, streams, template
from flow_commands import call

FOLDED, FOLDED_VGA = (template.SYSTEMS[name] for name in ("tiny_sgm_f8", "vga_sgm_f8"))


def test_a_folded_core_serves_cameras_of_30_frames():
    """On a small device of the slowest grade, as recorded; by hand from the sizes of a frame and of its pause."""
    found = record.read(FOLDED_VGA)
    assert found, "run scripts/camera_system.py --system vga_sgm_f8 --implement --seeds 1 2 3 --record"
    result = found["implementation"][FOLDED_VGA.target]
    assert result["device"] == "LFE5U-45F-6BG381" and len(result["seeds"]) == 3 and not result["memory_in_flip_flops"]
    pause = 10880 + 3205 + 2 * 640  # last rows of rectification and matching, two lines
    frames = result["fmax_mhz"]["median"] * 1e6 / 8 / (640 * 480 + pause)
    assert frames >= 30
    shown = call("camera_system.py", "--system", FOLDED_VGA.name, "--show").stdout
    assert f"  {frames:.1f} with a line in 5120 clocks and {8 * pause} clocks" in shown


@pytest.fixture(scope="module")
def folded_scene(tmp_path_factory):
    assert FOLDED.matching == "tiny_sgm_f8_all", "the build makes the cores that tests name"
    made = streams.material(FOLDED, 7, 6, tmp_path_factory.mktemp("folded"))
    known = [word >> 16 for words in made.frames for word in words]
    assert 0 < sum(known) < len(known)
    return made


@pytest.fixture(scope="module")
def folded():
    need("ghdl", "GHDL")
    need("verilator", "VERILATOR")
    return play.Verilated(FOLDED)


# A line at a pixel a clock, then a pause, so that it takes as long as its pairs in the core.
BURSTS = {"line_clocks": pipeline.line_clocks(FOLDED), "blanking_clocks": pipeline.pause_clocks(FOLDED)}


@pytest.mark.parametrize("ahead", [0, 1, -1])
def test_lines_come_faster_than_a_folded_core_takes_them(folded, folded_scene, tmp_path, ahead):
    skew = ahead * FOLDED.skew_lines * pipeline.line_clocks(FOLDED)
    seen = played(folded, folded_scene, tmp_path, skew_clocks=skew, sink=10, **BURSTS)
    check_all_exact(seen, folded_scene.frames)


@pytest.mark.parametrize("seeds", with_slow([range(2), range(2, 10)], [range(2)]), ids=str)
def test_broken_streams_around_a_folded_core_give_no_wrong_frame(folded, folded_scene, tmp_path, seeds):
    for seed in seeds:
        verdict = streams.play_broken(folded, folded_scene, seed, tmp_path / str(seed))
        assert verdict == (streams.FRAMES - streams.BROKEN, 0, 0), f"seed {seed}: each fault costs its frame only"


@pytest.mark.slow
def test_queues_without_room_for_a_burst_lose_frames(ghdl, verilator, folded_scene, tmp_path):
    depth = rf"depth => {(FOLDED.skew_lines + 2) * 40}\b"
    files = changed(FOLDED, FOLDED.path, depth, f"depth => {FOLDED.skew_lines * 40}", tmp_path)
    skew = FOLDED.skew_lines * pipeline.line_clocks(FOLDED)
    seen = played(play.Verilated(FOLDED, files), folded_scene, tmp_path, skew_clocks=skew, **BURSTS)
    assert [shown.words for shown in seen.frames] != folded_scene.frames


@pytest.mark.slow
def test_a_joiner_that_ends_a_frame_too_early_costs_the_next_one(ghdl, verilator, folded_scene, tmp_path):
    """The shell then flushes, and in a folded core that takes longer than the queues hold."""
    joiner = next(file for file in template.vhdl_files(FOLDED) if file.name == "stereo_joiner.vhd")
    simulation = play.Verilated(FOLDED, changed(FOLDED, joiner, " and not ahead;", ";", tmp_path))
    verdicts = [streams.play_broken(simulation, folded_scene, seed, tmp_path / str(seed)) for seed in (9, 11)]
    assert all(verdict.exact < streams.FRAMES - streams.BROKEN for verdict in verdicts)
