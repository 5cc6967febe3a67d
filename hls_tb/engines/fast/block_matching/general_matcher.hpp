// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "block_matching/matching.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::block_matching {

/// Steps 2 to 6 of docs/algorithm.md but the texture check, for the right image as reference, images prefiltered. Where
/// there is to be a confidence, the margins stand in its place.
DisparityMap match_general(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads);
DisparityMap match_general(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads);

/// The same for images of `width` columns whose census transforms, or other codes, are given: the cost is the number of
/// bits in which two differ, at most the largest cost of a census as in `matching`.
DisparityMap match_codes(const std::vector<uint64_t>& left, const std::vector<uint64_t>& right, int width,
                         const Matching& matching, int threads);

}  // namespace stereo::block_matching
