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

template <Reference Side, int MinDisparity, bool RunTimeSize = false>
using MaskConfig = Exactly<block_matching::Config{
    {.width_px = 24, .height_px = 8},
    {DisparityCount{7}, SmallestDisparity{MinDisparity}, ReferenceImage{Side}, FullWidth{.full_width = true}},
    {RunTime{.run_time_size = RunTimeSize}}}>;

template <class Config>
class CandidateMaskTest : public ::testing::Test {};
using Configs =
    ::testing::Types<MaskConfig<Reference::right, 0>, MaskConfig<Reference::right, 4>, MaskConfig<Reference::right, -3>,
                     MaskConfig<Reference::right, -12>, MaskConfig<Reference::left, 0>, MaskConfig<Reference::left, 5>,
                     MaskConfig<Reference::left, -2>, MaskConfig<Reference::left, -15>,
                     MaskConfig<Reference::right, 3, true>, MaskConfig<Reference::right, -11, true>,
                     MaskConfig<Reference::left, 6, true>, MaskConfig<Reference::left, -9, true>>;
TYPED_TEST_SUITE(CandidateMaskTest, Configs, ConfigNames);

/// Two blocks, the second a clock behind the first, as in the chain of slices.
template <const block_matching::Config& C>
struct Chain {
   static constexpr int kFirstCount = 3, kSecondCount = C.disparities - kFirstCount;
   static constexpr bool kRight = C.reference == Reference::right;
   /// The lowest disparities: a right reference starts with the highest ones.
   static constexpr int kFirst = kRight ? kSecondCount : 0, kSecond = kRight ? 0 : kFirstCount;

   using Size = std::conditional_t<C.run_time_size, RunTimeSize<C>, FixedSize<C>>;

   Size size;
   CandidateMask<C, kFirstCount, kFirst> first;
   CandidateMask<C, kSecondCount, kSecond> second;
   PixelTag tag_of_second;

   void clock(const PixelTag& tag) {
      second.clock(tag_of_second, first, NoSettings(), size);
      first.clock(tag, NoMask(), NoSettings(), size);
      tag_of_second = tag;
   }
};

/// docs/algorithm.md, 8.: whether disparity d of column x of the map is a candidate.
template <const block_matching::Config& C>
bool is_candidate(int x, int d, int map_width) {
   const int other = C.reference == Reference::right ? x + C.min_disparity + d : x - C.min_disparity - d;
   return other >= 0 && other < map_width;
}

/// Images of so many columns less than the configuration's.
template <const block_matching::Config& C>
void expect_candidates(const int narrower) {
   const int width = C.output_width_px() - narrower;
   Random random(test_seed());
   Chain<C> chain;
   if constexpr (C.run_time_size) chain.size.clock(uint16_t(C.width_px - narrower), uint16_t(C.height_px));
   int compared = 0;
   for (int row = 0; row < 50; ++row) {
      const int columns = row % 7 == 6 ? 1 + random.below(width) : C.width_px - narrower;  // some rows break off
      int of_second = -1;  // the column whose tag it has
      for (int x = 0; x <= columns;) {
         PixelTag tag = random_tag(random);
         if (x == columns) tag.valid = false;  // the second block's last column
         tag.first_column = x == 0;
         chain.clock(tag);
         const int now = tag.valid ? x : -1;
         for (int i = 0; i < chain.kFirstCount && now >= 0 && now < width; ++i, ++compared)
            ASSERT_EQ(chain.first.inside[i], is_candidate<C>(now, chain.kFirst + i, width))
                << "x=" << now << " i=" << i << " of " << width;
         for (int i = 0; i < chain.kSecondCount && of_second >= 0 && of_second < width; ++i, ++compared)
            ASSERT_EQ(chain.second.inside[i], is_candidate<C>(of_second, chain.kSecond + i, width))
                << "x=" << of_second << " i=" << i << " of " << width;
         of_second = now;
         x += tag.valid || x == columns ? 1 : 0;
      }
   }
   EXPECT_GT(compared, 500);
}

TYPED_TEST(CandidateMaskTest, SaysWhichDisparitiesLeadIntoTheOtherImage) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   const int least = C.run_time_size ? least_size(C).width_px : C.width_px;
   for (int narrower = C.width_px - least; narrower >= 0; --narrower)
      ASSERT_NO_FATAL_FAILURE(expect_candidates<C>(narrower));
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
