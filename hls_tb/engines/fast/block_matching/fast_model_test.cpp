// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/block_matching/fast_model.hpp"

#include <algorithm>
#include <stdexcept>

#include "definition/block_matching/models.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/random_post_processing.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

struct Case {
   int width, height, disparities, window_px;
};

// Narrow and low images, windows larger than the image, sums beyond 16 bits, sizes around whole vectors.
const Case kCases[] = {{2, 1, 1, 1},     {2, 1, 1, 3},     {3, 1, 2, 3},       {3, 3, 2, 3},     {5, 1, 2, 9},
                       {5, 7, 4, 9},     {9, 3, 8, 3},     {10, 5, 9, 5},      {17, 4, 1, 3},    {33, 2, 32, 3},
                       {32, 12, 8, 3},   {40, 9, 8, 1},    {40, 9, 8, 3},      {40, 9, 8, 5},    {40, 9, 8, 7},
                       {41, 9, 9, 3},    {39, 9, 9, 3},    {64, 16, 32, 11},   {65, 16, 32, 3},  {63, 16, 32, 3},
                       {90, 11, 64, 5},  {270, 4, 256, 3}, {300, 5, 256, 5},   {50, 40, 10, 15}, {50, 40, 10, 17},
                       {50, 40, 10, 39}, {50, 40, 10, 41}, {50, 40, 10, 1001}, {20, 300, 3, 21}, {101, 37, 50, 9},
                       {128, 8, 96, 3},  {127, 8, 96, 3},  {311, 239, 37, 3},  {311, 60, 37, 5}};
static_assert(std::size(kCases) >= 30);

std::vector<NamedPair> pairs_for(const Case& c) {
   if (c.disparities > 1) return test_pairs(c.width, c.height, c.disparities, test_seed());
   return {{"random", random_pair(c.width, c.height, test_seed())}};  // a scene needs two disparities
}

TEST(FastModel, EqualsTheReference) {
   for (const Case& c : kCases)
      for (const NamedPair& pair : pairs_for(c)) {
         SCOPED_TRACE(pair.name + " " + std::to_string(c.width) + "x" + std::to_string(c.height) +
                      " D=" + std::to_string(c.disparities) + " B=" + std::to_string(c.window_px));
         const block_matching::Matching parameters{DisparityCount{c.disparities}, MatchingWindow{c.window_px}};
         EXPECT_TRUE(same_map(match_reference(pair.images.left, pair.images.right, parameters),
                              match_fast(pair.images.left, pair.images.right, parameters)));
      }
}

TEST(FastModel, EqualsTheReferenceWithRandomParameters) {
   Random random(test_seed());
   for (int i = 0; i < 100; ++i) {
      const int disparities = 1 + random.below(70), width = disparities + 1 + random.below(80);
      const int height = 1 + random.below(30), window = 1 + 2 * random.below(12);
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), 2 + random.below(254));
      EXPECT_TRUE(
          same_map(match_reference(pair.left, pair.right,
                                   block_matching::Matching{DisparityCount{disparities}, MatchingWindow{window}}),
                   match_fast(pair.left, pair.right,
                              block_matching::Matching{DisparityCount{disparities}, MatchingWindow{window}})))
          << width << 'x' << height << " D=" << disparities << " B=" << window;
   }
}

/// Any options that the models take, for images of this size.
block_matching::Matching random_parameters(Random& random, int width) {
   block_matching::Matching p{
       DisparityCount{1 + random.below(random.percent(20) ? width - 1 : std::min(width - 1, 20))}};
   p.window_px = 1 + random.below(21);
   p.reference = random.percent(50) ? Reference::left : Reference::right;
   p.cost = Cost(random.below(3));
   p.census_width_px = 3 + 2 * random.below(4);
   p.census_height_px = 3 + 2 * random.below(3);
   p.census_pattern = CensusPattern(random.below(p.census_width_px + p.census_height_px == 6 ? 3 : 4));
   p.ties = random.percent(50) ? Ties::largest : Ties::smallest;
   p.subpixel = random.percent(50);
   p.median = random.percent(50);
   if (random.percent(60)) p.min_disparity = random.below(2 * width) - width;
   while (cost_columns(width, p) < 2) p.min_disparity /= 2;
   if (p.cost != Cost::census && random.percent(50)) p.prefilter = Prefilter::xsobel;
   p.prefilter_cap = 1 + random.below(63);
   if (p.prefilter == Prefilter::xsobel && random.percent(50))
      p.texture_threshold = random.below(p.prefilter_cap * p.window_px * p.window_px / 2 + 2);
   if (random.percent(50)) p.left_right_threshold = random.below(std::min(p.disparities, 4));
   if (random.percent(50)) p.uniqueness_percent = random.below(random.percent(50) ? 10 : 101);
   p.full_width = random.percent(40) && p.window_px >= 2 && p.window_px < width;
   if (p.full_width && random.percent(50)) {
      p.first_disparity = random.below(p.disparities);
      p.last_disparity = random.below(p.disparities + 1) - 1;
   }
   draw_post_processing(random, p);
   return p;
}

std::string text_of(const block_matching::Matching& p) {
   std::string text;
   for (const auto& [name, value] : {std::pair{"D", p.disparities},
                                     {"B", p.window_px},
                                     {"m", p.min_disparity},
                                     {"reference", int(p.reference)},
                                     {"cost", int(p.cost)},
                                     {"census", 10 * p.census_width_px + p.census_height_px},
                                     {"prefilter", int(p.prefilter)},
                                     {"cap", p.prefilter_cap},
                                     {"ties", int(p.ties)},
                                     {"left/right", p.left_right_threshold},
                                     {"uniqueness", p.uniqueness_percent},
                                     {"texture", p.texture_threshold},
                                     {"subpixel", int(p.subpixel)},
                                     {"support", p.support_threshold},
                                     {"confidence", int(p.confidence)},
                                     {"margin shift", p.margin_shift},
                                     {"margin weight", p.margin_weight},
                                     {"support weight", p.support_weight},
                                     {"fill", int(p.fill_holes)},
                                     {"median", int(p.median)}})
      text += std::string(name) + "=" + std::to_string(value) + " ";
   return text;
}

TEST(FastModel, EqualsTheReferenceWithAnyOptions) {
   Random random(test_seed());
   int partly_valid = 0;
   for (int i = 0; i < 400; ++i) {
      const int width = 3 + random.below(90), height = 1 + random.below(24);
      const block_matching::Matching parameters = random_parameters(random, width);
      ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const int kind = random.below(10);
      if (kind == 0) pair = {GrayImage(width, height, 255), GrayImage(width, height, 0)};
      if (kind == 1) pair = {GrayImage(width, height, 77), GrayImage(width, height, 77)};
      if (kind > 6) pair = shifted_pair(width, height, random.below(width), test_seed() + uint64_t(i));
      const DisparityMap expected = match_reference(pair.left, pair.right, parameters);
      ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, parameters)))
          << width << 'x' << height << ' ' << text_of(parameters);
      const auto valid = std::count(expected.valid.begin(), expected.valid.end(), 1);
      partly_valid += valid > 0 && valid < std::ssize(expected.valid) ? 1 : 0;
   }
   EXPECT_GT(partly_valid, 80) << "or the checks have hardly been compared";
}

TEST(FastModel, IsTheSameForAnyNumberOfThreads) {
   Random random(test_seed());
   for (int i = 0; i < 120; ++i) {
      const int width = 3 + random.below(200), height = 1 + random.below(60);
      block_matching::Matching parameters = random_parameters(random, width);
      if (i % 4 == 0) parameters = {DisparityCount{parameters.disparities}, MatchingWindow{3 + 2 * random.below(2)}};
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const DisparityMap expected = match_fast(pair.left, pair.right, parameters);
      for (const int threads : {2, 3, 7})
         ASSERT_TRUE(same_map(expected, match_fast(pair.left, pair.right, parameters, threads)))
             << threads << " threads, " << width << 'x' << height << ' ' << text_of(parameters);
   }
}

TEST(FastModel, EqualsTheReferenceOnEveryKindOfPair) {
   Random random(test_seed());
   for (const NamedPair& pair : test_pairs(60, 14, 16, test_seed()))
      for (int i = 0; i < 12; ++i) {
         const block_matching::Matching parameters = random_parameters(random, 60);
         ASSERT_TRUE(same_map(match_reference(pair.images.left, pair.images.right, parameters),
                              match_fast(pair.images.left, pair.images.right, parameters)))
             << pair.name << ' ' << text_of(parameters);
      }
}

TEST(FastModel, EqualsTheReferenceWithWindowsBeyondTheImage) {
   for (const Cost cost : {Cost::sad, Cost::ssd, Cost::census})
      for (const int window : {39, 40, 1000}) {
         const block_matching::Matching parameters{
             DisparityCount{10}, MatchingWindow{window}, ReferenceImage{Reference::left},
             Comparison{cost},   LeftRightThreshold{1},  UniquenessPercent{1}};
         const ImagePair pair = random_pair(50, 40, test_seed(), 8);
         EXPECT_TRUE(same_map(match_reference(pair.left, pair.right, parameters),
                              match_fast(pair.left, pair.right, parameters)))
             << int(cost) << ' ' << window;
      }
}

TEST(FastModel, EqualsTheReferenceWhereSumsPass16Bits) {
   // 17 x 17 differences of 200 ... 253 add up to about 65536.
   ImagePair pair = random_pair(80, 40, test_seed(), 54);
   for (uint8_t& pixel : pair.left.pixels) pixel = uint8_t(200 + pixel / 5);
   pair.right = GrayImage(80, 40, 0);
   const block_matching::Matching parameters{DisparityCount{30}, MatchingWindow{17}};
   EXPECT_TRUE(
       same_map(match_reference(pair.left, pair.right, parameters), match_fast(pair.left, pair.right, parameters)));
}

TEST(FastModel, FindsTheSmallestSumInAWindowOfMillionsOfPixels) {
   // The window covers the whole image. Left is white but for its last column, which only disparity 1 sees: three
   // columns of differences against two.
   constexpr int kHeight = 800000;
   GrayImage left(4, kHeight, 255);
   const GrayImage right(4, kHeight, 0);
   for (int y = 0; y < kHeight; ++y) left.at(3, y) = 0;
   EXPECT_TRUE(
       same_map(DisparityMap(2, kHeight, 1),
                match_fast(left, right, block_matching::Matching{DisparityCount{2}, MatchingWindow{2 * kHeight + 1}})));
}

TEST(FastModel, EqualsTheReferenceWhereSumsAreTheLargestOf16Bits) {
   // 257 saturated differences are 65535, 256 of them 65280.
   for (const int width : {265, 266}) {
      const block_matching::Matching parameters{DisparityCount{10}, MatchingWindow{1000}, TieRule{Ties::largest},
                                                LeftRightThreshold{0}};
      const ImagePair pair{GrayImage(width, 1, 255), GrayImage(width, 1, 0)};
      EXPECT_TRUE(
          same_map(match_reference(pair.left, pair.right, parameters), match_fast(pair.left, pair.right, parameters)));
   }
}

/// Any options with which window costs of 12 bits stay below 2^31.
block_matching::Matching random_deep_parameters(Random& random, int width) {
   block_matching::Matching parameters = random_parameters(random, width);
   if (parameters.cost != Cost::ssd) return parameters;
   parameters.window_px = std::min(parameters.window_px, 11);
   parameters.texture_threshold =
       std::min(parameters.texture_threshold, parameters.prefilter_cap * parameters.window_px * parameters.window_px);
   parameters.margin_shift = std::min(parameters.margin_shift, 8);  // `scaled` adds to it
   return parameters;
}

/// As `of_8_bits`, for grey values that are 2^(bits - 8) times as large.
block_matching::Matching scaled(block_matching::Matching of_8_bits, int bits) {
   of_8_bits.pixel_bits = bits;
   of_8_bits.prefilter_cap <<= bits - 8;
   of_8_bits.texture_threshold <<= bits - 8;
   const int larger = of_8_bits.cost == Cost::census ? 0 : of_8_bits.cost == Cost::ssd ? 2 * (bits - 8) : bits - 8;
   of_8_bits.margin_shift = std::min(of_8_bits.margin_shift + larger, 16);
   return of_8_bits;
}

TEST(FastModel, EqualsTheReferenceWithPixelsOf10And12Bits) {
   Random random(test_seed());
   for (int i = 0; i < 300; ++i) {
      const int width = 3 + random.below(90), height = 1 + random.below(24), bits = random.percent(50) ? 10 : 12;
      block_matching::Matching parameters = scaled(random_deep_parameters(random, width), bits);
      if (random.percent(50)) parameters.prefilter_cap = 1 + random.below(63 << (bits - 8));
      if (parameters.has_texture_check()) parameters.texture_threshold = std::max(1, parameters.prefilter_cap);
      const int levels = random.percent(50) ? 1 << bits : 2 + random.below(4);
      const DeepPair pair = random_deep_pair(width, height, random.bits(), bits, levels);
      ASSERT_TRUE(
          same_map(match_reference(pair.left, pair.right, parameters), match_fast(pair.left, pair.right, parameters)))
          << width << 'x' << height << " bits=" << bits << ' ' << text_of(parameters);
   }
}

TEST(FastModel, LargerGreyValuesOfMoreBitsChangeNothing) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(60), height = 1 + random.below(16), bits = random.percent(50) ? 10 : 12;
      const block_matching::Matching parameters = random_deep_parameters(random, width);
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      DeepPair larger{widened(pair.left), widened(pair.right)};
      for (DeepImage* image : {&larger.left, &larger.right})
         for (uint16_t& pixel : image->pixels) pixel = uint16_t(pixel << (bits - 8));
      const DisparityMap expected = match_reference(pair.left, pair.right, parameters);
      for (const DisparityMap& map : {match_fast(larger.left, larger.right, scaled(parameters, bits)),
                                      match_reference(larger.left, larger.right, scaled(parameters, bits))})
         ASSERT_TRUE(same_map(expected, map)) << width << 'x' << height << ' ' << text_of(parameters);
   }
}

TEST(FastModel, PixelsOf8BitsAreTakenAsTheyAre) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int width = 3 + random.below(60), height = 1 + random.below(16);
      block_matching::Matching parameters = random_deep_parameters(random, width);
      const ImagePair pair = random_pair(width, height, test_seed() + uint64_t(i), random.percent(50) ? 256 : 4);
      const DisparityMap expected = match_reference(pair.left, pair.right, parameters);
      parameters.pixel_bits = 12;
      for (const DisparityMap& map :
           {match_fast(pair.left, pair.right, parameters), match_reference(pair.left, pair.right, parameters)})
         ASSERT_TRUE(same_map(expected, map)) << width << 'x' << height << ' ' << text_of(parameters);
   }
}

TEST(FastModel, RejectsPixelsBeyondTheRange) {
   for (const int bits : {8, 10, 12}) {
      const block_matching::Matching parameters{DisparityCount{4}, PixelFormat{bits}};
      DeepPair pair{DeepImage(9, 9, uint16_t((1 << bits) - 1)), DeepImage(9, 9)};
      EXPECT_NO_THROW(match_fast(pair.left, pair.right, parameters));
      EXPECT_NO_THROW(match_reference(pair.left, pair.right, parameters));
      pair.right.at(3, 8) = uint16_t(1 << bits);
      EXPECT_THROW(match_fast(pair.left, pair.right, parameters), std::invalid_argument);
      EXPECT_THROW(match_reference(pair.left, pair.right, parameters), std::invalid_argument);
   }
   for (const int bits : {7, 9, 11, 13, 16})
      EXPECT_THROW(
          match_fast(DeepImage(9, 9), DeepImage(9, 9), block_matching::Matching{DisparityCount{4}, PixelFormat{bits}}),
          std::invalid_argument);
}

TEST(FastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(
       match_fast(GrayImage(1, 1), GrayImage(1, 1), block_matching::Matching{DisparityCount{1}, MatchingWindow{3}}),
       std::invalid_argument);
   EXPECT_THROW(
       match_fast(GrayImage(9, 9), GrayImage(9, 8), block_matching::Matching{DisparityCount{4}, MatchingWindow{3}}),
       std::invalid_argument);
   EXPECT_THROW(
       match_fast(GrayImage(9, 9), GrayImage(9, 9), block_matching::Matching{DisparityCount{4}, MatchingWindow{0}}),
       std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
