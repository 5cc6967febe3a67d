# SPDX-License-Identifier: Apache-2.0
"""The files and generics of stereo_ip for one configuration."""

from pathlib import Path

from ..base.configurations import configuration
from ..base.tools import GENERATED_RTL, ROOT
from ..synthesis import manifest

RTL = ROOT / "hls" / "rtl"
# In compile order, after the core's own files.
SHELL = (
    "stream_register",
    "stream_fifo",
    "stream_credit",
    "stereo_framing",
    "stereo_frames",
    "frame_timer",
    "stereo_axis",
    "stereo_register_map",
    "stereo_registers",
    "stereo_ip",
)


def vhdl_files(config: str, shell: Path | None = None) -> list[Path]:
    """All files in compile order. `shell`: another folder to take those of the shell from."""
    return manifest.vhdl_files(GENERATED_RTL / config) + shell_files(shell)


def shell_files(folder: Path | None = None) -> list[Path]:
    return [(folder or RTL) / f"{name}.vhd" for name in SHELL]


def generics(config: str) -> dict[str, int]:
    """Those that follow from the configuration, in the order of the entity."""
    parameters = configuration(config)
    return {
        "width_px": parameters["width_px"],
        "height_px": parameters["height_px"],
        "disparities": parameters["disparities"],
        "window_px": parameters["window_px"],
        "pixels_per_clock": parameters["pixels_per_clock"],
        "disparity_bits": parameters["disparity_bits"],
        "output_width_px": parameters["output_width_px"],
        "latency_clocks": parameters["latency_clocks"],
        "flush_groups": parameters["flush_groups"],
        "gap_groups": parameters["gap_groups"],
    }
