// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "definition/gray_image.hpp"
#include "phase_correlation/matching.hpp"
#include "scene/random.hpp"

namespace stereo::phase_correlation {

/// Pairs of this size that use the highest bits, which other images seldom do: of the filters' sums, as each response
/// (P1) of each scale is as large as it can be, and as small; of the differences between costs, as those beside the
/// right disparity are nearly as large as they can be. No pairs for images that are lower or narrower than a filter.
std::vector<DeepPair> own_stress_pairs(const Matching& matching, int width, int height, Random& random);

}  // namespace stereo::phase_correlation
