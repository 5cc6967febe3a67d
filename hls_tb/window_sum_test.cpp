// SPDX-License-Identifier: Apache-2.0
#include "window_sum.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class WindowSumTest : public ::testing::Test {};
TYPED_TEST_SUITE(WindowSumTest, SmallConfigs, ConfigNames);

TYPED_TEST(WindowSumTest, SumsTheLastColumnsAndTagsTheirCentre) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   constexpr int kCount = C.largest_slice(), B = C.window_px, P = C.pixels_per_clock;
   struct Column {
      PixelTag tag;
      std::vector<int> cost = std::vector<int>(P * kCount, 0);  ///< [p][i]
   };
   Random random(test_seed());
   SadCost<C, kCount> cost;
   WindowSum<C, kCount> window;
   std::vector<Column> columns(B);  // reset: zeros came before
   for (int clock = 0; clock < 300; ++clock) {
      Column column;
      column.tag.valid = !random.percent(25);
      column.tag.output_column = random.percent(50);
      column.tag.start_of_frame = random.percent(50);
      column.tag.end_of_line = random.percent(50);
      const bool saturated = random.percent(30);
      for (int p = 0; p < P; ++p)
         for (int i = 0; i < kCount; ++i) {
            cost.column[p][i] = uint16_t(saturated ? 255 * B : random.below(255 * B + 1));
            column.cost[std::size_t(p * kCount + i)] = cost.column[p][i];
         }
      cost.tag = column.tag;
      window.clock(cost);
      ASSERT_EQ(window.tag.valid, column.tag.valid);
      if (!column.tag.valid) continue;
      columns.push_back(column);
      const Column& centre = columns[columns.size() - 1 - C.radius_px()];
      ASSERT_EQ(window.tag.output_column, centre.tag.output_column) << "clock " << clock;
      ASSERT_EQ(window.tag.start_of_frame, centre.tag.start_of_frame) << "clock " << clock;
      ASSERT_EQ(window.tag.end_of_line, centre.tag.end_of_line) << "clock " << clock;
      for (int p = 0; p < P; ++p)
         for (int i = 0; i < kCount; ++i) {
            int sum = 0;
            for (std::size_t j = columns.size() - B; j < columns.size(); ++j)
               sum += columns[j].cost[std::size_t(p * kCount + i)];
            ASSERT_EQ(window.sum[p][i], sum) << "clock " << clock << " lane " << p << " i=" << i;
         }
   }
}

}  // namespace
}  // namespace stereo::test
