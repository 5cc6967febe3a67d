# SPDX-License-Identifier: Apache-2.0
"""What others have published of their systems."""

from __future__ import annotations

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


REVIEW = "doi 10.1155/2014/945926, table 1"
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
    Published(
        "SGM 1024x768x256 at 127 frames a second (Cambuim et al., SBCCI 2017)",
        "its numbers as others cite them; its text was not found",
        mde_per_second=25_568,
    ),
    Published("SGM 3840x2160x64 at 30 frames a second", "its publication", mde_per_second=15_925),
    Published("SAD 450x375x60 at 599 frames a second", REVIEW, mde_per_second=6_065),
    Published("RTSVP 640x480x60 at 303 frames a second", REVIEW, mde_per_second=5_585),
]

_TABLE, _TEXT = "the paper, table 1", "the paper, section 2"
_OURS = "a configuration of this project"


class System(NamedTuple):
    """A system of the paper's comparison, or one of ours beside them."""

    name: str
    point: str  # image, disparities, algorithm, block
    frames_per_second: float | None  # None where there is nothing to publish
    source: str
    configuration: str | None = None  # that is built like it; None: not done yet
    platform: str = ""


SYSTEMS = [
    System(
        "the same in software",
        "320x240, D=100, SAD 3x3",
        1.24,
        f"{_TABLE}; its text says 391 ms, 2.56",
        "ambrosch2007",
        "PC",
    ),
    System("the same, 5 clocks a pixel pair", "320x240, D=100, SAD 3x3", None, _OURS, "ambrosch2007_f5"),
    System("the same, 10 clocks a pixel pair", "320x240, D=100, SAD 3x3", None, _OURS, "ambrosch2007_f10"),
    System("the same, 20 clocks a pixel pair", "320x240, D=100, SAD 3x3", None, _OURS, "ambrosch2007_f20"),
    System("Niitsuma et al.", "640x480, D=27, SAD 7x7", 30, _TABLE, "niitsuma_640", "1 FPGA"),
    System("Niitsuma et al.", "320x240, D=121, SAD 7x7", 840, _TABLE, "niitsuma_320", "1 FPGA and PC"),
    System("Lee et al.", "320x240, D=64, SAD 16x16", 122, _TABLE, "lee_320", "1 FPGA"),
    System("Miyajima et al.", "640x480, D=200, SAD 7x7", 18.9, _TABLE, "miyajima_640", "2 FPGAs and PC"),
    System("the same, 5 clocks a pixel pair", "640x480, D=200, SAD 7x7", 18.9, _TABLE, "miyajima_640_f5"),
    System("Yi et al.", "270x270, D=34, SAD, block not stated: 9x9 here", 30, _TEXT, "yi_270"),
    System("Han and Hwang", "640x480, D=128, SAD, block not stated: 9x9 here", 60, _TEXT, "han_640"),
    System("DeepSea", "512x480, D=52, census", 200, _TABLE, "deepsea_512", "ASIC"),
    System("Kim et al.", "1300x640, D not stated: 64 here, trellis", 30, _TABLE, "trellis_1300", "2 FPGAs"),
    System("PARTS", "320x240, D=24, local weighted phase correlation", 42, _TABLE, "parts_320", "16 FPGAs"),
    System(
        "Masrani et al.",
        "640x480, D dynamic: 128 here, local weighted phase correlation",
        30,
        _TABLE,
        "masrani_640",
        "4 FPGAs",
    ),
    System("OpenCV StereoBM, block 15", "450x375, D=64, checks, subpixel", None, _OURS, "opencv_bm"),
    System("best block matching in quality.md", "450x375, D=48, census 9x3, 9x9", None, _OURS, "census_450"),
    System("the same, full width", "450x375, D=48, census 9x3, 9x9", None, _OURS, "census_450_full"),
    System("of two cameras: every check, subpixel", "640x480, D=64, census 9x3, 9x9", None, _OURS, "vga_64"),
    System("semi-global, three paths", "450x375, D=64, census 9x5 sparse, 3x3", None, _OURS, "sgm_450"),
    System("semi-global, three paths, single pixels", "640x480, D=128, census 9x5", None, _OURS, "sgm_640"),
    System("semi-global, three paths, single pixels", "1280x720, D=64, census 9x5", None, _OURS, "sgm_1280"),
    System(
        "semi-global, three paths, full width", "1242x375, D=128, census 9x5 sparse, 3x3", None, _OURS, "sgm_1242_f8"
    ),
]
