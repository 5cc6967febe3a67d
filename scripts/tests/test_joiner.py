# SPDX-License-Identifier: Apache-2.0
"""stereo_joiner in GHDL: two cameras of any distance that lose pixels, lines and frames. Every frame that both send
whole comes out whole and exact, and pixels of different frames never meet.

A number says where a pixel belongs; it has more bits than the joiner's pixels. So each stream is played once for each
part of the number, with the part as pixel, and the runs must agree in all but the pixels."""

import random
import re
from dataclasses import dataclass, field

import pytest

from conftest import need
from cover import with_slow
from flow.base import ghdl, rtl
from flow.base.tools import ROOT, find_ghdl, run
from flow.shell import template

FILES = ["line_memory", "stream_fifo", "stream_register", "camera_queue", "stereo_joiner"]
BENCH = ROOT / "hls_tb" / "shell" / "tb_stereo_joiner.vhd"
WIDTH, HEIGHT, FRAMES, DEPTH = 12, 9, 40, 64  # a frame is more than DEPTH pixels and the distance of the cameras
SIZE = {"width_px": WIDTH, "height_px": HEIGHT}
DAMAGES = ("frame", "line", "pixel", "start", "end of line", "last lines", "all but the first lines")
START, END = 1, 2
PLACE_BITS = 4  # of a row or a column
CAMERA_BIT = 6 + 2 * PLACE_BITS  # 1: the right camera
CODE_BITS = CAMERA_BIT + 1
PIXEL_BITS = [8, 12]


def code(frame, row, column):
    """Of CODE_BITS. It is never 0, as those of a pair that ends a broken frame."""
    return (frame + 1) << 2 * PLACE_BITS | place(row, column)


def place(row, column):
    return row << PLACE_BITS | column


def frame_of(number):
    return (number % (1 << CAMERA_BIT) >> 2 * PLACE_BITS) - 1


def place_of(number):
    return number % (1 << 2 * PLACE_BITS)


def row_of(number):
    return place_of(number) >> PLACE_BITS


def column_of(number):
    return number % (1 << PLACE_BITS)


@dataclass
class Frame:
    """What a camera sends of a frame: (row, column, START | END) of each pixel, None for the rest between lines."""

    number: int
    damage: str | None
    pixels: list = field(default_factory=list)


def camera_frame(number, damage, keeps_start, line_blank, frame_blank, rng):
    frame = Frame(number, damage)
    lost_row, lost_column = rng.randrange(1 if keeps_start else 0, HEIGHT), rng.randrange(WIDTH)
    for row in range(HEIGHT):
        for column in range(WIDTH):
            flags = (START if row == column == 0 else 0) | (END if column == WIDTH - 1 else 0)
            lost = {
                "frame": True,
                "line": row == lost_row,
                "pixel": (row, column) == (lost_row, lost_column),
                "last lines": row > lost_row,
                "all but the first lines": row > 1,
            }.get(damage, False)
            if damage == "start":
                flags &= ~START
            if damage == "end of line" and row == lost_row:
                flags &= ~END
            frame.pixels.append(None if lost else (row, column, flags))
        frame.pixels += [None] * line_blank
    frame.pixels += [None] * frame_blank
    return frame


def streams(rng, distance, damage_percent, line_blank=6, frame_blank=30):
    """Of both cameras: the frames, and a record a clock. No frame is damaged on both sides, and none without its start
    follows a damaged one: nobody could tell its pixels from those that the one before it lacks."""
    cameras = ([], [])
    for number in range(FRAMES):
        damages = [None, None]
        if rng.random() * 100 < damage_percent and 0 < number < FRAMES - 1:
            damages[rng.randrange(2)] = rng.choice(DAMAGES)
        for frames, damage in zip(cameras, damages):
            keeps_start = bool(frames) and frames[-1].damage is not None
            if keeps_start and damage == "start":
                damage = "frame"
            frames.append(camera_frame(number, damage, keeps_start, line_blank, frame_blank, rng))
    records = []
    for frames, late in zip(cameras, (max(0, -distance), max(0, distance))):
        record = [None] * late
        for frame in frames:
            record += [pixel and (frame.number, *pixel) for pixel in frame.pixels]
        records.append(record)
    return cameras, records


@dataclass
class Seen:
    pairs: list = field(default_factory=list)  # (left, right, START | END, skew in lines)
    faults: list = field(default_factory=list)  # bits


def word_of(record, rng, camera):
    """(flags, code); garbage while nothing is valid."""
    if record is None:
        return rng.randrange(4) << 1, rng.getrandbits(CODE_BITS)
    frame, row, column, flags = record
    return 1 | flags << 1, camera << CAMERA_BIT | code(frame, row, column)


class Joiner:
    def __init__(self, work, pixel_bits, *changes, netlist=False):
        """`changes`: (file, old text, new text). `netlist`: what GHDL's synthesis makes of it, for DEPTH pixels."""
        self.work, self.pixel_bits, self.lane_bits = work, pixel_bits, template.lane_bits(pixel_bits)
        self.bits = {"pixel_bits": self.pixel_bits, "lane_bits": self.lane_bits}
        files = []
        for name in FILES:
            text = (rtl.HAND_WRITTEN / f"{name}.vhd").read_text()
            for _, old, new in (change for change in changes if change[0] == name):
                assert old in text
                text = text.replace(old, new, 1)
            files.append(work / f"{name}.vhd")
            files[-1].write_text(text)
        ghdl.analyse(files, work)
        if netlist:
            generics = ghdl.options_of({**SIZE, "depth": DEPTH, **self.bits})
            text = run([find_ghdl(), "--synth", ghdl.STANDARD, *generics, "--out=vhdl", "stereo_joiner"], cwd=work)
            # Where GHDL, as 2.0, converts the bit inside to a vector of one bit, VHDL does not allow it.
            text = re.sub(r"\b(m_axis_tuser) <= std_ulogic_vector\b", r"\1(0) <= std_ulogic", text)
            (work / "netlist.vhd").write_text(text)
            ghdl.analyse([work / "netlist.vhd"], work)
        ghdl.analyse([BENCH], work)
        ghdl.elaborate(work, "tb_stereo_joiner")

    def play(self, records, rng, sink_percent=100, depth=DEPTH, reset_at=None):
        left, right = records
        clocks = max(len(left), len(right)) + 200
        inputs = [(1 << 7, 0, 0)]
        for clock in range(clocks):
            left_flags, left_word = word_of(left[clock] if clock < len(left) else None, rng, 0)
            right_flags, right_word = word_of(right[clock] if clock < len(right) else None, rng, 1)
            ready = clock >= clocks - 100 or rng.random() * 100 < sink_percent
            flags = left_flags | right_flags << 3 | ready << 6 | (clock == reset_at) << 7
            inputs.append((flags, left_word, right_word))
        whole = None
        for low in range(0, CODE_BITS, self.pixel_bits):
            part = self._play_part(inputs, low, depth)
            if whole is not None:
                assert [pair[2:] for pair in part.pairs] == [pair[2:] for pair in whole.pairs]
                assert part.faults == whole.faults
                part.pairs = [(a | c, b | d, *rest) for (a, b, *rest), (c, d, *_) in zip(whole.pairs, part.pairs)]
            whole = part
        return whole

    def _play_part(self, inputs, low, depth):
        """Bits `low` and above of the codes, with garbage in the bits of a lane above the pixel."""
        garbage = random.Random(low)

        def lane(word):
            pixel = word >> low & (1 << self.pixel_bits) - 1
            return garbage.getrandbits(self.lane_bits) >> self.pixel_bits << self.pixel_bits | pixel

        digits = self.lane_bits // 4
        lines = [f"{flags:02x} {lane(left):0{digits}x} {lane(right):0{digits}x}" for flags, left, right in inputs]
        (self.work / "stimulus.txt").write_text("\n".join(lines) + "\n")
        names = {"stimulus_file": "stimulus.txt", "observed_file": "observed.txt", **SIZE, "depth": depth, **self.bits}
        run([find_ghdl(), "-r", ghdl.STANDARD, "tb_stereo_joiner", *ghdl.options_of(names)], cwd=self.work)
        seen = Seen()
        *observed, end = (self.work / "observed.txt").read_text().splitlines()
        assert end == f"{len(inputs)} end"
        for _, kind, *values in map(str.split, observed):
            if kind == "fault":
                seen.faults.append(values[0])
                continue
            lanes = divmod(int(values[0], 16), 1 << self.lane_bits)  # right, left
            assert not any(value >> self.pixel_bits for value in lanes), "bits above a pixel are 0"
            right, left = (value << low for value in lanes)
            seen.pairs.append((left, right, int(values[1]), int(values[2])))
        return seen


def whole_frames(cameras):
    return [a.number for a, b in zip(*cameras) if a.damage is None and b.damage is None]


def judge(seen, cameras):
    """What is wrong with the pairs that came out."""
    frames, number, broken, column = {}, None, set(), 0
    for left, right, flags, _ in seen.pairs:
        if left == right == 0:
            if number in broken:
                return f"frame {number} is ended twice"
            if flags != (0 if column == WIDTH - 1 else END):
                return f"frame {number} is ended in column {column} by what may belong to it"
            broken.add(number)
            continue
        if (left >> CAMERA_BIT, right >> CAMERA_BIT) != (0, 1):
            return "pixels of the cameras are swapped"
        if frame_of(left) != frame_of(right):
            return f"frame {frame_of(left)} of the left camera meets frame {frame_of(right)} of the right one"
        number = frame_of(left)
        if number in broken:
            return f"frame {number} goes on behind its end"
        frames.setdefault(number, []).append((left, right, flags))
        column = 0 if flags & END else 1 if flags & START else column + 1
    expected = [
        (place(y, x), place(y, x), (x == y == 0) * START | (x == WIDTH - 1) * END)
        for y in range(HEIGHT)
        for x in range(WIDTH)
    ]
    for number in whole_frames(cameras):
        shown = [(place_of(a), place_of(b), flags) for a, b, flags in frames.get(number, [])]
        if shown != expected:
            return f"frame {number} is whole on both sides but comes out with {len(shown)} pairs, not as it is"
    for number, pairs in frames.items():
        is_reset = cameras[0][number].damage == "reset"  # with all behind it
        if not is_reset and (number in broken) == (len(pairs) == WIDTH * HEIGHT):
            return f"frame {number} is {'' if number in broken else 'not '}ended as a broken one"
        if [flags & START for _, _, flags in pairs].index(START) != 0:
            return f"frame {number} comes out without its start"
        shifted = {row_of(a) for a, b, _ in pairs if column_of(a) != column_of(b)}
        if len(shifted) > 1:
            return f"frame {number} goes on behind a line in which the cameras differ"
    return None


@pytest.fixture(scope="module", params=PIXEL_BITS)
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


@pytest.mark.parametrize("number", range(12))
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


@pytest.mark.parametrize("seed", range(4))
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


@pytest.mark.parametrize("fault", with_slow(FAULTS, FAST))
@pytest.mark.parametrize("pixel_bits", PIXEL_BITS)
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
