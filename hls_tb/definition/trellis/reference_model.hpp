// SPDX-License-Identifier: Apache-2.0
// The trellis by its definition, docs/algorithm.md, for tests: one function for each step, plain loops.
#pragma once

#include <stdexcept>

#include "definition/stages.hpp"
#include "trellis/matching.hpp"

namespace stereo::trellis {

/// c(x,y,d) with the left image as reference, for the columns of the map.
CostVolume left_costs(const GrayImage& left, const GrayImage& right, const Matching& matching);
CostVolume left_costs(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// The forward pass over one row: [x][d].
struct Row {
   std::vector<std::vector<int>> path;      ///< E
   std::vector<std::vector<int>> decision;  ///< 0 stay, 1 near drop, 2 far drop, 3 occluded
};
Row forward(const CostVolume& costs, int y, const Matching& matching);

/// Of one row, by column; kNoPartner where no partner was found.
inline constexpr int kNoPartner = -1;
std::vector<int> traced_back(const Row& row, const Matching& matching);

/// Occluded pixels get the disparity to their left.
std::vector<int> filled(std::vector<int> disparities);

/// All of it. Throws std::invalid_argument as check_matching_input does.
DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching);

}  // namespace stereo::trellis
