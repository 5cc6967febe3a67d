// SPDX-License-Identifier: Apache-2.0
#include "cost/column_cost.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "cost/disparity_shift.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

constexpr int kCount = 3;

/// Features of a frame; 0 outside, as the line buffer gives them.
template <const block_matching::Config& C>
struct Frame {
   std::vector<uint64_t> search, reference;

   explicit Frame(Random& random) {
      const bool extreme = random.percent(30);  // every cost as large as it gets
      const uint64_t mask = (uint64_t(1) << C.feature_bits()) - 1;
      for (int i = 0; i < C.width_px * C.height_px; ++i)
         reference.push_back(extreme ? 0 : mix_bits(random.bits()) & mask);
      for (int i = 0; i < C.width_px * C.height_px * kCount; ++i)
         search.push_back(extreme ? mask : mix_bits(random.bits()) & mask);
   }
   static bool inside(int y) { return y >= 0 && y < C.height_px; }
   uint64_t reference_at(int x, int y) const { return inside(y) ? reference[std::size_t(y * C.width_px + x)] : 0; }
   uint64_t search_at(int x, int y, int i) const {
      return inside(y) ? search[std::size_t((y * C.width_px + x) * kCount + i)] : 0;
   }
   int cost(int x, int y, int i) const {
      const uint64_t a = search_at(x, y, i), b = reference_at(x, y);
      const int difference = std::abs(int(a) - int(b));
      return C.cost == Cost::census ? std::popcount(a ^ b) : C.cost == Cost::ssd ? difference * difference : difference;
   }
   /// The definition: all rows of the window around (x,y).
   int column_sum(int x, int y, int i) const {
      int sum = 0;
      for (int row = y - C.window_px / 2; row <= y + (C.window_px - 1) / 2; ++row) sum += cost(x, row, i);
      return sum;
   }
};

template <const block_matching::Config& C>
struct ColumnBench {
   struct Step {
      PixelTag tag;
      std::vector<int> column;  ///< [p][i]; empty: without meaning
   };
   static constexpr int P = C.pixels_per_clock;

   Random random{test_seed()};
   HeapMemories memories;
   ColumnBlock<C, kCount> block{memories, MemoryId<0>()};
   DisparityShift<C, kCount> shift;
   std::deque<Step> pipeline = std::deque<Step>(std::size_t(block.kClocks) - 1);
   int compared = 0;

   void clock(const Step& step) {
      shift.tag = step.tag;
      block.clock(shift);
      pipeline.push_back(step);
      const Step now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(block.tag, now.tag);
      for (std::size_t i = 0; i < now.column.size(); ++i)
         ASSERT_EQ(int(block.column[i / kCount][i % kCount]), now.column[i])
             << "lane " << i / kCount << " i=" << i % kCount;
      compared += int(now.column.size());
   }
   void bubble() {
      Step step{random_tag(random), {}};
      step.tag.valid = false;
      for (int t = 0; t < C.tap_rows(); ++t) {
         shift.reference[t] = Feature<C>(random.byte());
         for (int i = 0; i < kCount; ++i) shift.search[t][i] = Feature<C>(random.byte());
      }
      clock(step);
   }
   /// The first `records` of a frame and of the groups that its last windows wait for.
   void send(const Frame<C>& frame, int records) {
      const std::vector<int> taps = tap_offsets(C);
      for (int n = 0; n < records; ++n) {
         const int x = n % C.width_px, group = n / C.width_px, y = (group - C.delay_groups()) * P;
         while (random.percent(25)) ASSERT_NO_FATAL_FAILURE(bubble());
         Step step{random_tag(random), std::vector<int>(std::size_t(P * kCount), 0)};
         step.tag.valid = true;
         step.tag.row_start = x == 0;
         step.tag.first_group = group == 0;
         step.tag.border_column = x < C.first_cost_column();
         for (int t = 0; t < C.tap_rows(); ++t) {
            shift.reference[t] = Feature<C>(frame.reference_at(x, y + taps[std::size_t(t)]));
            for (int i = 0; i < kCount; ++i)
               shift.search[t][i] = Feature<C>(frame.search_at(x, y + taps[std::size_t(t)], i));
         }
         for (int p = 0; p < P && !step.tag.border_column; ++p)
            for (int i = 0; i < kCount; ++i) step.column[std::size_t(p * kCount + i)] = frame.column_sum(x, y + p, i);
         ASSERT_NO_FATAL_FAILURE(clock(step)) << "before x=" << x << " group " << group;
      }
   }
};

template <Cost Kind, int B, int P, Aggregation How>
using ColumnConfig = Exactly<block_matching::Config{
    {.width_px = 11, .height_px = 12, .pixels_per_clock = P},
    {DisparityCount{7}, MatchingWindow{B}, Comparison{Kind}, CensusWindow{.census_width_px = 9, .census_height_px = 7}},
    {Summation{How}}}>;

template <class Config>
class ColumnCostTest : public ::testing::Test {};
using Configs = ::testing::Types<
    ColumnConfig<Cost::sad, 3, 1, Aggregation::recursive>, ColumnConfig<Cost::sad, 8, 2, Aggregation::recursive>,
    ColumnConfig<Cost::ssd, 5, 4, Aggregation::recursive>, ColumnConfig<Cost::ssd, 2, 1, Aggregation::recursive>,
    ColumnConfig<Cost::census, 7, 1, Aggregation::recursive>, ColumnConfig<Cost::census, 6, 4, Aggregation::recursive>,
    ColumnConfig<Cost::ssd, 3, 1, Aggregation::direct>, ColumnConfig<Cost::ssd, 6, 2, Aggregation::direct>,
    ColumnConfig<Cost::census, 4, 4, Aggregation::direct>, ColumnConfig<Cost::sad, 5, 1, Aggregation::direct>>;
TYPED_TEST_SUITE(ColumnCostTest, Configs, ConfigNames);

TYPED_TEST(ColumnCostTest, SumsTheColumnOfEachWindow) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   ColumnBench<C> bench;
   const int whole = (C.row_groups() + C.delay_groups()) * C.width_px;
   for (int round = 0; round < 12; ++round) {
      SCOPED_TRACE("frame " + std::to_string(round));
      const Frame<C> frame(bench.random);
      // A frame after a whole one, or after one that was cut off.
      const int records = round % 3 == 2 ? 1 + bench.random.below(whole) : whole;
      ASSERT_NO_FATAL_FAILURE(bench.send(frame, records));
   }
   EXPECT_GT(bench.compared, 8 * whole);
}

}  // namespace
}  // namespace stereo::test
