// SPDX-License-Identifier: Apache-2.0
// A configuration of one's own: a row in the namespace of its family. docs/options.md has the options.
#pragma once

#include "block_matching/family.hpp"

namespace stereo::block_matching::configurations {

STEREO_ROW(own_96, own, Config(), width_px = 96, height_px = 48, disparities = 24, window_px = 5, cost = Cost::census,
           slice_disparities = 12);

}  // namespace stereo::block_matching::configurations
