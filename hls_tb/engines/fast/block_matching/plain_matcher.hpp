// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::block_matching {

/// Absolute differences in windows of 3x3 or 5x5 pixels, ties to the smallest disparity, whole pixels, and no check
/// that needs other disparities than the best: only the texture check may be on, which comes afterwards.
bool is_plain(const Matching& matching);

/// Steps 2 to 4 of docs/algorithm.md for the right image as reference, images prefiltered, matching plain.
DisparityMap match_plain(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads);

}  // namespace stereo::block_matching
