// SPDX-License-Identifier: Apache-2.0
#include "cost/window_sum.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "cost/costs.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

/// Column costs of all lanes and disparities, [p][i].
using Costs = std::vector<int>;

/// What a window block reads of the block before it.
template <const block_matching::Config& C, int Count>
struct ColumnValues {
   ColumnCost<C> column[C.pixels_per_clock][Count] = {};
   PixelTag tag;

   void set(const PixelTag& new_tag, const Costs& costs) {
      tag = new_tag;
      for (std::size_t i = 0; i < costs.size(); ++i) column[i / Count][i % Count] = ColumnCost<C>(costs[i]);
   }
};

template <const block_matching::Config& C, int Count>
Costs random_costs(Random& random) {
   const bool saturated = random.percent(30);
   Costs costs(std::size_t(C.pixels_per_clock * Count));
   for (int& cost : costs) cost = saturated ? C.largest_column_cost() : random.below(C.largest_column_cost() + 1);
   return costs;
}

template <class Config>
class WindowSumTest : public ::testing::Test {};
TYPED_TEST_SUITE(WindowSumTest, SmallConfigs, ConfigNames);

TYPED_TEST(WindowSumTest, SumsTheLastColumnsAndTagsTheirCentre) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kCount = C.largest_slice(), B = C.window_px;
   // Columns of the window to the right of its centre: in the mirror image as many as otherwise to the left.
   constexpr int kAfter = C.reference == Reference::right ? (B - 1) / 2 : B / 2;
   Random random(test_seed());
   HeapMemories memories;
   ColumnValues<C, kCount> cost;
   WindowSum<C, kCount> window(memories, MemoryId<0>());
   const Costs zeros(std::size_t(C.pixels_per_clock * kCount), 0);
   std::vector<Costs> columns(B, zeros);  // reset: zeros came before
   std::vector<PixelTag> tags(B);
   for (int clock = 0; clock < 300; ++clock) {
      const PixelTag tag = random_tag(random);
      cost.set(tag, random_costs<C, kCount>(random));
      window.clock(cost);
      ASSERT_EQ(window.tag.valid, tag.valid);
      if (!tag.valid) continue;
      tags.push_back(tag);
      columns.emplace_back();
      for (const auto& lane : cost.column) columns.back().insert(columns.back().end(), lane, lane + kCount);
      PixelTag centre = tags[tags.size() - 1 - kAfter];
      centre.valid = true;
      ASSERT_PRED2(same_centre, centre, window.tag) << "clock " << clock;
      for (std::size_t i = 0; i < zeros.size(); ++i) {
         int sum = 0;
         for (std::size_t j = columns.size() - B; j < columns.size(); ++j) sum += columns[j][i];
         ASSERT_EQ(int(window.sum[i / kCount][i % kCount]), sum) << "clock " << clock << " [p][i] " << i;
      }
   }
}

/// Rows of an image through either block: windows see the cost columns of their own row and nothing else.
template <const block_matching::Config& C, template <const block_matching::Config&, int> class Block>
void sums_the_windows_of_each_row() {
   constexpr int kCount = 3, B = C.window_px, W = C.width_px, kFirst = C.first_cost_column();
   constexpr int kAfter = C.reference == Reference::right ? (B - 1) / 2 : B / 2, kBefore = B - 1 - kAfter;
   struct Step {
      bool valid = false, is_output = false;
      Costs sums;
   };
   Random random(test_seed());
   HeapMemories memories;
   ColumnValues<C, kCount> cost;
   Block<C, kCount> window(memories, MemoryId<0>());
   const Costs zeros(std::size_t(C.pixels_per_clock * kCount), 0);
   std::deque<Step> pipeline(std::size_t(window.kClocks) - 1);
   std::vector<Costs> row, row_before;
   int compared = 0;
   for (int n = 0; n < 20 * W;) {
      PixelTag tag = random_tag(random);
      Costs costs = random_costs<C, kCount>(random);
      Step step;
      if (tag.valid) {
         const int x = n % W;
         if (x == 0) {
            row_before = row;
            row.clear();
         }
         tag.border_column = x < kFirst;
         if (tag.border_column) costs = zeros;
         row.push_back(costs);
         tag.first_cost = x == kFirst;
         if (x >= kFirst) tag.leaves_window = x - B >= kFirst;
         else if (x < kAfter) tag.leaves_window = W + x - B >= kFirst;
         tag.map_column = x >= kFirst;  // every cost column, also the one that the map leaves out
         // The window that this column completes; at the left border it is one of the row before.
         const bool wraps = x < kAfter;
         const int centre = wraps ? W + x - kAfter : x - kAfter;
         const std::vector<Costs>& columns = wraps ? row_before : row;
         step = {true, centre >= kFirst && !columns.empty(), zeros};
         for (int column = centre - kBefore; step.is_output && column <= centre + kAfter; ++column)
            if (column >= kFirst && column < W)
               for (std::size_t i = 0; i < zeros.size(); ++i) step.sums[i] += columns[std::size_t(column)][i];
         ++n;
      }
      cost.set(tag, costs);
      window.clock(cost);
      pipeline.push_back(step);
      const Step now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(window.tag.valid, now.valid) << "record " << n;
      if (!now.is_output) continue;
      ASSERT_TRUE(window.tag.map_column) << "record " << n;
      for (std::size_t i = 0; i < zeros.size(); ++i)
         ASSERT_EQ(int(window.sum[i / kCount][i % kCount]), now.sums[i]) << "record " << n << " [p][i] " << i;
      ++compared;
   }
   EXPECT_GT(compared, 10 * (W - kFirst));
}

template <int W, int B, int P, Reference Side, Cost Kind>
using RowConfig =
    Exactly<block_matching::Config{{.width_px = W, .height_px = 36, .pixels_per_clock = P},
                                   {DisparityCount{16}, MatchingWindow{B}, ReferenceImage{Side}, Comparison{Kind}},
                                   {}}>;

template <class Config>
class WindowRowsTest : public ::testing::Test {};
using RowConfigs = ::testing::Types<
    RowConfig<18, 3, 1, Reference::right, Cost::sad>, RowConfig<40, 3, 2, Reference::left, Cost::ssd>,
    RowConfig<20, 2, 1, Reference::left, Cost::sad>, RowConfig<30, 8, 4, Reference::right, Cost::census>,
    RowConfig<24, 8, 1, Reference::left, Cost::ssd>, RowConfig<50, 31, 2, Reference::right, Cost::ssd>>;
TYPED_TEST_SUITE(WindowRowsTest, RowConfigs, ConfigNames);

TYPED_TEST(WindowRowsTest, AllColumnsAtOnceSumTheWindowsOfEachRow) {
   sums_the_windows_of_each_row<TypeParam::kConfig, WindowSum>();
}
TYPED_TEST(WindowRowsTest, RunningSumsAreTheWindowsOfEachRow) {
   sums_the_windows_of_each_row<TypeParam::kConfig, RunningWindowSum>();
}

}  // namespace
}  // namespace stereo::test
