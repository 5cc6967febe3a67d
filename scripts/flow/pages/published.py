# SPDX-License-Identifier: Apache-2.0
"""What others have published of their systems."""

from typing import NamedTuple

from ..base.configurations import Size

# "Hardware implementation of an SAD based stereo vision algorithm", 2007
PAPER: Size = {"width_px": 320, "height_px": 240, "disparities": 100}
PAPER_WINDOW_PX = 3
PAPER_MHZ = 65
PAPER_CLOCKS_PER_FRAME = 153_120
PAPER_FRAMES_PER_SECOND = 425
PAPER_ALUTS = 15_616
PAPER_MEMORY_BITS = 884_736


class Published(NamedTuple):
    """None where it is not published."""

    system: str
    source: str
    clocks_per_frame: int | None = None  # of 320x240 with 100 disparities
    frames_per_second: int | None = None
    aluts: int | None = None
    memory_bits: int | None = None
    mde_per_second: int | None = None


PUBLISHED = [
    Published(
        f"Ambrosch et al. 2007, 3x3, Stratix II, {PAPER_MHZ} MHz",
        "the paper, section 4",
        PAPER_CLOCKS_PER_FRAME,
        PAPER_FRAMES_PER_SECOND,
        PAPER_ALUTS,
        PAPER_MEMORY_BITS,
    ),
    Published("Vitis Vision StereoBM, 100 units, 5x5", "its loop bounds", clocks_per_frame=79_056),
    Published("Strother dlsc SAD core, 2 rows at once, 5x5", "its header; about", clocks_per_frame=27_000),
    Published("best FPGA row found: SGM 3840x2160x64 at 30 frames a second", "its publication", mde_per_second=15_925),
]

_SURVEY = "table 1 of doi 10.1155/2014/945926"
# (system of the paper's comparison or of ours, point, frames a second where a public source gives them, that source,
# configuration)
SYSTEMS: list[tuple[str, str, int | None, str, str | None]] = [
    ("Niitsuma and Maruyama", "640x480, D=27, 7x7", None, "", "niitsuma_640"),
    ("Niitsuma and Maruyama", "320x240, D=121, 7x7", None, "", "niitsuma_320"),
    ("Lee et al.", "320x240, D=64, 16x16", None, "", "lee_320"),
    ("Miyajima and Maruyama", "640x480, D=200, 7x7", None, "", "miyajima_640"),
    ("Yi et al.", "270x270, D=34, window not stated: 9x9 here", None, "", "yi_270"),
    ("Han et al.", "640x480, D=128, window not stated: 9x9 here", None, "", "han_640"),
    ("DeepSea (Tyzx)", "512x480, D=52, census", 200, _SURVEY, "deepsea_512"),
    ("OpenCV StereoBM, block 15", "450x375, D=64, checks, subpixel", None, "", "opencv_bm"),
    ("best trade-off in quality.md", "450x375, D=48, census 9x3, 9x9", None, "", "census_450"),
    ("Kim et al.: trellis", "320x240, D=128", 30, _SURVEY, None),
    ("PARTS, Masrani and MacLean: local weighted phase correlation", "640x480, D=36 (Masrani)", 30, _SURVEY, None),
    ("Masrani and MacLean: dynamic range", "", None, "", None),
]
