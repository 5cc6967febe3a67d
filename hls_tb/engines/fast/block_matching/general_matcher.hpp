// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::block_matching {

/// Steps 2 to 6 of docs/algorithm.md but the texture check, for the right image as reference, images prefiltered.
DisparityMap match_general(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads);

}  // namespace stereo::block_matching
