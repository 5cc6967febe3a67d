// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fuzz/targets.hpp"
#include "program/io/pfm.hpp"

namespace stereo::fuzz {

/// What every reader of disparities promises of a map.
inline void check_map(const app::DisparityImage& map) {
   promise(map.width >= 1 && map.height >= 1, "a map has pixels");
   promise(map.px.size() == std::size_t(map.width) * std::size_t(map.height), "a map has all its pixels");
   for (const float value : map.px)
      promise(!app::has_disparity(value) || std::abs(value) <= app::kLargestDisparity, "a disparity is in range");
}

}  // namespace stereo::fuzz
