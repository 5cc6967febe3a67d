// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/dynamic_range/fast_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "definition/dynamic_range/models.hpp"
#include "scene/random.hpp"
#include "scene/scene.hpp"
#include "testing/map_compare.hpp"
#include "testing/random_post_processing.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using dynamic_range::Codes;
using dynamic_range::Matching;

Matching random_options(Random& random) {
   Matching m;
   m.window_disparities = 8 * (2 + random.below(4));
   m.disparities = std::max(32, m.window_disparities + 8 + 4 * random.below(16));
   m.window_px = 3 + 2 * random.below(8);
   m.codes = random.percent(50) ? Codes::phase : Codes::census;
   m.phase_scales = 1 + random.below(3);
   m.census_width_px = 3 + 2 * random.below(4);
   m.census_height_px = 3 + 2 * random.below(3);
   m.census_pattern = CensusPattern(random.below(m.census_width_px + m.census_height_px == 6 ? 3 : 4));
   m.subpixel = random.percent(50);
   m.median = random.percent(40);
   draw_post_processing(random, m);
   return m;
}

TEST(DynamicRangeFastModel, EqualsTheReferenceWithAnyOptions) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const Matching matching = random_options(random);
      const int width = matching.disparities + 1 + random.below(64), height = 8 + random.below(40);
      ImagePair pair = make_scene({.width = width,
                                   .height = height,
                                   .disparities = matching.disparities,
                                   .seed = test_seed() + uint64_t(i)})
                           .images;
      const int kind = random.below(10);
      if (kind == 0) pair = {GrayImage(width, height, 255), GrayImage(width, height, 0)};
      if (kind == 1) pair = random_pair(width, height, test_seed() + uint64_t(i), 4);
      ASSERT_TRUE(
          same_map(match_reference(pair.left, pair.right, matching), match_fast(pair.left, pair.right, matching)))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      const int threads = 2 + random.below(6);
      ASSERT_TRUE(
          same_map(match_fast(pair.left, pair.right, matching), match_fast(pair.left, pair.right, matching, threads)))
          << i << ": " << threads << " threads, " << width << 'x' << height << ' ' << describe(matching);
   }
}

TEST(DynamicRangeFastModel, EqualsTheReferenceWithPixelsOf10And12Bits) {
   Random random(test_seed());
   for (int i = 0; i < 30; ++i) {
      Matching matching = random_options(random);
      matching.pixel_bits = random.percent(50) ? 10 : 12;
      const int width = matching.disparities + 1 + random.below(64), height = 8 + random.below(40);
      const ImagePair narrow =
          make_scene({.width = width, .height = height, .disparities = matching.disparities, .seed = random.bits()})
              .images;
      const DeepPair pair = random.percent(80) ? deepened(narrow, matching.pixel_bits, random.bits())
                                               : random_deep_pair(width, height, random.bits(), matching.pixel_bits, 4);
      ASSERT_TRUE(same_map(match_reference(pair.left, pair.right, matching),
                           match_fast(pair.left, pair.right, matching, 1 + random.below(3))))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      // Pixels of 8 bits are taken as they are.
      const DisparityMap wanted = match_reference(widened(narrow.left), widened(narrow.right), matching);
      ASSERT_TRUE(same_map(wanted, match_reference(narrow.left, narrow.right, matching)));
      ASSERT_TRUE(same_map(wanted, match_fast(narrow.left, narrow.right, matching)));
   }
}

TEST(DynamicRangeFastModel, RejectsPixelsBeyondTheRange) {
   const Matching matching{DisparityCount{32}, PixelFormat{10}};
   DeepPair pair{DeepImage(40, 9, 1023), DeepImage(40, 9)};
   EXPECT_NO_THROW(match_fast(pair.left, pair.right, matching));
   pair.right.at(3, 8) = 1024;
   EXPECT_THROW(match_fast(pair.left, pair.right, matching), std::invalid_argument);
   EXPECT_THROW(match_reference(pair.left, pair.right, matching), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(40, 9), GrayImage(40, 9), Matching{DisparityCount{32}, PixelFormat{11}}),
                std::invalid_argument);
}

TEST(DynamicRangeFastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(match_fast(GrayImage(100, 7), GrayImage(100, 7), Matching{DisparityCount{64}}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(104, 48), GrayImage(104, 48), Matching{DisparityCount{66}}),
                std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
