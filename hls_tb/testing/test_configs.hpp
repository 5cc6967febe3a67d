// SPDX-License-Identifier: Apache-2.0
// Configurations that stand on the borders of what the core can do.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "block_matching/configurations.hpp"
#include "testing/types.hpp"

namespace stereo::test {

/// Makes a configuration a type, for typed tests. W, H, D, B: image size, disparities, window; P: pixels per clock;
/// S: disparities a slice; K: clocks of the cost; G: candidates of a winner group.
template <int W, int H, int D, int B, int P, int S, int K, int G>
struct Config {
   static constexpr block_matching::Config kConfig{
       {.width_px = W, .height_px = H, .pixels_per_clock = P},
       {DisparityCount{D}, MatchingWindow{B}},
       {SliceSize{S}, block_matching::CostSteps{.cost_clocks = K}, WinnerGroup{G}}};
   static_assert(kCanBeBuilt<kConfig>);
};

/// Makes any configuration a type.
template <block_matching::Config Values>
struct Exactly {
   static constexpr block_matching::Config kConfig = Values;
   static_assert(kCanBeBuilt<kConfig>);
};

/// The members that tests vary, such as W32H12D8B3P1S3K3G2, and after a low line those that are not the default.
inline std::string config_name(const block_matching::Config& c) {
   std::string name;
   const auto add = [&name](const char* text, int value) {
      name += text + std::string(value < 0 ? "minus" : "") + std::to_string(value < 0 ? -value : value);
   };
   add("W", c.width_px);
   add("H", c.height_px);
   add("D", c.disparities);
   add("B", c.window_px);
   add("P", c.pixels_per_clock);
   add("S", c.slice_disparities);
   add("K", c.cost_clocks);
   add("G", c.winner_group);
   if (c.min_disparity != 0) add("_min", c.min_disparity);
   if (c.reference == Reference::left) name += "_left";
   if (c.cost == Cost::ssd) name += "_ssd";
   if (c.cost == Cost::census) add("_census", 10 * c.census_width_px + c.census_height_px);
   if (c.prefilter == Prefilter::xsobel) add("_xsobel", c.prefilter_cap);
   if (c.ties == Ties::largest) name += "_largest";
   if (c.has_left_right_check()) add("_lr", c.left_right_threshold);
   if (c.has_uniqueness_check()) add("_unique", c.uniqueness_percent);
   if (c.has_texture_check()) add("_texture", c.texture_threshold);
   if (c.subpixel) name += "_subpixel";
   if (c.median) name += "_median";
   if (c.aggregation == Aggregation::recursive) name += "_recursive";
   if (c.sign_memory) name += "_signs";
   return name;
}

/// Names typed tests after their configuration.
struct ConfigNames {
   template <class Type>
   static std::string GetName(int) {
      return config_name(Type::kConfig);
   }
};

/// Row of each tap, seen from the upper row of the windows' centres, by definition: all rows that the windows of P rows
/// cover; with recursive sums, first those that leave the windows, then those that enter them.
inline std::vector<int> tap_offsets(const block_matching::Config& c) {
   const int above = c.window_px / 2, below = (c.window_px - 1) / 2;
   std::vector<int> rows;
   if (c.aggregation == Aggregation::direct) {
      for (int row = -above; row <= c.pixels_per_clock - 1 + below; ++row) rows.push_back(row);
   } else {
      for (int p = 0; p < c.pixels_per_clock; ++p) rows.push_back(p - above - 1);
      for (int p = 0; p < c.pixels_per_clock; ++p) rows.push_back(p + below);
   }
   return rows;
}

/// For blocks and streams: each value of P, B, K and G with each other value somewhere; slices of one size, with rests
/// of 1, 2 and more, of at least D; the smallest images, and the narrowest over their disparities; even windows; both
/// references; disparity ranges above, around and below 0. The few have each P, both kinds of windows and references.
using FewSmallConfigs = ::testing::Types<
    Config<8, 3, 2, 3, 1, 2, 3, 2>, Config<8, 4, 7, 3, 2, 3, 2, 3>, Config<10, 8, 9, 5, 4, 4, 2, 3>,
    Exactly<block_matching::Config{{.width_px = 17, .height_px = 6, .pixels_per_clock = 2},
                                   {DisparityCount{6}, MatchingWindow{4}, ReferenceImage{Reference::left}},
                                   {SliceSize{5}, block_matching::CostSteps{.cost_clocks = 1}}}>,
    Exactly<block_matching::Config{{.width_px = 19, .height_px = 8, .pixels_per_clock = 4},
                                   {DisparityCount{5}, MatchingWindow{4}, SmallestDisparity{-2}},
                                   {SliceSize{2}, block_matching::CostSteps{.cost_clocks = 2}}}>>;
using MoreSmallConfigs = ::testing::Types<
    Config<9, 3, 8, 3, 1, 3, 1, 3>, Config<23, 7, 5, 5, 1, 2, 2, 4>, Config<8, 5, 3, 5, 1, 3, 3, 16>,
    Config<9, 6, 4, 5, 2, 2, 3, 4>, Config<40, 8, 27, 3, 2, 25, 1, 2>, Config<8, 8, 2, 3, 4, 5, 1, 2>,
    Config<8, 2, 2, 2, 1, 2, 2, 3>,
    Exactly<block_matching::Config{
        {.width_px = 16, .height_px = 8, .pixels_per_clock = 4},
        {DisparityCount{7}, MatchingWindow{6}, SmallestDisparity{2}, ReferenceImage{Reference::left}},
        {SliceSize{3}}}>,
    Exactly<block_matching::Config{
        {.width_px = 20, .height_px = 5}, {DisparityCount{8}, SmallestDisparity{-11}}, {SliceSize{3}}}>>;
using SmallConfigs = FewOrAll<FewSmallConfigs, MoreSmallConfigs>;

/// Recursive sums, of odd and even windows.
using FewRecursiveConfigs =
    ::testing::Types<Exactly<block_matching::Config{{.width_px = 13, .height_px = 10, .pixels_per_clock = 2},
                                                    {DisparityCount{6}, MatchingWindow{8}, SmallestDisparity{1},
                                                     ReferenceImage{Reference::left}, Comparison{Cost::ssd}},
                                                    {Summation{Aggregation::recursive}, SliceSize{3}}}>>;
using MoreRecursiveConfigs = ::testing::Types<
    Exactly<block_matching::Config{
        {.width_px = 12, .height_px = 5}, {DisparityCount{4}}, {Summation{Aggregation::recursive}, SliceSize{3}}}>,
    Exactly<block_matching::Config{{.width_px = 15, .height_px = 12, .pixels_per_clock = 4},
                                   {DisparityCount{6}, MatchingWindow{5}, SmallestDisparity{-1}},
                                   {Summation{Aggregation::recursive}, SliceSize{6}}}>>;

using RecursiveConfigs = FewOrAll<FewRecursiveConfigs, MoreRecursiveConfigs>;

using AllSmallConfigs = Both<SmallConfigs, RecursiveConfigs>::Configs;

}  // namespace stereo::test
