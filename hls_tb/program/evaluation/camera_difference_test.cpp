// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/camera_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stereo::app {
namespace {

TEST(CameraDifference, ChangesTheRightImageOnly) {
   ImagePair pair{GrayImage(2, 1, 100), GrayImage(2, 1, 100)};
   pair.right.pixels = {101, 250};
   const ImagePair seen = seen_by(pair, {.gain = 1.5, .offset = -10});
   EXPECT_EQ(seen.left, pair.left);
   EXPECT_EQ(seen.right.pixels, (std::vector<uint8_t>{142, 255})) << "141.5 is rounded, 365 is clamped";
   EXPECT_EQ(seen_by(pair, {}).right, pair.right);
}

TEST(CameraDifference, PixelsOfMoreBitsAreClampedToTheirs) {
   DeepPair pair{DeepImage(2, 1, 1000), DeepImage(2, 1, 1000)};
   pair.right.pixels = {1001, 3000};
   EXPECT_EQ(seen_by(pair, {.gain = 1.5, .offset = -10}, 12).right.pixels, (std::vector<uint16_t>{1492, 4095}));
   EXPECT_EQ(seen_by(pair, {.gain = 1.5}, 10).right.pixels, (std::vector<uint16_t>{1023, 1023}));
}

TEST(CameraDifference, NoiseHasItsDeviationInBothImages) {
   const ImagePair grey{GrayImage(200, 100, 128), GrayImage(200, 100, 128)};
   const ImagePair seen = seen_by(grey, {.noise = 4});
   EXPECT_NE(seen.left, seen.right);
   for (const GrayImage& image : {seen.left, seen.right}) {
      double sum = 0, squares = 0;
      for (const uint8_t pixel : image.pixels) {
         sum += pixel - 128;
         squares += (pixel - 128) * (pixel - 128);
      }
      EXPECT_NEAR(sum / 20000, 0, 0.2);
      EXPECT_NEAR(std::sqrt(squares / 20000), 4, 0.2);
   }
   EXPECT_NE(seen_by(grey, {.noise = 4, .seed = 2}).left, seen.left);
   EXPECT_EQ(seen_by(grey, {.noise = 4}).left, seen.left);
}

}  // namespace
}  // namespace stereo::app
