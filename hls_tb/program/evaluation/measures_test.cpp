// SPDX-License-Identifier: Apache-2.0
// Every figure here is worked out by hand.
#include "program/evaluation/measures.hpp"

#include <gtest/gtest.h>

#include "definition/block_matching/models.hpp"

namespace stereo::app {
namespace {

DisparityImage row(const std::vector<float>& values) {
   DisparityImage image(int(values.size()), 1);
   image.px = values;
   return image;
}

// Errors: 0, 0.5, 0.75, 1, 2, 3, 4, 8; two invalid pixels, one without truth, one outside the mask.
TEST(Measures, OfTwelvePixels) {
   const DisparityImage truth = row({10, 10, 10, 10, 10, 10, 10, 100, 10, 10, kNoDisparity, 10});
   const DisparityImage found = row({10, 10.5F, 9.25F, 11, 8, 13, 14, 108, kNoDisparity, kNoDisparity, 3, 50});
   GrayImage mask(12, 1, 255);
   mask.at(11, 0) = 0;
   const Measures m = measure(found, truth, mask);
   EXPECT_EQ(m.pixels, 10);
   EXPECT_EQ(m.valid, 8);
   EXPECT_EQ(m.bad, (std::array<int64_t, 4>{6, 4, 3, 1})) << "errors of exactly 0.5, 1, 2 and 4 are not bad";
   EXPECT_EQ(m.d1, 2) << "4 of 10 and 8 of 100; 3 is not above 3 px";
   EXPECT_DOUBLE_EQ(m.density(), 0.8);
   EXPECT_DOUBLE_EQ(m.average_px(), 19.25 / 8);
   EXPECT_DOUBLE_EQ(m.rms_px(), std::sqrt((0.25 + 0.5625 + 1 + 4 + 9 + 16 + 64) / 8));
   EXPECT_DOUBLE_EQ(m.with_invalid(m.bad[1]), 0.6);
   EXPECT_DOUBLE_EQ(m.of_valid(m.bad[1]), 0.5);
   EXPECT_DOUBLE_EQ(m.with_invalid(m.d1), 0.4);
   EXPECT_DOUBLE_EQ(m.of_valid(m.d1), 0.25);
}

TEST(Measures, D1NeedsBothPixelsAndShare) {
   const GrayImage mask(4, 1, 255);
   const DisparityImage truth = row({20, 59, 100, 200});
   EXPECT_EQ(measure(row({23.5F, 62.5F, 103.5F, 203.5F}), truth, mask).d1, 2) << "3.5 px are over 5 % up to 70 px";
   EXPECT_EQ(measure(row({22.9F, 56.1F, 94, 189}), truth, mask).d1, 2) << "2.9 px are none; 6 of 100, 11 of 200 are";
}

TEST(Measures, OfNothingAreNotANumber) {
   const GrayImage mask(2, 1, 255);
   const Measures nothing_found = measure(row({kNoDisparity, kNoDisparity}), row({1, 2}), mask);
   EXPECT_EQ(nothing_found.density(), 0);
   EXPECT_EQ(nothing_found.with_invalid(0), 1);
   EXPECT_TRUE(std::isnan(nothing_found.of_valid(0)) && std::isnan(nothing_found.average_px()));
   const Measures no_truth = measure(row({1, 2}), row({kNoDisparity, kNoDisparity}), mask);
   EXPECT_EQ(no_truth.pixels, 0);
   EXPECT_TRUE(std::isnan(no_truth.density()) && std::isnan(no_truth.with_invalid(0)));
}

TEST(Measures, AMapOfTheCoreStandsInItsImage) {
   DisparityMap map(3, 2, 40, true);  // 2.5 px
   map.at(1, 0) = 41;
   map.valid_at(2, 1) = 0;
   for (const Reference reference : {Reference::left, Reference::right}) {
      const block_matching::Matching parameters{DisparityCount{4}, SmallestDisparity{2}, ReferenceImage{reference},
                                                SubpixelSteps{true}};
      ASSERT_EQ(map_width(9, parameters), 3);
      const int first = reference == Reference::left ? 6 : 0;
      const DisparityImage image = at_image_size(map, map_geometry(parameters, 9), 9);
      ASSERT_EQ(image.width, 9);
      ASSERT_EQ(image.height, 2);
      for (int y = 0; y < 2; ++y)
         for (int x = 0; x < 9; ++x) {
            const int column = x - first;
            const bool inside = column >= 0 && column < 3 && !(column == 2 && y == 1);
            ASSERT_EQ(has_disparity(image.at(x, y)), inside) << x << ' ' << y;
            if (!inside) continue;
            EXPECT_EQ(image.at(x, y), column == 1 && y == 0 ? 4.5625F : 4.5F) << x << ' ' << y;
         }
   }
}

}  // namespace
}  // namespace stereo::app
