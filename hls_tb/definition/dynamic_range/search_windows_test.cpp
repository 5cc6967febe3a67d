// SPDX-License-Identifier: Apache-2.0
// The steps of the definition on cases small enough to work out by hand.
#include "definition/dynamic_range/search_windows.hpp"

#include <gtest/gtest.h>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using namespace dynamic_range;
using Ranges = Blocks<std::optional<Range>>;

constexpr Matching kSmall{DisparityCount{64}, dynamic_range::WindowRange{16}};

TEST(SearchWindows, CoarsePixelsAreRoundedMeans) {
   GrayImage image(8, 8, 10);
   image.at(0, 0) = 10 + 7;
   image.at(5, 2) = 10 + 8;
   const GrayImage coarse = coarse_image(image, 2);
   ASSERT_EQ(coarse.width, 4);
   ASSERT_EQ(coarse.height, 2);
   EXPECT_EQ(coarse.pixels, (std::vector<uint8_t>{10, 11, 11, 11, 10, 10, 10, 10}));
}

/// Makes all pixels unknown; returns a function that gives one a disparity.
auto setter(DisparityMap& coarse) {
   for (uint8_t& valid : coarse.valid) valid = 0;
   return [&coarse](int x, int y, int disparity) {
      coarse.at(x, y) = uint16_t(disparity);
      coarse.valid_at(x, y) = 1;
   };
}

TEST(SearchWindows, APixelCountsWithTwoThatAgree) {
   DisparityMap coarse(6, 4, 0);
   const auto set = setter(coarse);
   // An L of three: only its corner has two neighbours.
   set(2, 1, 5), set(3, 1, 6), set(2, 2, 4);
   const Ranges ranges = block_ranges(coarse);
   ASSERT_EQ(ranges.width, 3);
   ASSERT_EQ(ranges.height, 2);
   EXPECT_EQ(ranges.at(1, 0), (Range{20, 23}));
   for (const auto& [column, row] : {std::pair{0, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}})
      EXPECT_FALSE(ranges.at(column, row));
   // The two agree with the corner, not with each other: one more beside (2,2) makes that count too.
   set(1, 2, 3);
   EXPECT_EQ(block_ranges(coarse).at(1, 1), (Range{16, 19}));
   // A neighbour that differs by 2 or is not valid does not help.
   set(3, 1, 7);
   EXPECT_FALSE(block_ranges(coarse).at(1, 0));
   set(3, 1, 6);
   coarse.valid_at(3, 1) = 0;
   EXPECT_FALSE(block_ranges(coarse).at(1, 0));
}

TEST(SearchWindows, EachNeighbourHasItsAgreement) {
   // The centre of a cross agrees with none; with two sides that may differ by 2 it counts.
   DisparityMap coarse(6, 6, 0);
   const auto set = setter(coarse);
   set(2, 2, 5), set(1, 2, 3), set(3, 2, 7), set(2, 1, 3), set(2, 3, 7);
   const auto counts = [&](const NeighbourAgreement& agreement) {
      return block_ranges(coarse, agreement).at(1, 1).has_value();
   };
   EXPECT_FALSE(counts({}));
   EXPECT_TRUE(counts({.left = {-2, 1}, .right = {-1, 2}}));
   EXPECT_TRUE(counts({.above = {-2, 1}, .below = {-1, 2}}));
   EXPECT_FALSE(counts({.left = {-1, 2}, .right = {-1, 2}, .above = {-1, 2}}));
   EXPECT_FALSE(counts({.right = {-2, 1}, .above = {-2, 1}, .below = {-2, 1}}));
}

TEST(SearchWindows, NothingKnownLeavesTheNearbyRange) {
   const Targets targets = search_targets(Ranges(5, 2), kSmall);
   for (const int low : targets.low.values) EXPECT_EQ(low, 0);
   for (const int high : targets.high.values) EXPECT_EQ(high, 16);
}

TEST(SearchWindows, TargetsByHand) {
   Ranges ranges(6, 4);
   ranges.at(4, 0) = Range{20, 31};
   ranges.at(1, 0) = Range{40, 63};
   const Targets targets = search_targets(ranges, kSmall);
   // From the right. Blocks 5, 4, 3 see the first one: 20 - 6, 31 + 7 - 16. Block 2 sees the other: 40 - 6 is reached
   // within 8 columns only as far as 14 + 8, and 22 more; 63 + 7 - 16 is beyond the end of the range.
   EXPECT_EQ((std::vector<int>(targets.low.values.begin(), targets.low.values.begin() + 6)),
             (std::vector<int>{34, 30, 22, 14, 14, 14}));
   EXPECT_EQ((std::vector<int>(targets.high.values.begin(), targets.high.values.begin() + 6)),
             (std::vector<int>{48, 48, 48, 22, 22, 22}));
   // Blocks see one row further, not two.
   EXPECT_EQ(targets.low.at(4, 1), 14);
   EXPECT_EQ(targets.low.at(4, 2), 0);
   EXPECT_EQ(targets.high.at(4, 2), 16);
}

TEST(SearchWindows, BasesRiseBy3AndFallBy1) {
   Blocks<int> targets(6, 1);  // 48 columns
   targets.values = {0, 20, 20, 4, 4, 4};
   const std::vector<int> bases = window_bases(targets, 0, 48, kSmall);
   ASSERT_EQ(bases.size(), 33u);
   EXPECT_EQ((std::vector<int>(bases.begin(), bases.begin() + 16)),
             (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 3, 6, 9, 12, 15, 18, 18, 17}));
   // From column 15 on the window falls, so that it ends where the image ends.
   EXPECT_EQ((std::vector<int>(bases.begin() + 16, bases.end())),
             (std::vector<int>{16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST(SearchWindows, WhatIsLeftAtTheEndBelongsToTheLastBlocks) {
   // 30x19 pixels: coarse images of 7x4, 3x2 blocks.
   const Ranges ranges = block_ranges(DisparityMap(7, 4, 3));
   EXPECT_EQ(ranges.width, 3);
   EXPECT_EQ(ranges.height, 2);
   Blocks<int> targets(6, 2);  // 51 columns, 20 rows
   targets.at(5, 1) = 9;
   const std::vector<int> bases = window_bases(targets, 19, 51, {DisparityCount{32}, dynamic_range::WindowRange{16}});
   EXPECT_EQ(bases, window_bases(targets, 8, 51, {DisparityCount{32}, dynamic_range::WindowRange{16}}));
   EXPECT_EQ(bases.size(), 36u);
}

TEST(SearchWindows, StayInTheImageAndInTheRange) {
   Random random(test_seed());
   for (int i = 0; i < 300; ++i) {
      Matching matching;
      matching.window_disparities = 8 * (2 + random.below(5));
      matching.disparities = matching.window_disparities + 8 + 4 * random.below(30);
      const int width = matching.disparities / 8 * 8 + 8 + 8 * random.below(20);
      Ranges ranges(width / 8, 3);
      for (auto& range : ranges.values) {
         const int low = 4 * random.below(matching.coarse_disparities());
         if (random.percent(50)) range = Range{low, low + 3 + 4 * random.below((matching.disparities - low) / 4)};
      }
      const Targets targets = search_targets(ranges, matching);
      for (const Blocks<int>* blocks : {&targets.low, &targets.high})
         for (int band = 0; band < 3; ++band) {
            const std::vector<int> bases = window_bases(*blocks, 8 * band, width, matching);
            ASSERT_EQ(int(bases.size()), width - matching.window_disparities + 1);
            for (int x = 0; x < int(bases.size()); ++x) {
               ASSERT_GE(bases[std::size_t(x)], 0);
               ASSERT_LE(bases[std::size_t(x)], matching.last_base());
               ASSERT_LE(x + bases[std::size_t(x)] + matching.window_disparities, width);
            }
         }
   }
}

}  // namespace
}  // namespace stereo::test
