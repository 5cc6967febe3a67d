// SPDX-License-Identifier: Apache-2.0
// Block matching by its definition, docs/algorithm.md, for tests: the stages of definition/stages.hpp, one after the
// other.
//
// Every stage takes the right image as reference. Column x of a volume is cost column first_cost_column() + x.
#pragma once

#include <stdexcept>

#include "block_matching/matching.hpp"
#include "definition/stages.hpp"

namespace stereo::block_matching {

/// 1. and 2. c(x,y,d), prefilter or census transform included: a volume of cost_columns() x H x D. Throws
/// std::invalid_argument as check_matching_input does. A reference in the options is of no account.
CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, const Matching& matching);
CostVolume pixel_costs(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// 5. 1 where the window has texture, else 0. `filtered` is the prefiltered right image, of the whole width.
GrayImage texture_check(const GrayImage& filtered, const Matching& matching);
GrayImage texture_check(const DeepImage& filtered, const Matching& matching);

/// All of it, for either reference: the disparity map, map_width() x H. Throws std::invalid_argument as
/// check_matching_input does.
DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching);

}  // namespace stereo::block_matching
