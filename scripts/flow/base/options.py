# SPDX-License-Identifier: Apache-2.0
"""Values of options that several commands have."""

import argparse


def megahertz(text: str) -> float:
    """Of a clock that an FPGA can have."""
    try:
        mhz = float(text)
    except ValueError:
        mhz = 0
    if not 0.1 <= mhz <= 2000:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from 0.1 to 2000")
    return mhz
