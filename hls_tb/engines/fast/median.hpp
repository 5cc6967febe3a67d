// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"

namespace stereo::fast {

/// Each disparity becomes the median of the 3x3 around it; the border repeats. Validity stays.
DisparityMap median_3x3(const DisparityMap& map, int threads);

}  // namespace stereo::fast
