# SPDX-License-Identifier: Apache-2.0
"""What a configuration does in a clock and in a second."""


def clocks_per_frame(parameters):
    """Frames as close to each other as they may be take a clock for each group of pixel pairs and, with recursive sums, for
    each group of the gap between them; co-simulation measures the same."""
    return parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"] + parameters["gap_groups"]


def middle_rows(parameters, least):
    """ "A:B", the fewest rows around the middle, `least` or more, that give an output; None when only the whole frame does."""
    lanes, height = parameters["pixels_per_clock"], parameters["height_px"]
    groups = max(-(-least // lanes), -(-parameters["groups_to_first_output"] // parameters["width_px"]))
    rows = groups * lanes
    if rows >= height:
        return None
    first = (height - rows) // 2
    return f"{first}:{first + rows}"


def evaluations_per_frame(parameters):
    """Disparity evaluations as publications count them: W*H*D."""
    return parameters["width_px"] * parameters["height_px"] * parameters["disparities"]


def evaluations_per_clock(parameters):
    return evaluations_per_frame(parameters) / clocks_per_frame(parameters)


def speed(parameters, fmax_mhz, luts):
    """Frames a second, million disparity evaluations a second, and evaluations a second for each LUT."""
    frames = fmax_mhz * 1e6 / clocks_per_frame(parameters)
    evaluations = frames * evaluations_per_frame(parameters)
    return {
        "frames_per_second": frames,
        "mde_per_second": evaluations / 1e6,
        "evaluations_per_second_per_lut": evaluations / luts,
    }


def lut_count(result):
    """LUTs or ALUTs of one target's result."""
    return result["aluts"] if "aluts" in result else result["luts"]
