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
TYPED_TEST_SUITE(WindowSumTest, SmallConfigs);

template <const StereoConfig& C>
void sums_the_last_columns_and_tags_their_centre() {
   constexpr int D = C.disparities, B = C.window_px, r = C.radius_px();
   struct Column {
      PixelTag tag;
      std::vector<int> cost = std::vector<int>(D, 0);
   };
   Random random(test_seed());
   SadCost<C> cost;
   WindowSum<C> window;
   std::vector<Column> columns(B);  // reset: zeros came before
   for (int clock = 0; clock < 300; ++clock) {
      Column column;
      column.tag.valid = !random.percent(25);
      column.tag.output_column = random.percent(50);
      column.tag.start_of_frame = random.percent(50);
      column.tag.end_of_line = random.percent(50);
      const bool saturated = random.percent(30);
      for (int d = 0; d < D; ++d) {
         cost.column[d] = uint16_t(saturated ? 255 * B : random.below(255 * B + 1));
         column.cost[std::size_t(d)] = cost.column[d];
      }
      cost.tag = column.tag;
      window.clock(cost);
      ASSERT_EQ(window.tag.valid, column.tag.valid);
      if (!column.tag.valid) continue;
      columns.push_back(column);
      const Column& centre = columns[columns.size() - 1 - r];
      ASSERT_EQ(window.tag.output_column, centre.tag.output_column) << "clock " << clock;
      ASSERT_EQ(window.tag.start_of_frame, centre.tag.start_of_frame) << "clock " << clock;
      ASSERT_EQ(window.tag.end_of_line, centre.tag.end_of_line) << "clock " << clock;
      for (int d = 0; d < D; ++d) {
         int sum = 0;
         for (std::size_t j = columns.size() - B; j < columns.size(); ++j) sum += columns[j].cost[std::size_t(d)];
         ASSERT_EQ(window.sum[d], sum) << "clock " << clock << " d=" << d;
      }
   }
}

TYPED_TEST(WindowSumTest, SumsTheLastColumnsAndTagsTheirCentre) {
   sums_the_last_columns_and_tags_their_centre<TypeParam::kConfig>();
}

}  // namespace
}  // namespace stereo::test
