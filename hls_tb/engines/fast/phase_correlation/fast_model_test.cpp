// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/phase_correlation/fast_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "definition/block_matching/matching_input.hpp"
#include "definition/phase_correlation/models.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/random_post_processing.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using phase_correlation::Matching;

/// Any options that the models take, for images of this width.
Matching random_options(Random& random, int width) {
   Matching m{DisparityCount{1 + random.below(std::min(width - 2, 40))}};
   m.window_px = random.percent(60) ? 1 + random.below(9) : 1 + random.below(30);
   if (random.percent(40)) m.min_disparity = random.below(2 * width) - width;
   while (block_matching::cost_columns(width, m.block_matching()) < 2) m.min_disparity /= 2;
   m.reference = random.percent(50) ? Reference::right : Reference::left;
   m.phase_scales = 1 + random.below(3);
   m.ties = random.percent(50) ? Ties::smallest : Ties::largest;
   if (random.percent(40)) m.left_right_threshold = random.below(m.disparities);
   if (random.percent(40)) m.uniqueness_percent = random.below(101);
   m.subpixel = random.percent(50);
   m.median = random.percent(40);
   m.full_width = random.percent(40) && m.window_px >= 2 && m.window_px < width;
   if (m.full_width && random.percent(50)) {
      m.first_disparity = random.below(m.disparities);
      m.last_disparity = random.below(m.disparities + 1) - 1;
   }
   draw_post_processing(random, m);
   return m;
}

TEST(PhaseCorrelationFastModel, EqualsTheReferenceWithAnyOptions) {
   Random random(test_seed());
   for (int i = 0; i < 300; ++i) {
      // Also images that are smaller than the filters.
      const int width = 4 + random.below(70), height = 1 + random.below(40);
      const Matching matching = random_options(random, width);
      ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const int kind = random.below(10);
      if (kind == 0) pair = {GrayImage(width, height, 255), GrayImage(width, height, 0)};
      if (kind > 5) pair = shifted_pair(width, height, random.below(width), test_seed() + uint64_t(i));
      ASSERT_TRUE(
          same_map(match_reference(pair.left, pair.right, matching), match_fast(pair.left, pair.right, matching)))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      const int threads = 2 + random.below(6);
      ASSERT_TRUE(
          same_map(match_fast(pair.left, pair.right, matching), match_fast(pair.left, pair.right, matching, threads)))
          << i << ": " << threads << " threads, " << width << 'x' << height << ' ' << describe(matching);
   }
}

TEST(PhaseCorrelationFastModel, EqualsTheReferenceWithPixelsOf10And12Bits) {
   Random random(test_seed());
   for (int i = 0; i < 150; ++i) {
      const int width = 4 + random.below(70), height = 1 + random.below(40), bits = random.percent(50) ? 10 : 12;
      Matching matching = random_options(random, width);
      matching.pixel_bits = bits;
      const int levels = random.percent(50) ? 1 << bits : 2 + random.below(4);
      const DeepPair pair = random_deep_pair(width, height, random.bits(), bits, levels);
      ASSERT_TRUE(same_map(match_reference(pair.left, pair.right, matching),
                           match_fast(pair.left, pair.right, matching, 1 + random.below(3))))
          << i << ": " << width << 'x' << height << ' ' << describe(matching);
      // Pixels of 8 bits are taken as they are.
      const ImagePair narrow = random_pair(width, height, random.bits());
      const DisparityMap wanted = match_reference(widened(narrow.left), widened(narrow.right), matching);
      ASSERT_TRUE(same_map(wanted, match_reference(narrow.left, narrow.right, matching)));
      ASSERT_TRUE(same_map(wanted, match_fast(narrow.left, narrow.right, matching)));
   }
}

TEST(PhaseCorrelationFastModel, RejectsPixelsBeyondTheRange) {
   const Matching matching{DisparityCount{4}, PixelFormat{10}};
   DeepPair pair{DeepImage(9, 9, 1023), DeepImage(9, 9)};
   EXPECT_NO_THROW(match_fast(pair.left, pair.right, matching));
   pair.right.at(3, 8) = 1024;
   EXPECT_THROW(match_fast(pair.left, pair.right, matching), std::invalid_argument);
   EXPECT_THROW(match_reference(pair.left, pair.right, matching), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{4}, PixelFormat{11}}),
                std::invalid_argument);
}

TEST(PhaseCorrelationFastModel, EqualsTheReferenceOnLargerImages) {
   for (const NamedPair& pair : test_pairs(150, 40, 64, test_seed()))
      for (const int scales : {1, 2, 3}) {
         const Matching matching{DisparityCount{40}, phase_correlation::PhaseScales{scales}, SubpixelSteps{true}};
         EXPECT_TRUE(same_map(match_reference(pair.images.left, pair.images.right, matching),
                              match_fast(pair.images.left, pair.images.right, matching)))
             << pair.name << ' ' << scales;
      }
}

TEST(PhaseCorrelationFastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 8), Matching{DisparityCount{4}}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{9}}), std::invalid_argument);
   EXPECT_THROW(
       match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{4}, phase_correlation::PhaseScales{4}}),
       std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
