// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::app {

inline constexpr int kBadPixelTolerance = 1;  ///< pixels, as stereo benchmarks count

struct TruthScore {
   int compared = 0;  ///< visible pixels that have a valid disparity
   int bad = 0;       ///< of those, off by more than the tolerance
   int invalid = 0;   ///< visible pixels of the map whose disparity is not valid
};

/// Compares a map with the reference image's true disparities, in whole pixels; `visible` is 0 where they do not count.
/// Both have the size of the reference image. Only `visible` says what counts: 0 in `truth` is a disparity of 0, where
/// `measure` (measures.hpp) leaves out what load_disparities takes for unknown.
TruthScore score_against_truth(const DisparityMap& map, const MapGeometry& geometry, const GrayImage& truth,
                               const GrayImage& visible);

}  // namespace stereo::app
