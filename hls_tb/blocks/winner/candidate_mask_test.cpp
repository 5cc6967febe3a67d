// SPDX-License-Identifier: Apache-2.0
#include "winner/candidate_mask.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "block_matching/config.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <Reference Side, int MinDisparity>
using MaskConfig = Exactly<block_matching::Config{
    {.width_px = 24, .height_px = 8},
    {.disparities = 7, .min_disparity = MinDisparity, .reference = Side, .full_width = true},
    {}}>;

template <class Config>
class CandidateMaskTest : public ::testing::Test {};
using Configs =
    ::testing::Types<MaskConfig<Reference::right, 0>, MaskConfig<Reference::right, 4>, MaskConfig<Reference::right, -3>,
                     MaskConfig<Reference::right, -12>, MaskConfig<Reference::left, 0>, MaskConfig<Reference::left, 5>,
                     MaskConfig<Reference::left, -2>, MaskConfig<Reference::left, -15>>;
TYPED_TEST_SUITE(CandidateMaskTest, Configs, ConfigNames);

/// Two blocks, the second a clock behind the first, as in the chain of slices.
template <const block_matching::Config& C>
struct Chain {
   static constexpr int kFirstCount = 3, kSecondCount = C.disparities - kFirstCount;
   static constexpr bool kRight = C.reference == Reference::right;
   /// The lowest disparities: a right reference starts with the highest ones.
   static constexpr int kFirst = kRight ? kSecondCount : 0, kSecond = kRight ? 0 : kFirstCount;

   CandidateMask<C, kFirstCount, kFirst> first;
   CandidateMask<C, kSecondCount, kSecond> second;
   PixelTag tag_of_second;

   void clock(const PixelTag& tag) {
      second.clock(tag_of_second, first);
      first.clock(tag, NoMask());
      tag_of_second = tag;
   }
};

/// docs/algorithm.md, 8.: whether disparity d of column x of the map is a candidate.
template <const block_matching::Config& C>
bool is_candidate(int x, int d) {
   const int other = C.reference == Reference::right ? x + C.min_disparity + d : x - C.min_disparity - d;
   return other >= 0 && other < C.output_width_px();
}

TYPED_TEST(CandidateMaskTest, SaysWhichDisparitiesLeadIntoTheOtherImage) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kWidth = C.output_width_px();
   Random random(test_seed());
   Chain<C> chain;
   int compared = 0;
   for (int row = 0; row < 50; ++row) {
      const int columns = row % 7 == 6 ? 1 + random.below(kWidth) : C.width_px;  // some rows break off
      int of_second = -1;                                                        // the column whose tag it has
      for (int x = 0; x <= columns;) {
         PixelTag tag = random_tag(random);
         if (x == columns) tag.valid = false;  // the second block's last column
         tag.first_column = x == 0;
         chain.clock(tag);
         const int now = tag.valid ? x : -1;
         for (int i = 0; i < chain.kFirstCount && now >= 0 && now < kWidth; ++i, ++compared)
            ASSERT_EQ(chain.first.inside[i], is_candidate<C>(now, chain.kFirst + i)) << "x=" << now << " i=" << i;
         for (int i = 0; i < chain.kSecondCount && of_second >= 0 && of_second < kWidth; ++i, ++compared)
            ASSERT_EQ(chain.second.inside[i], is_candidate<C>(of_second, chain.kSecond + i))
                << "x=" << of_second << " i=" << i;
         of_second = now;
         x += tag.valid || x == columns ? 1 : 0;
      }
   }
   EXPECT_GT(compared, 1000);
}

TYPED_TEST(CandidateMaskTest, HidesCostsBehindALargerOne) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   CandidateMask<C, 2, 0> mask;
   mask.inside[0] = true;
   mask.inside[1] = false;
   const WindowCost<C> sum[1][2] = {{WindowCost<C>(C.largest_window_cost()), 0}};
   WindowCost<C> shown[1][2];
   mask.hide(sum, shown);
   EXPECT_EQ(int(shown[0][0]), C.largest_window_cost());
   EXPECT_GT(int(shown[0][1]), C.largest_window_cost());
}

}  // namespace
}  // namespace stereo::test
