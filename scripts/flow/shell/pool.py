# SPDX-License-Identifier: Apache-2.0
"""Frames with the disparity maps that the C++ core gives for them."""

import random
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ..base import files, rtl
from ..base.configurations import Parameters, clocks_per_pixel
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Word, find_stereo_hls, run
from ..cosim import vectors
from .template import lane_bits

# (grey levels, distance between them) of the noise. Few levels give ties everywhere, far apart also extremes; close
# together they give sums that differ by little.
LEVELS = ((256, 1), (4, 85), (4, 1), (2, 255))


@dataclass(frozen=True)
class Frame:
    """A pair of images and its map, as words of the streams' tdata."""

    groups: tuple[int, ...]  # s_axis, W*H/P words
    results: tuple[int, ...]  # m_axis
    needs: tuple[int, ...]  # for each result: how many of the groups it depends on
    settings: tuple[int, ...] = ()  # of a core that takes them from ports, in their order
    geometry: "Geometry | None" = None  # where the core takes it from ports, too


@dataclass(frozen=True)
class Geometry:
    columns: int  # beats of a line on s_axis
    row_groups: int  # lines of a frame, on both sides
    result_columns: int  # beats of a line on m_axis

    @classmethod
    def of(cls, parameters: Parameters) -> "Geometry":
        return cls(
            parameters["width_px"],
            parameters["height_px"] // parameters["pixels_per_clock"],
            parameters["output_width_px"],
        )

    def with_size(self, width: int, row_groups: int) -> "Geometry":
        """Of images of another size."""
        return Geometry(width, row_groups, self.result_columns - (self.columns - width))

    @property
    def groups(self) -> int:
        return self.columns * self.row_groups

    @property
    def results(self) -> int:
        return self.result_columns * self.row_groups


def make_pool(
    config: str, parameters: Parameters, pairs: int, seed: int, folder: Path, reuse: bool = False
) -> list[Frame]:
    """2 * pairs different frames of noise: each pair upright and upside down. Where the size of the images comes from
    ports, six more of each pair, of three random sizes. `reuse`: the folder was filled by the same call in this run
    already."""
    if reuse:
        return _different(
            frame for number in range(pairs) for frame in _read_frames(folder / f"vectors_{number}", parameters)
        )
    folder.mkdir(parents=True, exist_ok=True)
    generator = random.Random(f"pool {seed}")
    frames = []
    for number in range(pairs):
        names = [folder / f"{side}_{number}.pgm" for side in ("left", "right")]
        for name in names:
            write_noise(name, parameters, generator, *LEVELS[number % len(LEVELS)])
        out = folder / f"vectors_{number}"
        images: list[Word] = ["--left", names[0], "--right", names[1]]
        run(
            [
                find_stereo_hls(),
                "vectors",
                "--config",
                config,
                *images,
                "--frames",
                _frames_of_a_pair(parameters),
                "--seed",
                number + 1,
                "--out",
                out,
            ],
            passes_errors=True,
        )
        frames += _read_frames(out, parameters)
    return _different(frames)


def _different(frames: Iterable[Frame]) -> list[Frame]:
    """Without those that a pair gives again because a size was drawn twice: the judge knows a frame by its pixels."""
    return list({frame.groups: frame for frame in frames}.values())


def _has_sizes(parameters: Parameters) -> bool:
    return any(setting.held for setting in rtl.settings_of(parameters))


def _frames_of_a_pair(parameters: Parameters) -> int:
    return 8 if _has_sizes(parameters) else 2


def pairs_for(parameters: Parameters, frames: int) -> int:
    """How many give so many frames."""
    return -(-frames // _frames_of_a_pair(parameters))


def write_noise(path: Path, parameters: Parameters, generator: random.Random, levels: int, distance: int) -> None:
    """A PGM image of a configuration's size."""
    width, height = parameters["width_px"], parameters["height_px"]
    more = rtl.pixel_bits_of(parameters) - rtl.PIXEL_BITS
    pixels = [generator.randrange(levels) * distance for _ in range(width * height)]
    if more:  # the lower bits are noise
        path.write_bytes(files.deep_pgm(width, height, [p << more | generator.randrange(1 << more) for p in pixels]))
    else:
        path.write_bytes(files.pgm(width, height, bytes(pixels)))


def _geometry_of(parameters: Parameters, settings: tuple[int, ...]) -> Geometry:
    """Of a frame with the size that is among its settings."""
    names = [setting.name for setting in rtl.settings_of(parameters)]
    width, height = (settings[names.index(name)] for name in ("image_width", "image_height"))
    return Geometry.of(parameters).with_size(width, height // parameters["pixels_per_clock"])


def _read_frames(folder: Path, parameters: Parameters) -> list[Frame]:
    geometry = Geometry.of(parameters)
    lanes, bits = parameters["pixels_per_clock"], rtl.pixel_bits_of(parameters)
    lane = lane_bits(bits)

    def lanes_of(word: int) -> int:
        """The core's pixels in the lanes of a beat. What stands above a pixel in its lane does not count."""
        pixels = [word >> bits * p & (1 << bits) - 1 for p in range(lanes)]
        return sum((pixel | ~pixel << bits & (1 << lane) - 1) << lane * p for p, pixel in enumerate(pixels))

    map_bits = parameters["disparity_bits"] * parameters["pixels_per_clock"]
    stimulus = vectors.read_stimulus(folder / "stimulus.txt", rtl.kind_of(parameters))
    words = [line.split() for line in (folder / "stimulus.txt").read_text().splitlines()[1:]]
    expected, latency = vectors.read_expected(folder / "expected.txt")
    sized, pace = _has_sizes(parameters), clocks_per_pixel(parameters)
    starts = [clock for clock, group in enumerate(stimulus) if all(group)][: _frames_of_a_pair(parameters)]
    frames = []
    for number, start in enumerate(starts):
        settings = tuple(int(word, 16) for word in words[start][3:])
        own = _geometry_of(parameters, settings) if sized else None
        size = own or geometry
        groups = tuple(
            lanes_of(int(right, 16)) << lane * lanes | lanes_of(int(left, 16))
            for _, left, right, *_ in words[start : start + pace * size.groups : pace]
        )
        outputs = [output for output in expected if output.frame == number]
        if len(outputs) != size.results:
            raise FlowError(f"the C++ core gave {len(outputs)} outputs instead of {size.results}", EXIT_TOOL_FAILED)
        results = tuple((output.flags >> 2) << map_bits | output.disparity for output in outputs)
        needs = tuple(min((output.clock - latency - start) // pace + 1, size.groups) for output in outputs)
        frames.append(Frame(groups, results, needs, settings, own))
    return frames
