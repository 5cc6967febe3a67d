# SPDX-License-Identifier: Apache-2.0
"""Values of options that several commands have."""

import argparse
from pathlib import Path


def megahertz(text: str) -> float:
    """Of a clock that an FPGA can have."""
    try:
        mhz = float(text)
    except ValueError:
        mhz = 0
    if not 0.1 <= mhz <= 2000:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from 0.1 to 2000")
    return mhz


def a_path(text: str) -> Path:
    if not text:  # else it would be the current folder
        raise argparse.ArgumentTypeError("must not be empty")
    return Path(text)


def one_or_more(text: str) -> int:
    """A count that cannot be 0."""
    try:
        number = int(text)
    except ValueError:
        number = 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number, 1 or more")
    return number
