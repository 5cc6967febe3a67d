// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "trellis/matching.hpp"

namespace stereo::trellis {

/// The same map as the reference model, much faster; images of any size. Throws std::invalid_argument as
/// check_matching_input does.
DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads = 1);
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads = 1);

}  // namespace stereo::trellis
