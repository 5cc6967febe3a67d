# SPDX-License-Identifier: Apache-2.0
"""The files and generics of stereo_ip for one configuration."""

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
GENERICS = (
    "width_px",
    "height_px",
    "disparities",
    "window_px",
    "pixels_per_clock",
    "disparity_bits",
    "output_width_px",
    "latency_clocks",
    "flush_groups",
    "gap_groups",
)


def vhdl_files(config, core=None, shell=None):
    """All files in compile order. `core`, `shell`: other folders to take them from."""
    return manifest.vhdl_files(core or GENERATED_RTL / config) + shell_files(shell)


def shell_files(folder=None):
    return [(folder or RTL) / f"{name}.vhd" for name in SHELL]


def generics(config):
    parameters = configuration(config)
    return {name: parameters[name] for name in GENERICS}
