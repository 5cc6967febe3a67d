// SPDX-License-Identifier: Apache-2.0
#include "cost/sad_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "cost/disparity_shift.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class SadCostTest : public ::testing::Test {};
TYPED_TEST_SUITE(SadCostTest, SmallConfigs, ConfigNames);

TYPED_TEST(SadCostTest, AbsoluteDifferenceOfAllPairs) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   DisparityShift<C, 2> shift;
   SadCost<C, 2> cost;
   for (int t = 0; t < C.tap_rows(); ++t) {
      for (int a = 0; a < 256; ++a)
         for (int b = 0; b < 256; ++b) {
            shift.search[t][0] = shift.reference[t] = uint8_t(a);  // no difference, whatever the grey value
            shift.search[t][1] = uint8_t(b);
            for (int clock = 0; clock < C.cost_clocks; ++clock) cost.clock(shift);
            for (int p = 0; p < C.pixels_per_clock; ++p) {
               const bool covered = t >= p && t < p + C.window_px;
               ASSERT_EQ(cost.column[p][0], 0) << "lane " << p << " t=" << t << " a=" << a;
               ASSERT_EQ(cost.column[p][1], covered ? std::abs(a - b) : 0)
                   << "lane " << p << " t=" << t << " a=" << a << " b=" << b;
            }
         }
      shift.search[t][1] = shift.reference[t];
   }
}

TYPED_TEST(SadCostTest, SumsTheColumnOfEachWindow) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kCount = C.largest_slice(), kTaps = C.tap_rows(), P = C.pixels_per_clock;
   Random random(test_seed());
   DisparityShift<C, kCount> shift;
   SadCost<C, kCount> cost;
   struct Step {
      PixelTag tag;
      std::vector<int> column = std::vector<int>(P * kCount, 0);  ///< [p][i]
   };
   std::deque<Step> pipeline(C.cost_clocks - 1);  // reset: no differences came before
   for (int clock = 0; clock < 300; ++clock) {
      Step now;
      now.tag.valid = !random.percent(25);
      now.tag.border_column = random.percent(25);
      now.tag.output_column = random.percent(50);
      const bool saturated = random.percent(20), search_is_white = random.percent(50);
      for (int t = 0; t < kTaps; ++t) {
         shift.reference[t] = saturated ? (search_is_white ? 0 : 255) : random.byte();
         for (int i = 0; i < kCount; ++i) {
            shift.search[t][i] = saturated ? (search_is_white ? 255 : 0) : random.byte();
            if (now.tag.border_column) continue;
            for (int p = 0; p < P; ++p)
               if (t >= p && t < p + C.window_px)
                  now.column[std::size_t(p * kCount + i)] += std::abs(shift.reference[t] - shift.search[t][i]);
         }
      }
      shift.tag = now.tag;
      pipeline.push_back(now);
      cost.clock(shift);
      const Step expected = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(cost.tag.valid, expected.tag.valid) << "clock " << clock;
      ASSERT_EQ(cost.tag.output_column, expected.tag.output_column) << "clock " << clock;
      for (int p = 0; p < P; ++p)
         for (int i = 0; i < kCount; ++i)
            ASSERT_EQ(cost.column[p][i], expected.column[std::size_t(p * kCount + i)])
                << "clock " << clock << " lane " << p << " i=" << i;
   }
}

}  // namespace
}  // namespace stereo::test
