// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"
#include "program/evaluation/masks.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

inline constexpr int kBadPixelTolerance = 1;  ///< pixels, as stereo benchmarks count

struct TruthScore {
   int compared = 0;  ///< pixels that count and have a valid disparity
   int bad = 0;       ///< of those, off by more than the tolerance
   int invalid = 0;   ///< pixels of the map that count and whose disparity is not valid
};

/// Compares a map with the reference image's true disparities. Pixels count where these are known and `visible` is not
/// 0. Both have the size of the reference image.
TruthScore score_against_truth(const DisparityMap& map, const MapGeometry& geometry, const DisparityImage& truth,
                               const GrayImage& visible);

/// A sentence where more than half of the true disparities lie outside of the range in which `name` looks for them, as
/// with a wrong scale; else nothing.
std::string range_remark(const std::string& name, const DisparityImage& truth, DisparityRange range);

/// A sentence where nine of ten disparities found are bad, as with a wrong scale or the truth of another image; else
/// nothing.
std::string bad_remark(const std::string& name, double bad, double compared);

}  // namespace stereo::app
