// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "definition/gray_image.hpp"
#include "dynamic_range/matching.hpp"
#include "scene/random.hpp"

namespace stereo::dynamic_range {

/// Pairs of this size that show a neighbour's agreement (Y3) that is off by one: for each of the four neighbours a pair
/// whose map changes if it may differ by 2 upward, and one if downward. Whether a random pair shows that is seen once
/// in some hundred pairs, so they are looked for with the definition. No pairs for images that are too large to look
/// for them; fewer than eight where one pair shows several, or where the tries end.
std::vector<DeepPair> own_stress_pairs(const Matching& matching, int width, int height, Random& random);

}  // namespace stereo::dynamic_range
