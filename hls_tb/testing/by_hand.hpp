// SPDX-License-Identifier: Apache-2.0
// Images, cost volumes and maps from their values in raster order, for cases computed by hand.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "definition/block_matching/reference_model.hpp"

namespace stereo::test {

inline GrayImage image(int width, int height, std::vector<uint8_t> pixels) {
   GrayImage result(width, height);
   EXPECT_EQ(result.pixels.size(), pixels.size());
   result.pixels = std::move(pixels);
   return result;
}

inline CostVolume volume(int width, int height, int disparities, std::vector<int> values) {
   CostVolume result(width, height, disparities);
   EXPECT_EQ(result.values.size(), values.size());
   result.values = std::move(values);
   return result;
}

inline DisparityMap map(int width, int height, std::vector<uint16_t> disparities) {
   DisparityMap result(width, height);
   EXPECT_EQ(result.disparity.size(), disparities.size());
   result.disparity = std::move(disparities);
   return result;
}

}  // namespace stereo::test
