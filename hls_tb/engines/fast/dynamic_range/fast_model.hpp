// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "dynamic_range/matching.hpp"

namespace stereo::dynamic_range {

/// Same result as match_reference, with work per pixel that does not depend on the window. Throws
/// std::invalid_argument as check_matching_input does.
DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads = 1);
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads = 1);

}  // namespace stereo::dynamic_range
