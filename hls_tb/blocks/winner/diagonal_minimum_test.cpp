// SPDX-License-Identifier: Apache-2.0
#include "winner/diagonal_minimum.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "block_matching/config.hpp"
#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <Reference Side, Ties Rule, int P>
using DiagonalConfig =
    Exactly<block_matching::Config{{.width_px = 40, .height_px = 8, .pixels_per_clock = P},
                                   {DisparityCount{7}, ReferenceImage{Side}, TieRule{Rule}, LeftRightThreshold{1}},
                                   {}}>;

template <class Config>
class DiagonalMinimumTest : public ::testing::Test {};
using Configs = ::testing::Types<
    DiagonalConfig<Reference::right, Ties::smallest, 1>, DiagonalConfig<Reference::right, Ties::largest, 2>,
    DiagonalConfig<Reference::left, Ties::smallest, 2>, DiagonalConfig<Reference::left, Ties::largest, 1>>;
TYPED_TEST_SUITE(DiagonalMinimumTest, Configs, ConfigNames);

/// Window costs of the columns of one row of the map, for all lanes and disparities.
template <const block_matching::Config& C>
struct MapRow {
   static constexpr int P = C.pixels_per_clock, D = C.disparities;
   int width;
   std::vector<int> sums;

   MapRow(Random& random, int width_px) : width(width_px) {
      const int levels = 1 + random.below(4);  // few: many ties
      for (int i = 0; i < width * P * D; ++i)
         sums.push_back(random.percent(90) ? random.below(levels) : random.below(2296));
   }
   int at(int x, int p, int d) const { return sums[std::size_t((x * P + p) * D + d)]; }

   /// docs/algorithm.md, 5.: the winner of column X of the other image; -1: no column of the map is compared with it.
   int winner(int other_x, int p) const {
      int best = -1, smallest = 0;
      for (int d = 0; d < D; ++d) {
         const int x = C.reference == Reference::right ? other_x - d : other_x + d;
         if (x < 0 || x >= width) continue;
         const int sum = at(x, p, d);
         if (best < 0 || sum < smallest || (sum == smallest && C.ties == Ties::largest)) {
            best = d;
            smallest = sum;
         }
      }
      return best;
   }
};

/// Two blocks, the second a clock behind the first, as in the chain of slices.
template <const block_matching::Config& C>
struct Chain {
   static constexpr int P = C.pixels_per_clock, kFirstCount = 3, kSecondCount = C.disparities - kFirstCount;
   static constexpr bool kRight = C.reference == Reference::right;
   /// The lowest disparities: a right reference starts with the highest ones.
   static constexpr int kFirst = kRight ? kSecondCount : 0, kSecond = kRight ? 0 : kFirstCount;

   DiagonalMinimum<C, kFirstCount> first;
   DiagonalMinimum<C, kSecondCount> second;
   WindowCost<C> sums_of_second[P][kSecondCount] = {};
   PixelTag tag_of_second;

   void clock(const std::vector<int>& sums, const PixelTag& tag) {  // [p][d]
      second.clock(sums_of_second, tag_of_second, kSecond, first);
      WindowCost<C> sums_of_first[P][kFirstCount];
      for (int p = 0; p < P; ++p) {
         const int* const lane = sums.data() + p * C.disparities;
         for (int i = 0; i < kFirstCount; ++i) sums_of_first[p][i] = WindowCost<C>(lane[kFirst + i]);
         for (int i = 0; i < kSecondCount; ++i) sums_of_second[p][i] = WindowCost<C>(lane[kSecond + i]);
      }
      first.clock(sums_of_first, tag, kFirst, NoDiagonal<C>());
      tag_of_second = tag;
   }
};

TYPED_TEST(DiagonalMinimumTest, FindsTheOtherImagesWinners) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int P = C.pixels_per_clock, D = C.disparities;
   Random random(test_seed());
   Chain<C> chain;
   struct Step {
      bool compares = false;
      int x = 0;
      const MapRow<C>* row = nullptr;
   } before;
   int compared = 0;
   for (int round = 0; round < 200; ++round) {
      const MapRow<C> row(random, 1 + random.below(20));
      // Behind the map, columns without meaning in which the last pixels of the other image leave.
      const int columns = row.width + D - 1 + random.below(5);
      for (int x = 0; x <= columns;) {
         Step now;
         PixelTag tag = random_tag(random);
         if (x == columns) tag.valid = false;  // the second block's last column
         const bool in_map = tag.valid && x < row.width;
         std::vector<int> sums;
         for (int p = 0; p < P; ++p)
            for (int d = 0; d < D; ++d) sums.push_back(in_map ? row.at(x, p, d) : random.below(5));
         if (tag.valid) {
            tag.output_column = in_map;
            tag.first_column = x == 0;
            // A pixel leaves behind its last disparity: 0, or D-1 where the reference is the left image.
            now = {true, C.reference == Reference::right ? x : x - (D - 1), &row};
         }
         chain.clock(sums, tag);
         x += tag.valid || x == columns ? 1 : 0;
         if (before.compares && before.row->winner(before.x, 0) >= 0)
            for (int p = 0; p < P; ++p) {
               ASSERT_EQ(int(chain.second.winner[p][chain.second.kOldest]), before.row->winner(before.x, p))
                   << "row " << round << " X=" << before.x << " lane " << p;
               ++compared;
            }
         before = now;
      }
   }
   EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace stereo::test
