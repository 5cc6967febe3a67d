// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/matching.hpp"

namespace stereo::fast {

/// Absolute differences in windows of 3x3 or 5x5 pixels, ties to the smallest disparity, whole pixels, and no check
/// that needs other disparities than the best: only the texture check may be on, which comes afterwards.
bool is_plain(const MatchingParameters& parameters);

/// Steps 2 to 4 of docs/algorithm.md for the right image as reference, images prefiltered, parameters plain.
DisparityMap match_plain(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters);

}  // namespace stereo::fast
