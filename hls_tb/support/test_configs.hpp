// SPDX-License-Identifier: Apache-2.0
// Configurations that stand on the borders of what the core can do.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "configurations.hpp"

namespace stereo::test {

/// Makes a configuration a type, for typed tests. W, H, D, B: image size, disparities, window; P: pixels per clock;
/// S: disparities a slice; K: clocks of the cost; G: candidates of a winner group.
template <int W, int H, int D, int B, int P, int S, int K, int G>
struct Config {
   static constexpr StereoConfig kConfig{.width_px = W,
                                         .height_px = H,
                                         .disparities = D,
                                         .window_px = B,
                                         .pixels_per_clock = P,
                                         .slice_disparities = S,
                                         .cost_clocks = K,
                                         .winner_group = G};
   static_assert(CheckedConfig<kConfig>::kValid);
};

/// Names typed tests after their configuration, such as W32H12D8B3P1S3K3G2.
struct ConfigNames {
   template <class Type>
   static std::string GetName(int) {
      constexpr const StereoConfig& c = Type::kConfig;
      std::string name;
      const auto add = [&name](char letter, int value) { name += letter + std::to_string(value); };
      add('W', c.width_px);
      add('H', c.height_px);
      add('D', c.disparities);
      add('B', c.window_px);
      add('P', c.pixels_per_clock);
      add('S', c.slice_disparities);
      add('K', c.cost_clocks);
      add('G', c.winner_group);
      return name;
   }
};

/// For blocks and streams: each value of P, B, K and G with each other value somewhere; slices of one size, with rests
/// of 1, 2 and more, of at least D; the smallest images, and the narrowest over their disparities.
using SmallConfigs =
    ::testing::Types<Config<8, 3, 2, 3, 1, 2, 3, 2>, Config<9, 3, 8, 3, 1, 3, 1, 3>, Config<8, 23, 3, 3, 1, 25, 2, 4>,
                     Config<23, 7, 5, 5, 1, 2, 2, 2>, Config<8, 5, 3, 5, 1, 3, 3, 16>, Config<10, 5, 9, 5, 1, 4, 1, 4>,
                     Config<8, 4, 7, 3, 2, 3, 2, 3>, Config<9, 6, 4, 5, 2, 2, 3, 4>, Config<40, 8, 27, 3, 2, 25, 1, 2>,
                     Config<8, 8, 2, 3, 4, 5, 1, 2>, Config<10, 8, 9, 5, 4, 4, 2, 3>,
                     Config<32, 12, 16, 3, 4, 8, 3, 4>>;

/// For the whole core, beside the small ones: larger images and disparity ranges.
using LargeConfigs = ::testing::Types<
    Config<90, 11, 64, 5, 1, 25, 3, 16>, Config<270, 4, 256, 3, 1, 25, 3, 2>, Config<32, 12, 8, 3, 1, 3, 3, 2>,
    Config<60, 9, 33, 3, 1, 8, 2, 3>, Config<41, 13, 21, 5, 1, 10, 1, 2>, Config<50, 10, 26, 3, 1, 25, 3, 4>,
    Config<32, 12, 8, 3, 2, 3, 3, 2>, Config<45, 6, 40, 5, 2, 13, 1, 3>, Config<270, 6, 256, 5, 2, 64, 2, 4>,
    Config<31, 10, 17, 3, 2, 4, 3, 3>, Config<9, 6, 8, 5, 2, 7, 2, 2>, Config<32, 12, 8, 3, 4, 3, 3, 2>,
    Config<40, 8, 27, 5, 4, 25, 3, 2>, Config<40, 8, 27, 3, 4, 25, 1, 3>, Config<61, 8, 50, 5, 4, 9, 1, 4>,
    Config<33, 20, 11, 3, 4, 2, 2, 3>, Config<270, 8, 256, 3, 4, 100, 3, 16>, Config<8, 8, 7, 5, 4, 6, 3, 4>,
    Config<24, 16, 10, 5, 4, 3, 2, 2>>;

}  // namespace stereo::test
