// SPDX-License-Identifier: Apache-2.0
// Semi-global matching by its definition, docs/algorithm.md, for tests: one function for each step, plain loops.
//
// Every step takes the right image as reference. Column x of a volume is column x of the map.
#pragma once

#include <stdexcept>

#include "definition/stages.hpp"
#include "semi_global/matching.hpp"

namespace stereo::semi_global {

/// c(x,y,d), for the columns of the map: all cost columns.
CostVolume path_costs(const GrayImage& left, const GrayImage& right, const Matching& matching);
CostVolume path_costs(const DeepImage& left, const DeepImage& right, const Matching& matching);

enum class RowDirection { from_left, from_right };

/// K of a row path. relief: as reliefs() gives it.
CostVolume row_path(const CostVolume& costs, const DeepImage& relief, RowDirection direction, const Matching& matching);

/// K of the path from above.
CostVolume path_from_above(const CostVolume& costs, const Matching& matching);

/// The sum of the paths that are on.
CostVolume path_sums(const CostVolume& costs, const DeepImage& relief, const Matching& matching);

/// All of it, for either reference. Throws std::invalid_argument as check_matching_input does.
DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching);
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching);

}  // namespace stereo::semi_global
