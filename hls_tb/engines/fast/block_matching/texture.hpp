// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/matching.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"

namespace stereo::block_matching {

/// Takes the validity of the pixels of `map` whose windows have too little texture. `filtered` is the prefiltered right
/// image, the reference.
void check_texture(const GrayImage& filtered, const Matching& matching, DisparityMap& map, int threads);
void check_texture(const DeepImage& filtered, const Matching& matching, DisparityMap& map, int threads);

}  // namespace stereo::block_matching
