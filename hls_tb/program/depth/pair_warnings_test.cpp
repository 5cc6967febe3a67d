// SPDX-License-Identifier: Apache-2.0
// What is said of generated pairs whose disparities are known, as they are and damaged.
#include "program/depth/pair_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "definition/block_matching/models.hpp"
#include "scene/scene.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

constexpr int kWidth = 320, kHeight = 240, kDisparities = 64;

ImagePair scene(uint64_t more_seed = 0) {
   return make_scene(
              {.width = kWidth, .height = kHeight, .disparities = kDisparities, .seed = test::test_seed() + more_seed})
       .images;
}

MapGeometry geometry_of(int first, int count) { return {Reference::left, 0, kWidth, count, first, false}; }
const MapGeometry kGeometry = geometry_of(0, kDisparities);

GrayImage moved_down(const GrayImage& image, int rows) {
   GrayImage lower(image.width, image.height);
   for (int y = rows; y < image.height; ++y) std::copy_n(image.row(y - rows), image.width, lower.row(y));
   return lower;
}

std::optional<VerticalOffset> offset_of(const ImagePair& pair) { return vertical_offset(matched_features(pair)); }

TEST(PairWarning, SaysNothingOfRectifiedOrTinyOrUnrelatedImages) {
   const ImagePair pair = scene();
   ASSERT_TRUE(offset_of(pair));
   EXPECT_LE(offset_of(pair)->median_px, 0.5);
   EXPECT_EQ(pair_warning(pair, kGeometry), "");
   EXPECT_EQ(pair_warning(pair, geometry_of(-16, kDisparities + 32)), "");
   EXPECT_FALSE(offset_of({GrayImage(32, 12), GrayImage(32, 12)}));
   EXPECT_FALSE(offset_of({GrayImage(1, 1), GrayImage(1, 1)}));
   EXPECT_FALSE(offset_of({GrayImage(300, 200, 90), GrayImage(300, 200, 90)})) << "no features";
   EXPECT_EQ(pair_warning({pair.left, pair.left}, kGeometry), "");
   EXPECT_EQ(pair_warning({GrayImage(kWidth, kHeight, 90), scene(9).left}, kGeometry), "");
}

TEST(PairWarning, RowsThatDoNotFit) {
   const ImagePair pair = scene();
   const ImagePair lower{pair.left, moved_down(pair.right, 5)};
   ASSERT_TRUE(offset_of(lower));
   EXPECT_NEAR(offset_of(lower)->median_px, 5, 0.5);
   EXPECT_NE(pair_warning(lower, kGeometry).find("5.0 rows apart"), std::string::npos);
}

TEST(PairWarning, LeftAndRightExchanged) {
   for (const uint64_t seed : {0U, 1U, 2U}) {
      const ImagePair pair = scene(seed);
      const std::string warning = pair_warning({pair.right, pair.left}, kGeometry);
      EXPECT_EQ(warning.find("warning: left and right look exchanged"), 0U) << warning;
      EXPECT_EQ(pair_warning({pair.right, pair.left}, geometry_of(-kDisparities, kDisparities + 1)), "")
          << "what is searched is what is there";
   }
}

TEST(PairWarning, RangesThatAreTooShort) {
   const ImagePair pair = scene();
   const std::string above = pair_warning(pair, geometry_of(0, 16));
   EXPECT_NE(above.find("0 ... 15 px, looks too short"), std::string::npos) << above;
   EXPECT_NE(above.find("--set disparities"), std::string::npos) << above;
   const std::string below = pair_warning(pair, geometry_of(40, 64));
   EXPECT_NE(below.find("lie below it"), std::string::npos) << below;
   EXPECT_NE(below.find("--set min_disparity"), std::string::npos) << below;
}

TEST(LastDisparityWarning, IsOfManyPixelsThere) {
   const ImagePair pair = scene();
   const auto warning = [&](int disparities, bool subpixel) {
      const block_matching::Matching parameters{DisparityCount{disparities}, MatchingWindow{9},
                                                ReferenceImage{Reference::left}, SubpixelSteps{subpixel}};
      return last_disparity_warning(match_fast(pair.left, pair.right, parameters), map_geometry(parameters, kWidth));
   };
   for (const bool subpixel : {false, true}) {
      EXPECT_EQ(warning(kDisparities, subpixel), "");
      EXPECT_NE(warning(16, subpixel).find("have the last disparity of the range, 15 px"), std::string::npos)
          << warning(16, subpixel);
   }
   DisparityMap none(50, 40, 15);
   std::fill(none.valid.begin(), none.valid.end(), uint8_t(0));
   EXPECT_EQ(last_disparity_warning(none, geometry_of(0, 16)), "") << "no pixel is valid";
   EXPECT_NE(last_disparity_warning(DisparityMap(50, 40, 15), geometry_of(0, 16)), "");
   EXPECT_EQ(last_disparity_warning(DisparityMap(20, 10, 15), geometry_of(0, 16)), "") << "a few pixels say nothing";
   EXPECT_EQ(last_disparity_warning(DisparityMap(50, 40, 7), geometry_of(0, 8)), "") << "of few, one holds many";
}

}  // namespace
}  // namespace stereo::app
