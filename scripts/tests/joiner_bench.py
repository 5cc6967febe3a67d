# SPDX-License-Identifier: Apache-2.0
"""stereo_joiner in GHDL between two cameras that lose pixels, lines and frames, and the judge of what comes out.

A number says where a pixel belongs; it has more bits than the joiner's pixels. So each stream is played once for each
part of the number, with the part as pixel, and the runs must agree in all but the pixels."""

import random
import re
from dataclasses import dataclass, field

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

    def play(self, records, rng, sink_percent=100, depth=DEPTH, reset_at=None, waits=()):
        """`sink_percent`: of the clocks in which the sink is ready, but for the clocks `waits`."""
        left, right = records
        clocks = max(len(left), len(right)) + 200
        inputs = [(1 << 7, 0, 0)]
        for clock in range(clocks):
            left_flags, left_word = word_of(left[clock] if clock < len(left) else None, rng, 0)
            right_flags, right_word = word_of(right[clock] if clock < len(right) else None, rng, 1)
            ready = clock >= clocks - 100 or rng.random() * 100 < sink_percent and clock not in waits
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
