// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/fast_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "definition/semi_global/models.hpp"
#include "engines/option_values.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/random_post_processing.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using semi_global::Matching;

std::string text_of(const Matching& matching) {
   std::string text;
   for (const OptionValue& option : option_values(matching)) {
      text += option.name + "=";
      if (const int* number = std::get_if<int>(&option.value)) text += std::to_string(*number);
      else if (const bool* flag = std::get_if<bool>(&option.value)) text += *flag ? "true" : "false";
      else text += std::get<std::string>(option.value);
      text += " ";
   }
   return text;
}

/// Any options that the models take, for images of this size.
Matching random_options(Random& random, int width) {
   Matching m{DisparityCount{2 + random.below(std::min(width - 2, random.percent(20) ? 255 : 24))}};
   m.window_px = random.percent(60) ? 1 + random.below(4) : 1 + random.below(30);
   if (random.percent(40)) m.min_disparity = random.below(2 * width) - width;
   while (map_width(width, m) < 2) m.min_disparity /= 2;
   m.reference = random.percent(50) ? Reference::left : Reference::right;
   m.cost = random.percent(50) ? Cost::census : random.percent(80) ? Cost::sad : Cost::ssd;
   m.census_width_px = 3 + 2 * random.below(4);
   m.census_height_px = 3 + 2 * random.below(3);
   m.census_pattern = CensusPattern(random.below(m.census_width_px + m.census_height_px == 6 ? 3 : 4));
   if (m.cost != Cost::census && random.percent(40)) m.prefilter = Prefilter::xsobel;
   m.prefilter_cap = 1 + random.below(63);
   m.cost_shift = random.below(m.cost == Cost::census ? 6 : 17);
   if (random.percent(50)) m.cost_cap = 1 + random.below(random.percent(60) ? 40 : 4095);
   m.path_left = random.percent(80);
   m.path_right = random.percent(80);
   m.path_above = random.percent(80);
   if (!m.path_left && !m.path_right) m.path_above = true;
   m.p1 = random.below(random.percent(70) ? 12 : random.percent(70) ? 100 : 4096);
   m.p2 = random.below(random.percent(70) ? 61 : random.percent(70) ? 301 : 4096);
   if (random.percent(50)) m.p2_least = random.below(m.p2 + 2);
   if (random.percent(40)) m.above_p1 = random.below(random.percent(80) ? 20 : 4096);
   if (random.percent(40)) m.above_p2 = random.below(random.percent(80) ? 80 : 4096);
   m.ties = random.percent(50) ? Ties::largest : Ties::smallest;
   if (random.percent(50)) m.left_right_threshold = random.below(std::min(m.disparities, 4));
   if (random.percent(50)) m.uniqueness_distance = random.below(random.percent(80) ? 12 : 4096);
   m.subpixel = random.percent(50);
   m.median = random.percent(50);
   m.full_width = random.percent(40) && m.window_px >= 3 && m.window_px < width;
   if (m.full_width && random.percent(50)) {
      m.first_disparity = random.below(m.disparities);
      m.last_disparity = random.below(m.disparities + 1) - 1;
   }
   if (m.full_width && random.percent(60)) m.border_cost = random.below(random.percent(80) ? 8 : 4096);
   draw_post_processing(random, m);
   return m;
}

TEST(SemiGlobalFastModel, EqualsTheReferenceWithAnyOptions) {
   Random random(test_seed());
   int partly_valid = 0;
   for (int i = 0; i < 500; ++i) {
      const int width = 3 + random.below(100), height = 1 + random.below(24);
      const Matching matching = random_options(random, width);
      ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const int kind = random.below(10);
      if (kind == 0) pair = {GrayImage(width, height, 255), GrayImage(width, height, 0)};
      if (kind == 1) pair = {GrayImage(width, height, 77), GrayImage(width, height, 77)};
      if (kind > 6) pair = shifted_pair(width, height, random.below(width), test_seed() + uint64_t(i));
      const DisparityMap expected = match_reference(pair.left, pair.right, matching);
      ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, matching)))
          << width << 'x' << height << ' ' << text_of(matching);
      const auto valid = std::count(expected.valid.begin(), expected.valid.end(), 1);
      partly_valid += valid > 0 && valid < std::ssize(expected.valid) ? 1 : 0;
   }
   EXPECT_GT(partly_valid, 80) << "or the checks have hardly been compared";
}

/// Options for grey values that are 2^(bits - 8) times as large, with which window costs stay below 2^31.
Matching random_deep_options(Random& random, int width, int bits) {
   Matching m = random_options(random, width);
   m.pixel_bits = bits;
   m.prefilter_cap = random.percent(50) ? m.prefilter_cap << (bits - 8) : 1 + random.below(63 << (bits - 8));
   if (m.cost == Cost::ssd) m.window_px = std::min(m.window_px, 11);
   return m;
}

TEST(SemiGlobalFastModel, EqualsTheReferenceWithPixelsOf10And12Bits) {
   Random random(test_seed());
   for (int i = 0; i < 300; ++i) {
      const int width = 3 + random.below(90), height = 1 + random.below(24), bits = random.percent(50) ? 10 : 12;
      const Matching matching = random_deep_options(random, width, bits);
      const int levels = random.percent(50) ? 1 << bits : 2 + random.below(4);
      const DeepPair pair = random_deep_pair(width, height, random.bits(), bits, levels);
      ASSERT_TRUE(same_map(match_reference(pair.left, pair.right, matching),
                           match_fast(pair.left, pair.right, matching, 1 + random.below(3))))
          << width << 'x' << height << ' ' << text_of(matching);
   }
}

/// Costs are larger by the same factor, which the shift takes back, but for the cost of a census. Left out: the largest
/// difference of two grey values, which is the cost of what is no candidate, is larger by a little more.
TEST(SemiGlobalFastModel, LargerGreyValuesOfMoreBitsChangeNothing) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(60), height = 1 + random.below(16), more = random.percent(50) ? 2 : 4;
      Matching of_8_bits = random_deep_options(random, width, 8);
      Matching matching = of_8_bits;
      matching.pixel_bits = 8 + more;
      matching.prefilter_cap <<= more;
      const int factor = of_8_bits.cost == Cost::sad ? more : of_8_bits.cost == Cost::ssd ? 2 * more : 0;
      const bool has_other_largest = factor > 0 && matching.prefilter == Prefilter::none;
      if (matching.cost_shift + factor > 16 || (matching.full_width && has_other_largest)) continue;
      matching.cost_shift += factor;
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      DeepPair larger{widened(pair.left), widened(pair.right)};
      for (DeepImage* image : {&larger.left, &larger.right})
         for (uint16_t& pixel : image->pixels) pixel = uint16_t(pixel << more);
      const DisparityMap expected = match_reference(pair.left, pair.right, of_8_bits);
      for (const DisparityMap& map :
           {match_fast(larger.left, larger.right, matching), match_reference(larger.left, larger.right, matching)})
         ASSERT_TRUE(same_map(expected, map)) << width << 'x' << height << ' ' << text_of(matching);
   }
}

/// But for a map of full width, where the cost of what is no candidate follows the range of the pixels, and for a P2
/// that falls, by a part of that range.
TEST(SemiGlobalFastModel, PixelsOf8BitsAreTakenAsTheyAre) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(60), height = 1 + random.below(16);
      Matching matching = random_deep_options(random, width, 8);
      if (matching.full_width) continue;
      matching.p2_least = -1;
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const DisparityMap expected = match_reference(pair.left, pair.right, matching);
      matching.pixel_bits = 12;
      for (const DisparityMap& map :
           {match_fast(pair.left, pair.right, matching), match_reference(pair.left, pair.right, matching)})
         ASSERT_TRUE(same_map(expected, map)) << width << 'x' << height << ' ' << text_of(matching);
   }
}

TEST(SemiGlobalFastModel, RejectsPixelsBeyondTheRange) {
   for (const int bits : {8, 10, 12}) {
      const Matching matching{DisparityCount{4}, PixelFormat{bits}};
      DeepPair pair{DeepImage(9, 9, uint16_t((1 << bits) - 1)), DeepImage(9, 9)};
      EXPECT_NO_THROW(match_fast(pair.left, pair.right, matching));
      EXPECT_NO_THROW(match_reference(pair.left, pair.right, matching));
      pair.right.at(3, 8) = uint16_t(1 << bits);
      EXPECT_THROW(match_fast(pair.left, pair.right, matching), std::invalid_argument);
      EXPECT_THROW(match_reference(pair.left, pair.right, matching), std::invalid_argument);
   }
}

TEST(SemiGlobalFastModel, EqualsTheReferenceOnEveryKindOfPair) {
   Random random(test_seed());
   for (const NamedPair& pair : test_pairs(60, 14, 16, test_seed()))
      for (int i = 0; i < 12; ++i) {
         const Matching matching = random_options(random, 60);
         ASSERT_TRUE(same_map(match_reference(pair.images.left, pair.images.right, matching),
                              match_fast(pair.images.left, pair.images.right, matching)))
             << pair.name << ' ' << text_of(matching);
      }
}

/// Costs that are 0 or the largest drive the paths to their bounds, where lanes of 8 bits just fit and just do not.
TEST(SemiGlobalFastModel, EqualsTheReferenceAtTheEndsOfTheLanes) {
   for (const int p2 : {60, 61, 62, 63, 64, 65, 66, 90, 120, 127, 128, 129})
      for (const int cap : {13, 30, 43, 63}) {
         ImagePair pair = random_pair(90, 10, test_seed() + uint64_t(p2), 2);
         for (GrayImage* image : {&pair.left, &pair.right})
            for (uint8_t& pixel : image->pixels) pixel = uint8_t(pixel * 255);
         const Matching matching{DisparityCount{33},
                                 MatchingWindow{1},
                                 Comparison{Cost::sad},
                                 CostScale{.cost_shift = 0, .cost_cap = cap},
                                 semi_global::Paths{.p1 = p2 % 2, .p2 = p2},
                                 LeftRightThreshold{0},
                                 semi_global::UniquenessDistance{2}};
         EXPECT_TRUE(
             same_map(match_reference(pair.left, pair.right, matching), match_fast(pair.left, pair.right, matching)))
             << text_of(matching);
      }
}

TEST(SemiGlobalFastModel, EqualsTheReferenceOnLargerImages) {
   const ImagePair scene = random_pair(311, 60, test_seed(), 6);
   for (const int disparities : {31, 32, 33, 64, 128, 256}) {
      const Matching matching{DisparityCount{disparities}, LeftRightThreshold{1}, SubpixelSteps{true},
                              MedianFilter{true}};
      EXPECT_TRUE(
          same_map(match_reference(scene.left, scene.right, matching), match_fast(scene.left, scene.right, matching)))
          << disparities;
   }
}

TEST(SemiGlobalFastModel, IsTheSameForAnyNumberOfThreads) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(400), height = 1 + random.below(60);
      const Matching matching = random_options(random, width);
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const DisparityMap expected = match_fast(pair.left, pair.right, matching);
      for (const int threads : {2, 3, 7})
         ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, matching, threads)))
             << threads << " threads, " << width << 'x' << height << ' ' << text_of(matching);
   }
}

TEST(SemiGlobalFastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 8), Matching{DisparityCount{4}}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{9}}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{4}, semi_global::Paths{.p2 = -1}}),
                std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
