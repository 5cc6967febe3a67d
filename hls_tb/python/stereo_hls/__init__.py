# SPDX-License-Identifier: Apache-2.0
"""Stereo matching as the hardware does it: fast models, clocked cores and measures for numpy arrays.

    import stereo_hls

    pair = stereo_hls.scene(seed=1)
    found = stereo_hls.match(pair.left, pair.right, configuration="census_450", window_px=7)
    print(stereo_hls.evaluate(found, pair.truth(found.reference))["all"]["bad_1"])

Options, their limits and the sentences of errors are those of the program `stereo_hls`.
"""

import json
import operator
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import CoreNotBuilt

__all__ = [
    "CoreNotBuilt",
    "DisparityMap",
    "Option",
    "Scene",
    "configurations",
    "evaluate",
    "families",
    "match",
    "scene",
    "trace",
]
__version__ = _core.version

Side = Literal["left", "right"]
Option = int | bool | str

_MOST_THREADS = 1024
_MOST_CLOCKS = 1_000_000

CoreNotBuilt.__doc__ = """The clocked core of a configuration is not part of this installation."""
_core.set_core_folder(Path(__file__).parent / "cores")


@dataclass(frozen=True)
class DisparityMap:
    """What `match` found. W x H is the size of the images; the map itself may be narrower."""

    disparity: NDArray[np.float32]
    """[H, W]: pixels, at the size of the reference image; NaN outside the map and where a check failed,
    unless the pixel was filled."""
    steps: NDArray[np.uint16]
    """[H, map's width]: as the hardware gives them, from the smallest disparity on, in pixels or sixteenths of one."""
    valid: NDArray[np.bool_]
    """[H, map's width]: the disparity has passed every check."""
    confidence: NDArray[np.uint8] | None
    """[H, map's width]: 255 for the surest, 0 where not valid; None without the option `confidence`."""
    filled: NDArray[np.bool_] | None
    """[H, map's width]: not valid, shows what stands beside it; None without the option `fill_holes`."""
    steps_per_px: int
    """1, or 16 with `subpixel`."""
    first_column: int
    """Of the reference image, at which the map's column 0 stands."""
    reference: Side
    """The image whose pixels have the disparities."""
    search: tuple[int, int]
    """The smallest disparity in pixels, and the number of them."""
    options: dict[str, Option]
    """All options of the algorithm."""


@dataclass(frozen=True)
class Scene:
    """A generated pair with the true disparities of both images."""

    left: NDArray[np.uint8] | NDArray[np.uint16]
    right: NDArray[np.uint8] | NDArray[np.uint16]
    truth_left: NDArray[np.float32]
    """[H, W]: whole pixels."""
    truth_right: NDArray[np.float32]

    def truth(self, reference: Side) -> NDArray[np.float32]:
        """Of one image."""
        return {"left": self.truth_left, "right": self.truth_right}[reference]


def configurations() -> dict[str, dict[str, Any]]:
    """The named configurations: {name: {its family, use, description, image size, all options, latency ...}}, as
    `stereo_hls configurations --json` prints them."""
    table: dict[str, dict[str, Any]] = json.loads(_core.configurations())
    return table


def families() -> dict[str, dict[str, dict[str, Any]]]:
    """The options of each family: {family: {option: {"default", "low", "high", "meaning"}}}, or {"default", "words"} of
    a choice or flag. A limit is None where there is none; limits that follow from other options are those of the
    defaults.
    """
    table: dict[str, dict[str, dict[str, Any]]] = json.loads(_core.families())
    return table


def match(
    left: ArrayLike,
    right: ArrayLike,
    configuration: str = "ambrosch2007",
    *,
    engine: Literal["fast", "clocked"] = "fast",
    threads: int | None = None,
    **options: Option,
) -> DisparityMap:
    """The disparity map of a rectified pair. Other Python threads run meanwhile.

    left, right: uint8 [H, W], of any strides; uint16 with values below 2^pixel_bits where the option pixel_bits is 10
        or 12, which also takes uint8 as they are.
    configuration: a name of `configurations()`.
    engine: "fast", the software model, for images of any size, or "clocked", the hardware's C++, for images of the
        configuration's size and without options.
    threads: of the fast model, 1 ... 1024; without it one for each core. The map does not depend on it.
    options: those of the configuration's family that are to differ, as in `families()`; window_px=9.

    Raises ValueError with one sentence for what does not fit, TypeError for arrays and options of another type, and
    CoreNotBuilt where the clocked core is not part of the installation: STEREO_CORES in the environment names a folder
    with others, such as build/release/cores.
    """
    images = _grey("left", left), _grey("right", right)
    if engine not in ("fast", "clocked"):
        raise ValueError(f"engine={engine!r}: must be 'fast' or 'clocked'")
    if engine == "clocked" and options:
        raise ValueError(f"{next(iter(options))}: the options of a clocked core are fixed; take engine='fast'")
    count = len(os.sched_getaffinity(0)) if threads is None else _number("threads", threads, 1, _MOST_THREADS)
    settings = [(name, _option_text(name, value)) for name, value in options.items()]
    run = _core.match
    if any(image.dtype == np.uint16 for image in images):
        run, images = _core.match_deep, (images[0].astype(np.uint16), images[1].astype(np.uint16))
    found = run(*images, configuration, settings, engine == "clocked", count)
    found.update(valid=found["valid"].view(np.bool_), options=json.loads(found["options"]))
    if found["filled"] is not None:
        found["filled"] = found["filled"].view(np.bool_)
    return DisparityMap(**found)


def evaluate(
    disparity: DisparityMap | ArrayLike,
    truth: ArrayLike,
    other_truth: ArrayLike | None = None,
    image: ArrayLike | None = None,
    *,
    reference: Side | None = None,
    search: tuple[int, int] | None = None,
    border_px: int = 10,
    pixel_bits: int | None = None,
    unknown: float | None = None,
) -> dict[str, dict[str, Any]]:
    """How good a map is, by the rules of `stereo_hls evaluate`: {mask: {measure: value}}. Masks without pixels are
    absent.

    disparity: what `match` found, or pixels as float [H, W]; where a value is not finite or masked, nothing was found.
    truth: the true disparities of the reference image in pixels, float [H, W]; not finite or masked where unknown.
    other_truth: those of the other image; needed for the masks "non_occluded", "searchable" and "discontinuity".
    image: the reference image, uint8 or uint16 [H, W]; needed, with other_truth, for the mask "textureless". Of more
        than 8 bits the upper 8 count.
    reference: "left" or "right"; needed where `disparity` is an array. What a map says itself may be left out, and must
        not be said otherwise: reference, search, pixel_bits.
    search: the smallest disparity and the number of them; needed for "searchable" where `disparity` is an array.
    border_px: pixels at each side of the images that do not count, 0 ... 10000.
    pixel_bits: of an image of uint16, 8 ... 16; needed where `disparity` is an array.
    unknown: a value of truth and other_truth that stands for none, such as 0 or -1, as --unknown of the program.

    Measures: "pixels"; "density" 0 ... 1; "avg_px", "rms_px"; "bad_0_5", "bad_1", "bad_2", "bad_4", "d1": shares
    0 ... 1 of pixels off by more than 0.5, 1, 2, 4 pixels and by KITTI's rule, each as {"invalid_bad", "valid_only"}.
    None where no pixel counts.

    Raises ValueError or TypeError with one sentence.
    """
    if isinstance(disparity, DisparityMap):
        own_bits = int(disparity.options.get("pixel_bits", 8))
        search = None if search is None else _search(search)
        for name, given, own in (
            ("reference", reference, disparity.reference),
            ("search", search, disparity.search),
            ("pixel_bits", pixel_bits, own_bits),
        ):
            if given is not None and given != own:
                raise ValueError(f"{name}={given!r}: the map's is {own!r}; leave it out, or give the map's disparity")
        pixel_bits = own_bits
        reference, search, disparity = disparity.reference, disparity.search, disparity.disparity
    if reference not in ("left", "right"):
        raise ValueError("reference: must be 'left' or 'right' where the disparities are an array")
    found, wanted = _disparities("disparity", disparity), _disparities("truth", truth, unknown)
    other = None if other_truth is None else _disparities("other_truth", other_truth, unknown)
    shown = None if image is None else _shown("image", image, pixel_bits)
    for name, array in (("disparity", found), ("other_truth", other), ("image", shown)):
        if array is not None and array.shape != wanted.shape:
            raise ValueError(f"{name}: is {_size(array)} but the truth is {_size(wanted)}")
    border_px = _number("border_px", border_px, 0, 10_000)
    measures: dict[str, dict[str, Any]] = json.loads(
        _core.evaluate(found, wanted, other, shown, reference, search, border_px)
    )
    return measures


def scene(
    width: int = 640, height: int = 480, disparities: int = 100, seed: int = 1, noise: int = 2, pixel_bits: int = 8
) -> Scene:
    """A generated pair, the same on every machine.

    width, height: pixels; disparities: 2 ... 256, below the width, the scene's stay below it; noise: 0 ... 64 grey
    levels of 8 bits; pixel_bits: of left and right, 8, 10 or 12, whose images are uint16.

    Raises ValueError with one sentence.
    """
    if pixel_bits not in (8, 10, 12):
        raise ValueError(f"pixel_bits={pixel_bits}: must be 8, 10 or 12")
    numbers = {"width": width, "height": height, "disparities": disparities, "noise": noise}
    sizes = {name: _number(name, value, -(2**31), 2**31 - 1) for name, value in numbers.items()}
    seed = _number("seed", seed, 0, 2**64 - 1)
    made = _core.scene(sizes["width"], sizes["height"], sizes["disparities"], seed, sizes["noise"], pixel_bits)
    for side in ("truth_left", "truth_right"):
        made[side] = made[side].astype(np.float32)
    return Scene(**made)


def trace(configuration: str, clocks: int = 1000) -> dict[str, NDArray[Any]]:
    """What every port and register of a clocked core shows before each clock edge, as `stereo_hls trace` writes it:
    {name: integers [clocks]}. The names of registers are those of the VHDL. Inputs are random, with bubbles.

    clocks: 10 ... 1000000.

    Raises ValueError with one sentence, and CoreNotBuilt as `match` does.
    """
    return _core.trace(configuration, _number("clocks", clocks, 10, _MOST_CLOCKS))


def _size(array: NDArray[Any]) -> str:
    return f"{array.shape[1]}x{array.shape[0]}"


def _plane(name: str, array: NDArray[Any]) -> None:
    if array.ndim != 2:
        raise ValueError(f"{name}: must have two axes, rows and columns, but its shape is {array.shape}")
    if array.size == 0:
        raise ValueError(f"{name}: has no pixels; its shape is {array.shape}")


def _search(value: tuple[int, int]) -> tuple[int, int]:
    first, count = value
    return operator.index(first), operator.index(count)


def _grey(name: str, value: ArrayLike) -> NDArray[Any]:
    if np.ma.is_masked(value):
        raise ValueError(f"{name}: has masked pixels, but every pixel of an image counts; give an array without a mask")
    array = np.asarray(value)
    if array.dtype not in (np.uint8, np.uint16):
        raise TypeError(f"{name}: must be an array of uint8 or uint16 but is one of {array.dtype}")
    _plane(name, array)
    return np.ascontiguousarray(array)


def _shown(name: str, value: ArrayLike, pixel_bits: int | None) -> NDArray[np.uint8]:
    array = _grey(name, value)
    if array.dtype == np.uint8:
        return array
    if pixel_bits is None:
        raise ValueError(f"pixel_bits: must be given where {name} is an array of uint16")
    return _core.shown(name, array, _number("pixel_bits", pixel_bits, 8, 16))


def _disparities(name: str, value: ArrayLike, unknown: float | None = None) -> NDArray[np.float32]:
    mask = np.ma.getmaskarray(value) if np.ma.is_masked(value) else None
    array = np.asarray(value)
    if not np.issubdtype(array.dtype, np.floating):
        raise TypeError(
            f"{name}: must be an array of floats, not finite where there is no disparity, but is one of {array.dtype}"
        )
    _plane(name, array)
    if mask is not None:
        array = np.where(mask, np.nan, array)
    if unknown is not None:
        array = np.where(array == array.dtype.type(unknown), np.nan, array)
    return np.ascontiguousarray(array, dtype=np.float32)


def _number(name: str, value: int, low: int, high: int) -> int:
    number = operator.index(value)
    if not low <= number <= high:
        raise ValueError(f"{name}={number}: must be {low} ... {high}")
    return number


def _option_text(name: str, value: Option) -> str:
    if isinstance(value, bool | np.bool_):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    try:
        return str(operator.index(value))
    except TypeError:
        raise TypeError(f"{name}: must be a number, a flag or a word but is {value!r}") from None
