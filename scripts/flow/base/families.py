# SPDX-License-Identifier: Apache-2.0
"""What the named configurations are there for, told from their names (hls/configurations.hpp)."""

PAPER = "paper"  # the 2007 paper's core, one, two and four pixel pairs a clock
TINY = "tiny"  # the same at a size for quick tests
OPTION = "option"  # each option of the algorithm at that size
STUDY = "study"  # each option at a larger size: what it costs
SYSTEM = "system"  # the systems that the paper compares itself with, and OpenCV's StereoBM

_TINY = ("tiny", "tiny_p2", "tiny_p4")


def family(name: str) -> str:
    if name.startswith("ambrosch2007"):
        return PAPER
    if name in _TINY:
        return TINY
    if name.startswith("tiny_"):
        return OPTION
    return STUDY if name.split("_")[0] == "study" else SYSTEM


def keeps_vhdl(name: str) -> bool:
    """Whether the repository holds the VHDL. Of the others it holds the manifest and the results only: .gitignore."""
    return family(name) in (PAPER, TINY, OPTION)
