// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "semi_global/matching.hpp"

namespace stereo::semi_global {

/// Everything but the median, the right image as reference.
DisparityMap match_paths(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads);
DisparityMap match_paths(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads);

}  // namespace stereo::semi_global
