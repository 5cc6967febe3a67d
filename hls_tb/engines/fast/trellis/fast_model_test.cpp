// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/trellis/fast_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "definition/semi_global/matching_input.hpp"
#include "definition/trellis/models.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/random_post_processing.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using trellis::Matching;

/// Any options that the models take, for images of this width.
Matching random_options(Random& random, int width) {
   Matching m{DisparityCount{2 + random.below(std::min(width - 2, 40))}};
   m.window_px = random.percent(60) ? 1 + random.below(4) : 1 + random.below(30);
   if (random.percent(40)) m.min_disparity = random.below(2 * width) - width;
   while (semi_global::map_width(width, m.path_costs()) < 2) m.min_disparity /= 2;
   m.cost = random.percent(50) ? Cost::census : random.percent(80) ? Cost::sad : Cost::ssd;
   m.census_width_px = 3 + 2 * random.below(4);
   m.census_height_px = 3 + 2 * random.below(3);
   m.census_pattern = CensusPattern(random.below(m.census_width_px + m.census_height_px == 6 ? 3 : 4));
   if (m.cost != Cost::census && random.percent(40)) m.prefilter = Prefilter::xsobel;
   m.cost_shift = random.below(m.cost == Cost::census ? 6 : 17);
   if (random.percent(50)) m.cost_cap = 1 + random.below(random.percent(60) ? 40 : 4095);
   m.drop_cost = random.below(random.percent(70) ? 12 : 256);
   m.occlusion_cost = 1 + random.below(random.percent(70) ? 20 : 255);
   m.far_drop = 2 + random.below(random.percent(70) ? 10 : 254);
   m.mark_occluded = random.percent(70);
   m.median = random.percent(40);
   draw_post_processing(random, m);
   return m;
}

TEST(TrellisFastModel, EqualsTheReferenceWithAnyOptions) {
   Random random(test_seed());
   int with_occlusions = 0;
   for (int i = 0; i < 400; ++i) {
      const int width = 4 + random.below(100), height = 1 + random.below(20);
      const Matching matching = random_options(random, width);
      ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const int kind = random.below(10);
      if (kind == 0) pair = {GrayImage(width, height, 255), GrayImage(width, height, 0)};
      if (kind > 5) pair = shifted_pair(width, height, random.below(width), test_seed() + uint64_t(i));
      const DisparityMap expected = match_reference(pair.left, pair.right, matching);
      ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, matching)))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      with_occlusions += std::count(expected.valid.begin(), expected.valid.end(), 0) > 0 ? 1 : 0;
   }
   EXPECT_GT(with_occlusions, 60) << "or occlusions have hardly been compared";
}

TEST(TrellisFastModel, EqualsTheReferenceWithPixelsOf10And12Bits) {
   Random random(test_seed());
   for (int i = 0; i < 250; ++i) {
      const int width = 4 + random.below(90), height = 1 + random.below(20), bits = random.percent(50) ? 10 : 12;
      Matching matching = random_options(random, width);
      matching.pixel_bits = bits;
      matching.prefilter_cap = 1 + random.below(63 << (bits - 8));
      if (matching.cost == Cost::ssd) matching.window_px = std::min(matching.window_px, 11);
      const int levels = random.percent(50) ? 1 << bits : 2 + random.below(4);
      const DeepPair pair = random_deep_pair(width, height, random.bits(), bits, levels);
      ASSERT_TRUE(same_map(match_reference(pair.left, pair.right, matching),
                           match_fast(pair.left, pair.right, matching, 1 + random.below(3))))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      const ImagePair of_8_bits = random_pair(width, height, random.bits());
      ASSERT_TRUE(same_map(match_reference(of_8_bits.left, of_8_bits.right, matching),
                           match_fast(of_8_bits.left, of_8_bits.right, matching)));
   }
}

TEST(TrellisFastModel, RejectsPixelsBeyondTheRange) {
   const Matching matching{DisparityCount{4}, PixelFormat{10}};
   DeepPair pair{DeepImage(9, 9, 1023), DeepImage(9, 9)};
   EXPECT_NO_THROW(match_fast(pair.left, pair.right, matching));
   pair.right.at(3, 8) = 1024;
   EXPECT_THROW(match_fast(pair.left, pair.right, matching), std::invalid_argument);
   EXPECT_THROW(match_reference(pair.left, pair.right, matching), std::invalid_argument);
}

TEST(TrellisFastModel, EqualsTheReferenceOnLargerImages) {
   for (const NamedPair& pair : test_pairs(300, 20, 64, test_seed()))
      for (const int disparities : {31, 32, 33, 64, 128, 256}) {
         const Matching matching{DisparityCount{disparities}, MedianFilter{true}};
         EXPECT_TRUE(same_map(match_reference(pair.images.left, pair.images.right, matching),
                              match_fast(pair.images.left, pair.images.right, matching)))
             << pair.name << ' ' << disparities;
      }
}

TEST(TrellisFastModel, IsTheSameForAnyNumberOfThreads) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(400), height = 1 + random.below(60);
      const Matching matching = random_options(random, width);
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const DisparityMap expected = match_fast(pair.left, pair.right, matching);
      for (const int threads : {2, 3, 7})
         ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, matching, threads)))
             << threads << " threads, " << width << 'x' << height << ' ' << describe(matching);
   }
}

TEST(TrellisFastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 8), Matching{DisparityCount{4}}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{9}}), std::invalid_argument);
   EXPECT_THROW(
       match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{4}, trellis::Drops{.occlusion_cost = 0}}),
       std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
