// SPDX-License-Identifier: Apache-2.0
// Local weighted phase correlation by its definition, docs/algorithm.md, for tests: one function for each step, plain
// loops. Every step takes the right image as reference.
#pragma once

#include <array>
#include <stdexcept>

#include "definition/stages.hpp"
#include "phase_correlation/matching.hpp"

namespace stereo::phase_correlation {

/// The filters around (x,y) of one scale cover these columns and rows.
constexpr int reach_before(int scale) { return 3 * (1 << scale) - 1; }
constexpr int reach_after(int scale) { return 2 * (1 << scale); }

/// P1. Real and imaginary part of the responses of 0, +45 and -45 degrees, for a pixel whose filters lie in the image.
std::array<int, 6> responses(const GrayImage& image, int x, int y, int scale);
std::array<int, 6> responses(const DeepImage& image, int x, int y, int scale);

/// P2. Bits 6k ... 6k+5 of a pixel's code are those of scale k.
CensusImage phase_codes(const GrayImage& image, int scales);
CensusImage phase_codes(const DeepImage& image, int scales);

/// P3. The cost of two codes.
int code_cost(uint64_t a, uint64_t b, int scales);

/// P3. c(x,y,d) in the cost columns.
CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, const Matching& matching);
CostVolume pixel_costs(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// All of it, for either reference. Throws std::invalid_argument as check_matching_input does.
DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching);

}  // namespace stereo::phase_correlation
