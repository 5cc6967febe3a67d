// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"

namespace stereo::app {

/// What cv::filterSpeckles does, on the valid pixels (docs/algorithm.md, "After the core"): neighbours whose
/// disparities differ by up to `range_px` are joined, and sets of up to `window_px` joined pixels become invalid.
void remove_speckles(DisparityMap& map, int window_px, int range_px);

}  // namespace stereo::app
