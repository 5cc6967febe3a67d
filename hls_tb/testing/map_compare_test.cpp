// SPDX-License-Identifier: Apache-2.0
// The helper that judges all others, judged by injected faults.
#include "testing/map_compare.hpp"

namespace stereo::test {
namespace {

TEST(MapCompare, AcceptsEqualMaps) { EXPECT_TRUE(same_map(GrayImage(5, 4, 7), GrayImage(5, 4, 7))); }

TEST(MapCompare, ShowsTheFirstDifference) {
   const GrayImage expected(5, 4, 7);
   GrayImage got = expected;
   got.at(3, 2) = 9;
   got.at(4, 3) = 9;
   const auto result = same_map(expected, got);
   EXPECT_FALSE(result);
   EXPECT_STREQ(result.message(), "x=3 y=2 expected=7 got=9 (2 of 20 differ)");
}

TEST(MapCompare, FindsADifferenceAtEveryPixel) {
   const GrayImage expected(5, 4, 7);
   for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
      GrayImage got = expected;
      got.pixels[i] ^= 1;
      EXPECT_FALSE(same_map(expected, got)) << "pixel " << i;
   }
}

TEST(MapCompare, ShowsTheDisparityInVolumes) {
   const CostVolume expected(3, 2, 4);
   CostVolume got = expected;
   got.at(1, 1, 2) = 5;
   const auto result = same_volume(expected, got);
   EXPECT_FALSE(result);
   EXPECT_STREQ(result.message(), "x=1 y=1 d=2 expected=0 got=5 (1 of 24 differ)");
}

TEST(MapCompare, RefusesNothingToCompareAndOtherSizes) {
   EXPECT_FALSE(same_map(GrayImage(), GrayImage()));
   EXPECT_FALSE(same_map(GrayImage(5, 0), GrayImage(5, 0)));
   EXPECT_FALSE(same_map(GrayImage(5, 4), GrayImage(4, 5)));
   EXPECT_FALSE(same_volume(CostVolume(), CostVolume()));
   EXPECT_FALSE(same_volume(CostVolume(2, 2, 3), CostVolume(2, 2, 4)));
}

}  // namespace
}  // namespace stereo::test
