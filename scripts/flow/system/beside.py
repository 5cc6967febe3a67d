# SPDX-License-Identifier: Apache-2.0
"""What m_axis of a camera_system has beside the depths: which of them fill a hole, how sure they are, and the rectified
left image. The bits of its beats, and the VHDL that makes them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..base import rtl
from ..base.configurations import Configuration, Parameters, clocks_per_pixel, option
from ..base.errors import FlowError
from ..shell.template import instance, lane_bits

DEPTH_BITS, FLAGS_BITS, CONFIDENCE_BITS = 16, 8, 8
FILLED_BIT = 15  # of a core's word; a confidence stands in its highest bits
MEASURED_AT, FILLED_AT = DEPTH_BITS, DEPTH_BITS + 1  # in a beat, among the flags


class Beside(NamedTuple):
    """A beat has a depth, 8 bits of flags, a confidence where there is one, and a lane for the left pixel."""

    disparity_bits: int  # of the core's word, with its marks: `filled`, and above it the confidence
    filled: bool
    confidence: bool
    pixel_bits: int  # of the left image; 0: there is none

    @property
    def marks(self) -> range:
        """Their bits in the core's word."""
        high = self.disparity_bits if self.confidence else FILLED_BIT + 1
        return range(FILLED_BIT if self.filled else high - CONFIDENCE_BITS * self.confidence, high)

    @property
    def mark_bits(self) -> int:
        return self.filled + CONFIDENCE_BITS * self.confidence

    @property
    def word_bits(self) -> int:
        """Of what the shell takes for a disparity: depth, marks, left pixel, from the lowest bits on."""
        return DEPTH_BITS + self.mark_bits + self.pixel_bits

    @property
    def left_at(self) -> int:
        """The lowest bit of the left pixel in a beat."""
        return DEPTH_BITS + FLAGS_BITS + CONFIDENCE_BITS * self.confidence

    @property
    def beat_bits(self) -> int:
        return self.left_at + (lane_bits(self.pixel_bits) if self.pixel_bits else 0)

    def beat(self, word: int, is_valid: int, depths: Sequence[int], left: int = 0) -> int:
        """That must come of a core's word and its pixel_valid. `depths`: of each disparity; left: the pixel."""
        is_filled = word >> FILLED_BIT & 1 if self.filled else 0
        marks = 1 << self.marks[0] if self.mark_bits else 1 << self.disparity_bits
        depth = depths[word % marks] if is_valid or is_filled else 0
        flags = is_valid << MEASURED_AT | is_filled << FILLED_AT
        sure = word >> self.disparity_bits - CONFIDENCE_BITS if self.confidence else 0
        return depth | flags | sure << DEPTH_BITS + FLAGS_BITS | left << self.left_at


def of(parameters: Parameters, left_image: bool) -> Beside:
    """`parameters`: of the matching core."""
    if left_image and option(parameters, "reference") != "left":
        raise FlowError("the left image stands beside depths of a core with the left reference only")
    bits = rtl.pixel_bits_of(parameters) if left_image else 0
    filled, confidence = (bool(option(parameters, name)) for name in ("fill_holes", "confidence"))
    return Beside(parameters["disparity_bits"], filled, confidence, bits)


def kept_pixels(row: Configuration) -> int:
    """That camera_image keeps at least: those of the image that have come in since the one at a disparity's place, when
    that disparity is shown."""
    in_flight = (row["latency_clocks"] - 1) // clocks_per_pixel(row)
    kept = row["groups_to_first_output"] - row["output_first_column"] + in_flight
    if kept + row["output_first_column"] >= row["width_px"] * row["height_px"]:
        raise FlowError("the frames are too small for an image beside the depths: a map would begin behind its frame")
    return max(kept, row["width_px"])


def vector(bits: int) -> str:
    return f"std_logic_vector({bits - 1} downto 0)"


def signals(beside: Beside) -> dict[str, str]:
    """{names: type}"""
    if beside.word_bits == DEPTH_BITS:
        return {}
    found = {"has_depth, measured": vector(1)} if beside.filled else {}
    if beside.mark_bits:
        found["marks, depth_marks"] = vector(beside.mark_bits)
    if beside.pixel_bits:
        found["image_pixel"] = vector(beside.pixel_bits)
    return found | {"word": vector(beside.word_bits), "word_tdata": vector(beside.word_bits + FLAGS_BITS)}


def statements(beside: Beside) -> list[str]:
    """VHDL behind the core: `word` to the shell, and the beats of what the shell makes of it."""
    lines = []
    if beside.mark_bits:
        marks = beside.marks
        lines = [
            "  -- As late as camera_depth is.",
            "  process (aclk)",
            "  begin",
            "    if rising_edge(aclk) then",
            f"      marks <= disparity({marks[-1]} downto {marks[0]});",
            "      depth_marks <= marks;",
            "    end if;",
            "  end process;",
        ]
    if beside.filled:
        lines += [
            f"  has_depth(0) <= pixel_valid(0) or disparity({FILLED_BIT});",
            "  measured(0) <= depth_known(0) and not depth_marks(0);",
        ]
    parts = ["image_pixel"] * bool(beside.pixel_bits) + ["depth_marks"] * bool(beside.mark_bits) + ["depth_mm"]
    return [*lines, f"  word <= {' & '.join(parts)};", *_beat(beside)]


def _beat(beside: Beside) -> list[str]:
    """m_axis_tdata of the shell's word and its flag, from the lowest bits on."""
    lines, low, taken = [], 0, 0

    def field(bits: int, value: str = "") -> None:
        """Without a value the next bits of the word."""
        nonlocal low, taken
        if not value:
            value = f"word_tdata({taken + bits - 1} downto {taken})"
            taken += bits
        lines.append(f"  m_axis_tdata({low + bits - 1} downto {low}) <= {value};")
        low += bits

    field(DEPTH_BITS)
    field(1, f"word_tdata({beside.word_bits} downto {beside.word_bits})")
    if beside.filled:
        field(1)
    field(DEPTH_BITS + FLAGS_BITS - low, "(others => '0')")
    if beside.confidence:
        field(CONFIDENCE_BITS)
    if beside.pixel_bits:
        field(beside.pixel_bits)
    if low < beside.beat_bits:
        field(beside.beat_bits - low, "(others => '0')")
    return lines


def image(row: Configuration) -> str:
    """The instance of camera_image in front of a matching core."""
    kept = kept_pixels(row)
    generics = {name: row[name] for name in ("width_px", "output_width_px")}
    generics |= {"first_column": row["output_first_column"], "kept": kept, "address_bits": (kept - 1).bit_length()}
    connected = {"clock": "aclk", "rectified_pixel": "rectified_left"}
    same = ("rectified_start_of_frame", "rectified_valid", "disparity_valid", "disparity_start_of_frame")
    connected |= {name: name for name in (*same, "disparity_end_of_line", "image_pixel")}
    return instance("image", "camera_image", generics | {"pixel_bits": rtl.pixel_bits_of(row)}, connected)
