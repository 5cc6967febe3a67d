// SPDX-License-Identifier: Apache-2.0
// Configurations that stand on the borders of what the core can do.
#pragma once

#include <gtest/gtest.h>

#include "configurations.hpp"

namespace stereo::test {

inline constexpr StereoConfig kSmallest{.width_px = 3, .height_px = 3, .disparities = 2};
inline constexpr StereoConfig kNarrow{.width_px = 9, .height_px = 3, .disparities = 8, .winner_group = 3};
inline constexpr StereoConfig kTall{.width_px = 7, .height_px = 23, .disparities = 3, .winner_group = 2};
inline constexpr StereoConfig kFive{.width_px = 23, .height_px = 7, .disparities = 5, .window_px = 5};
inline constexpr StereoConfig kFiveSmallest{.width_px = 4, .height_px = 5, .disparities = 3, .window_px = 5};
inline constexpr StereoConfig kFiveNarrow{
    .width_px = 10, .height_px = 5, .disparities = 9, .window_px = 5, .winner_group = 2};
inline constexpr StereoConfig kFiveWide{
    .width_px = 90, .height_px = 11, .disparities = 64, .window_px = 5, .winner_group = 16};
inline constexpr StereoConfig kAllDisparities{.width_px = 270, .height_px = 4, .disparities = 256};
inline constexpr StereoConfig kAwkward{.width_px = 311, .height_px = 239, .disparities = 37, .winner_group = 7};

/// Makes a configuration a type, for typed tests.
template <const StereoConfig& C>
struct ConfigType {
   static constexpr const StereoConfig& kConfig = C;
};

using SmallConfigs = ::testing::Types<ConfigType<kSmallest>, ConfigType<kNarrow>, ConfigType<kTall>, ConfigType<kFive>,
                                      ConfigType<kFiveSmallest>, ConfigType<kFiveNarrow>, ConfigType<kFiveWide>,
                                      ConfigType<kAllDisparities>, ConfigType<configurations::tiny>>;

}  // namespace stereo::test
