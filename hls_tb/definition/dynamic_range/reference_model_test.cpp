// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/reference_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "definition/dynamic_range/models.hpp"
#include "definition/phase_correlation/models.hpp"
#include "scene/scene.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using dynamic_range::Codes;
using dynamic_range::Matching;

/// Percent of the visible pixels of a map whose disparity is off by more than 1.
double bad_percent(const DisparityMap& map, const Scene& scene) {
   int bad = 0, all = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (scene.visible.at(x, y) == 0) continue;
         ++all;
         bad += std::abs(map.at(x, y) - scene.disparity.at(x, y)) > 1 ? 1 : 0;
      }
   return 100.0 * bad / all;
}

/// Left(x + shift) shows what right(x) shows: spots of several pixels, so that the coarse images show them too.
ImagePair spotted_pair(int width, int height, int shift, uint64_t seed) {
   const GrayImage grain = random_pair(width + shift + 6, height + 6, seed).left;
   GrayImage spots(width + shift, height);
   for (int y = 0; y < spots.height; ++y)
      for (int x = 0; x < spots.width; ++x) {
         int sum = 0;
         for (int j = 0; j < 7; ++j)
            for (int i = 0; i < 7; ++i) sum += grain.at(x + i, y + j) - 128;
         spots.at(x, y) = uint8_t(std::clamp(128 + sum / 8, 0, 255));
      }
   ImagePair pair{GrayImage(width, height), GrayImage(width, height)};
   for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
         pair.left.at(x, y) = spots.at(x, y);
         pair.right.at(x, y) = spots.at(x + shift, y);
      }
   return pair;
}

TEST(DynamicRange, FindsAShiftAnywhereInTheRange) {
   for (const Codes codes : {Codes::phase, Codes::census})
      for (const int shift : {0, 5, 17, 30, 47, 60}) {
         const Matching matching{DisparityCount{64}, dynamic_range::WindowRange{16}, MatchingWindow{7},
                                 dynamic_range::ComparedCodes{codes}};
         const ImagePair pair = spotted_pair(160, 48, shift, test_seed());
         const DisparityMap map = match_reference(pair.left, pair.right, matching);
         // Without the border, and where the other image shows the pixel.
         int wrong = 0;
         for (int y = 8; y < 40; ++y)
            for (int x = 8; x < 80; ++x) wrong += map.at(x, y) != shift ? 1 : 0;
         EXPECT_LE(wrong, 32 * 72 / 8) << "shift " << shift << " codes " << int(codes);
      }
}

/// The paper rejects systems with a dynamic range for the frames that they need to find a new object.
TEST(DynamicRange, FindsANewObjectInTheFrameInWhichItAppears) {
   const Matching matching{DisparityCount{128}, dynamic_range::WindowRange{16}};
   SceneOptions options{.width = 480, .height = 360, .disparities = 128, .seed = test_seed()};
   double worst = 0, before = 0;
   for (options.frame = kNewObjectFrames - 1; options.frame <= 3 * kNewObjectFrames; ++options.frame) {
      const Scene scene = make_scene(options);
      const double bad = bad_percent(match_fast(scene.images.left, scene.images.right, matching), scene);
      if (options.frame % kNewObjectFrames == 0) worst = std::max(worst, bad - before);
      before = bad;
   }
   EXPECT_LT(worst, 2.0) << "percent more in the frame with the new object than in the frame before";
}

TEST(DynamicRange, MatchesWhatSearchesTheWholeRange) {
   const Scene scene = make_scene({.width = 480, .height = 360, .disparities = 128, .seed = test_seed()});
   const phase_correlation::Matching whole{DisparityCount{128}};
   const Matching matching{DisparityCount{128}, dynamic_range::WindowRange{16}};
   const double searched = bad_percent(match_fast(scene.images.left, scene.images.right, whole), scene);
   const double followed = bad_percent(match_fast(scene.images.left, scene.images.right, matching), scene);
   EXPECT_LT(followed, searched + 6) << "percent, " << searched << " with all disparities";
}

TEST(DynamicRange, RejectsWhatItCannotMatch) {
   const Matching matching{DisparityCount{64}};
   EXPECT_THROW(match_reference(GrayImage(104, 7), GrayImage(104, 7), matching), std::invalid_argument);
   EXPECT_THROW(match_reference(GrayImage(64, 48), GrayImage(64, 48), matching), std::invalid_argument);
   EXPECT_THROW(match_reference(GrayImage(104, 48), GrayImage(104, 40), matching), std::invalid_argument);
   EXPECT_THROW(match_reference(GrayImage(104, 48), GrayImage(104, 48), Matching{DisparityCount{66}}),
                std::invalid_argument);
   EXPECT_THROW(
       match_reference(GrayImage(104, 48), GrayImage(104, 48), Matching{DisparityCount{64}, MatchingWindow{4}}),
       std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
