// SPDX-License-Identifier: Apache-2.0
#include "models/fast_model.hpp"

#include <stdexcept>

#include "models/random.hpp"
#include "support/map_compare.hpp"
#include "support/seed.hpp"
#include "support/test_pairs.hpp"

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
         const MatchingParameters parameters{c.disparities, c.window_px};
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
      EXPECT_TRUE(same_map(match_reference(pair.left, pair.right, {disparities, window}),
                           match_fast(pair.left, pair.right, {disparities, window})))
          << width << 'x' << height << " D=" << disparities << " B=" << window;
   }
}

TEST(FastModel, EqualsTheReferenceWhereSumsPass16Bits) {
   // 17 x 17 differences of 200 ... 253 add up to about 65536.
   ImagePair pair = random_pair(80, 40, test_seed(), 54);
   for (uint8_t& pixel : pair.left.pixels) pixel = uint8_t(200 + pixel / 5);
   pair.right = GrayImage(80, 40, 0);
   const MatchingParameters parameters{30, 17};
   EXPECT_TRUE(
       same_map(match_reference(pair.left, pair.right, parameters), match_fast(pair.left, pair.right, parameters)));
}

TEST(FastModel, FindsTheSmallestSumWhereSumsTimesTheGroupPass32Bits) {
   // The window covers the whole image. Left is white but for its last column, which only disparity 1 sees: three
   // columns of differences against two. 8 * 255 * 3 * 800000 needs 33 bits, 8 * 255 * 2 * 800000 only 32.
   constexpr int kHeight = 800000;
   GrayImage left(4, kHeight, 255);
   const GrayImage right(4, kHeight, 0);
   for (int y = 0; y < kHeight; ++y) left.at(3, y) = 0;
   EXPECT_TRUE(same_map(DisparityMap(2, kHeight, 1), match_fast(left, right, {2, 2 * kHeight + 1})));
}

TEST(FastModel, RejectsWhatTheReferenceRejects) {
   EXPECT_THROW(match_fast(GrayImage(1, 1), GrayImage(1, 1), {1, 3}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 8), {4, 3}), std::invalid_argument);
   EXPECT_THROW(match_fast(GrayImage(9, 9), GrayImage(9, 9), {4, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
