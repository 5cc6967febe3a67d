# SPDX-License-Identifier: Apache-2.0
"""stereo_joiner: two cameras of any distance that lose pixels, lines and frames. Every frame that both send whole comes
out whole and exact, and pixels of different frames never meet."""

import random

import pytest

from conftest import need
from cover import with_slow
from joiner_bench import (
    CAMERA_BIT,
    FRAMES,
    HEIGHT,
    PIXEL_BITS,
    WIDTH,
    Joiner,
    frame_of,
    judge,
    place_of,
    streams,
    whole_frames,
)


@pytest.fixture(scope="module", params=with_slow(PIXEL_BITS, PIXEL_BITS[:1]))
def joiner(tmp_path_factory, request):
    need("ghdl", "GHDL")
    return Joiner(tmp_path_factory.mktemp("joiner"), request.param)


LINE = WIDTH + 6  # clocks
# Bits of `faults`.
LEFT_DROPS, RIGHT_DROPS, DIFFERS = 1, 2, 4


@pytest.mark.parametrize("distance", [0, 1, -1, LINE, -2 * LINE - 5, 3 * LINE + 7, -3 * LINE])
def test_whole_frames_of_any_distance(joiner, distance):
    rng = random.Random(distance)
    cameras, records = streams(rng, distance, 0)
    seen = joiner.play(records, rng)
    assert judge(seen, cameras) is None
    assert len(seen.pairs) == FRAMES * WIDTH * HEIGHT and not seen.faults
    # The later camera's start leaves a few clocks after it came, which may see one more end of line.
    lines = {skew for _, _, flags, skew in seen.pairs[1:]}
    assert len(lines) == 1 and abs(lines.pop() - distance / LINE) < 1.5


@pytest.mark.parametrize("number", with_slow(range(12), [0, 4, 5]))
def test_damaged_frames(joiner, number, record_property):
    seed = random.SystemRandom().randrange(1 << 32) if number < 4 else number  # a few new ones in every run
    print(f"seed {seed}")
    rng = random.Random(seed)
    distance = rng.randrange(-3 * LINE, 3 * LINE)
    cameras, records = streams(rng, distance, 40)
    seen = joiner.play(records, rng, sink_percent=rng.choice([100, 95, 85]))
    assert judge(seen, cameras) is None, f"seed {seed}"
    assert len(whole_frames(cameras)) >= FRAMES // 3
    assert seen.faults


@pytest.fixture(scope="module")
def netlist(tmp_path_factory, joiner):
    return Joiner(tmp_path_factory.mktemp("netlist"), joiner.pixel_bits, netlist=True)


@pytest.mark.parametrize("seed", with_slow(range(4), [0]))
def test_the_netlist_does_the_same(joiner, netlist, seed):
    """Implementations, and simulators of Verilog, take what GHDL's synthesis makes."""
    assert differing_play(joiner, netlist, seed) is None


def differing_play(joiner, other, seed):
    """None, or what both show of damaged frames."""
    rng = random.Random(seed)
    _, records = streams(rng, rng.randrange(-3 * LINE, 3 * LINE), 40)
    seen = [one.play(records, random.Random(seed), sink_percent=90) for one in (joiner, other)]
    assert seen[0].pairs and seen[0].faults
    return None if seen[0] == seen[1] else seen


def test_a_netlist_that_lost_conditions_is_found(joiner, tmp_path):
    """What GHDL 2.0 makes of an increment that an assignment of the signal to itself takes back."""
    changes = {
        "if takes and not gives_up then": "if takes then",
        "elsif not gives_up then": "elsif behind < depth - 1 then",
        "          writes <= '0';\n": "          writes <= '0';\n          write_address <= write_address;\n",
    }
    of_queue = [("camera_queue", *change) for change in changes.items()]
    broken = Joiner(tmp_path, joiner.pixel_bits, *of_queue, netlist=True)
    assert any(differing_play(joiner, broken, seed) for seed in range(4))


def test_a_sink_that_waits_too_long_costs_frames_not_order(joiner):
    rng = random.Random(5)
    cameras, records = streams(rng, LINE, 0)
    seen = joiner.play(records, rng, sink_percent=30)
    assert any(int(bits, 2) & 3 for bits in seen.faults)
    for left, right, _, _ in seen.pairs:
        assert left == right % (1 << CAMERA_BIT)


def test_cameras_too_far_apart_are_reported(joiner):
    rng = random.Random(6)
    cameras, records = streams(rng, 4 * LINE, 0)
    seen = joiner.play(records, rng, depth=3 * WIDTH)
    assert not seen.pairs
    assert sum(int(bits, 2) & 1 for bits in seen.faults) >= FRAMES - 1


def test_a_reset_begins_anew(joiner):
    rng = random.Random(7)
    cameras, records = streams(rng, 10, 0)
    at = 3 * len(cameras[0][0].pixels) + 50
    seen = joiner.play(records, rng, reset_at=at)
    cameras[0][3].damage = "reset"
    assert judge(seen, cameras) is None
    assert not any(left == right == 0 for left, right, _, _ in seen.pairs), "no pair ends the frame behind the reset"


def test_a_reset_forgets_a_broken_frame(joiner):
    """Whose last pair waits for a sink that was never ready."""
    _, records = streams(random.Random(7), 10, 0)
    behind = max(map(len, records)) + 50
    assert any(left == right == 0 for left, right, _, _ in joiner.play(records, random.Random(7), sink_percent=0).pairs)
    assert not joiner.play(records, random.Random(7), sink_percent=0, reset_at=behind).pairs


def wrong_skew(joiner):
    """None, or a frame whose pairs do not show its own skew. The right camera is two lines behind the left one in each
    second frame. At each end of frame the sink waits until the next start has come, earlier or later, so that it keeps
    the last pairs."""
    blank, more = 80, 2 * LINE
    _, records = streams(random.Random(12), 0, 0, frame_blank=blank)
    starts = [next(i for i, one in enumerate(records[1]) if one and one[0] == frame) for frame in range(FRAMES)]
    waits = set()
    for frame, start in enumerate(starts):
        end = start + (HEIGHT - 1) * LINE + WIDTH
        if frame % 2:
            records[1][start : end + more] = [None] * more + records[1][start:end]
            end += more
        if frame + 1 < FRAMES:
            waits |= set(range(end - 4 + frame // 2 % 12, starts[frame + 1] + more + 16))
    seen = joiner.play(records, random.Random(13), waits=waits)
    assert len(seen.pairs) == FRAMES * WIDTH * HEIGHT and not seen.faults
    for frame in range(FRAMES):
        # The first pair may leave before its skew is known, the last two behind the next start.
        pairs = [pair for pair in seen.pairs if frame_of(pair[0]) == frame][1:-2]
        if {skew for _, _, _, skew in pairs} != {2 * (frame % 2)}:
            return frame
    return None


def test_a_frame_that_waits_does_not_show_its_skew(joiner):
    assert wrong_skew(joiner) is None


def test_a_skew_that_is_shown_too_soon_is_found(ghdl, tmp_path):
    early = ("stereo_joiner", "began <= joins and room and starts;", "began <= joins and starts;")
    assert wrong_skew(Joiner(tmp_path, 8, early)) is not None


def bits_of(seen):
    return {int(bits, 2) for bits in seen.faults}


@pytest.mark.parametrize("dead, bit", [(1, LEFT_DROPS), (0, RIGHT_DROPS)])
def test_a_dead_camera(joiner, dead, bit):
    """The other one fills its queue, and its bit says so; nothing leaves."""
    rng = random.Random(8)
    _, records = streams(rng, 0, 0)
    records[dead] = []
    seen = joiner.play(records, rng)
    assert not seen.pairs and bits_of(seen) == {bit}
    assert len(seen.faults) == FRAMES, "once a frame"


@pytest.mark.parametrize("camera", [0, 1])
def test_a_line_that_one_camera_lost(joiner, camera):
    """The cameras differ, in one frame, and nobody has dropped anything."""
    rng = random.Random(9)
    cameras, records = streams(rng, 0, 0)
    at = next(i for i, record in enumerate(records[camera]) if record and record[:3] == (5, 4, 0))
    records[camera][at : at + WIDTH] = [None] * WIDTH
    cameras[camera][5].damage = "line"
    seen = joiner.play(records, rng)
    assert judge(seen, cameras) is None
    assert seen.faults == ["100"]


# {what both cameras lose: (pairs that are left, whether the joiner ends the frame)} Whether a line is too short or too
# long, the shell behind it says.
ALIKE = {
    "frame": (0, False),
    "line": (WIDTH * (HEIGHT - 1), True),
    "last lines": (WIDTH * (HEIGHT - 2), True),
    "all but the first lines": (WIDTH * 2, True),
    "pixel": (WIDTH * HEIGHT - 1, False),
}


def lost_alike(damage):
    """The records of both cameras, of which frame 5 lacks the same on both sides."""
    cameras, records = streams(random.Random(10), LINE + 3, 0)
    lost = {
        "frame": lambda row, column: True,
        "line": lambda row, column: row == 4,
        "last lines": lambda row, column: row >= HEIGHT - 2,
        "all but the first lines": lambda row, column: row > 1,
        "pixel": lambda row, column: (row, column) == (4, 7),
    }[damage]
    for record in records:
        record[:] = [None if one and one[0] == 5 and lost(*one[1:3]) else one for one in record]
    return cameras, records


def judge_alike(seen, damage):
    """What is wrong with the pairs around a frame that both cameras damaged alike."""
    pairs, is_ended = ALIKE[damage]
    counts, endings, last = dict.fromkeys(range(FRAMES), 0), [], None
    for left, right, _, _ in seen.pairs:
        if left == right == 0:
            endings.append(last)
            continue
        if frame_of(left) != frame_of(right) or place_of(left) != place_of(right):
            return "pixels of different places meet"
        last = frame_of(left)
        counts[last] += 1
    if counts != {number: pairs if number == 5 else WIDTH * HEIGHT for number in range(FRAMES)}:
        return f"frame 5 has {counts[5]} pairs"
    if endings != [5] * is_ended:
        return f"ended as broken: {endings}"
    return None


@pytest.mark.parametrize("damage", ALIKE)
def test_frames_that_both_cameras_damage_alike(joiner, damage):
    cameras, records = lost_alike(damage)
    seen = joiner.play(records, random.Random(11), sink_percent=90)
    assert judge_alike(seen, damage) is None
    assert seen.faults == (["100"] if ALIKE[damage][1] else [])


BIT_FAULTS = {
    "the drop bits are exchanged": ("stereo_joiner", "right_drops & left_drops;", "left_drops & right_drops;"),
    "a broken frame that both sent alike is not ended": (
        "stereo_joiner",
        "cuts <= same and starts and joined and incomplete;",
        "cuts <= '0';",
    ),
}


@pytest.mark.parametrize("fault", BIT_FAULTS)
def test_fault_of_a_bit_is_found(ghdl, tmp_path, fault):
    broken = Joiner(tmp_path, 8, BIT_FAULTS[fault])
    rng = random.Random(8)
    _, records = streams(rng, 0, 0)
    records[1] = []
    wrong_bits = bits_of(broken.play(records, rng)) != {LEFT_DROPS}
    wrong_end = judge_alike(broken.play(lost_alike("line")[1], random.Random(11)), "line") is not None
    assert wrong_bits or wrong_end


FAULTS = {
    "a broken frame is not ended": ("stereo_joiner", "breaks or (joined and incomplete)", "'0'"),
    "a broken frame is ended by what may belong to it": (
        "stereo_joiner",
        "'0' when column = width_px - 1",
        "'1' when false",
    ),
    "a whole frame is ended as a broken one": ("stereo_joiner", "incomplete <= '0';", "incomplete <= '1';"),
    "frames are joined without their start": (
        "stereo_joiner",
        "alike <= starts when left_start = '1' or right_start = '1' else joined;",
        "alike <= '1';",
    ),
    "lines are joined by their pixels only": ("stereo_joiner", "not (left_end xor right_end)", "'1'"),
    "a lost frame is not noticed": ("camera_queue", "full := takes and stored >= depth - 1;", "full := false;"),
    "a start of frame is dropped with the frame before": (
        "camera_queue",
        "elsif not gives_up then",
        "elsif false then",
    ),
    "a start of frame that finds no room is dropped": (
        "camera_queue",
        "stored <= 0;\n        elsif",
        "accepts <= '0';\n        elsif",
    ),
    "what is kept is a word less": ("camera_queue", "stored <= behind;", "stored <= behind - 1;"),
    "what waits is forgotten by half": ("camera_queue", "reset => empties", "reset => reset"),
    "a word is read before it is written": ("camera_queue", "if writes = '1' and not reads", "if takes and not reads"),
    "too many words are read ahead": ("camera_queue", "in_flight < ahead", "true"),
    "the highest bit of a pixel is lost": ("camera_queue", "<= shown(pixel_bits - 1", "<= '0' & shown(pixel_bits - 2"),
    "pixels are swapped": ("stereo_joiner", "right_pixel & left_pixel", "left_pixel & right_pixel"),
}


# Of the pixels, of joined frames, of the queue.
FAST = ["pixels are swapped", "frames are joined without their start", "too many words are read ahead"]


CASES = [(bits, fault) for bits in PIXEL_BITS for fault in FAULTS]


@pytest.mark.parametrize("pixel_bits, fault", with_slow(CASES, [(PIXEL_BITS[0], fault) for fault in FAST]))
def test_fault_is_found(ghdl, tmp_path, pixel_bits, fault):
    broken = Joiner(tmp_path, pixel_bits, FAULTS[fault])
    for seed in range(40):
        rng = random.Random(seed)
        cameras, records = streams(rng, rng.randrange(-3 * LINE, 3 * LINE), 40)
        try:
            if judge(broken.play(records, rng, sink_percent=rng.choice([100, 95, 85])), cameras) is not None:
                return
        except Exception:  # the simulation stopped
            return
    pytest.fail("not found")
