// SPDX-License-Identifier: Apache-2.0
#include "sad_cost.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

TEST(SadCost, AbsoluteDifferenceOfAllPairs) {
   for (int a = 0; a < 256; ++a)
      for (int b = 0; b < 256; ++b)
         ASSERT_EQ(SadCost<configurations::tiny>::absolute_difference(uint8_t(a), uint8_t(b)), std::abs(a - b))
             << "a=" << a << " b=" << b;
}

template <class Config>
class SadCostTest : public ::testing::Test {};
TYPED_TEST_SUITE(SadCostTest, SmallConfigs);

template <const StereoConfig& C>
void sums_a_column_two_clocks_later() {
   constexpr int D = C.disparities, B = C.window_px;
   Random random(test_seed());
   DisparityShift<C> shift;
   SadCost<C> cost;
   struct Step {
      PixelTag tag;
      std::vector<int> column = std::vector<int>(D, 0);
   };
   Step before;
   for (int clock = 0; clock < 200; ++clock) {
      Step now;
      now.tag.valid = !random.percent(25);
      now.tag.cost_column = random.percent(75);
      now.tag.output_column = random.percent(50);
      const bool saturated = random.percent(20);
      for (int k = 0; k < B; ++k) {
         shift.right[k] = saturated ? 255 : random.byte();
         for (int d = 0; d < D; ++d) {
            shift.left[k][d] = saturated ? 0 : random.byte();
            if (now.tag.cost_column) now.column[std::size_t(d)] += std::abs(shift.right[k] - shift.left[k][d]);
         }
      }
      shift.tag = now.tag;
      cost.clock(shift);
      ASSERT_EQ(cost.tag.valid, before.tag.valid) << "clock " << clock;
      ASSERT_EQ(cost.tag.output_column, before.tag.output_column) << "clock " << clock;
      for (int d = 0; d < D; ++d)
         ASSERT_EQ(cost.column[d], before.column[std::size_t(d)]) << "clock " << clock << " d=" << d;
      before = now;
   }
}

TYPED_TEST(SadCostTest, SumsAColumnTwoClocksLater) { sums_a_column_two_clocks_later<TypeParam::kConfig>(); }

}  // namespace
}  // namespace stereo::test
