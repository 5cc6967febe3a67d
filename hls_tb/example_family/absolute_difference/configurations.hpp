// SPDX-License-Identifier: Apache-2.0
// The named configurations of the example family.
#pragma once

#include "absolute_difference/config.hpp"
#include "support/configuration.hpp"

namespace stereo::absolute_difference::configurations {

STEREO_ROW(example, example, Config(), width_px = 24, height_px = 8);
STEREO_ROW(example_p2_delayed, example, example, pixels_per_clock = 2, least_difference = 10, delay_groups = 5);

}  // namespace stereo::absolute_difference::configurations
