// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "block_matching/matching.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::block_matching {

/// The same map as match_reference, for parameter studies: below a millisecond a frame at 320x240 with 100 disparities
/// and a plain 3x3 window, some milliseconds with any options and any window (benchmark/stereo_bench.cpp measures
/// both). The map is the same for any number of threads. Throws std::invalid_argument as check_matching_input does.
DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads = 1);
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads = 1);

}  // namespace stereo::block_matching
