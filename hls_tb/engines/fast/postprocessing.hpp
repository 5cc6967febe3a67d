// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"
#include "support/matching_groups.hpp"
#include "support/matching_options.hpp"

namespace stereo::fast {

/// The stages of post-processing that are on (docs/algorithm.md, F1 to F3). Where there is to be a confidence, the map
/// brings the margins in its place. The map is left as it is where none is on.
void post_process(DisparityMap& map, Reference reference, const PostProcessing& options, int threads);

}  // namespace stereo::fast
