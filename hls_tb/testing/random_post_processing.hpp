// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/random.hpp"
#include "support/matching_groups.hpp"

namespace stereo::test {

/// Any of its stages; often none.
inline void draw_post_processing(Random& random, PostProcessing& options) {
   options = {};
   if (random.percent(40)) return;
   if (random.percent(70)) options.support_threshold = 1 + random.below(random.percent(70) ? 8 : 35);
   options.confidence = options.has_support_filter() && random.percent(60);
   options.margin_shift = random.below(random.percent(80) ? 4 : 17);
   options.margin_weight = random.below(9);
   options.support_weight = random.below(9);
   options.fill_holes = random.percent(60);
}

}  // namespace stereo::test
