// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_turn.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int width, int disparities, int clocks, bool has_forward_paths) {
   return {{.width_px = width, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{1},
            semi_global::Paths{.path_left = has_forward_paths, .path_above = has_forward_paths}},
           {Folding{clocks}}};
}
constexpr SgmConfig kFourPhases = config(40, 12, 4, true), kNoSums = config(40, 15, 5, false);
// Rows in two banks of memory.
constexpr SgmConfig kWide = config(300, 32, 16, true);

/// Rows of random numbers, and what stands between them.
template <const SgmConfig& C>
void expect_turned_rows(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   using Turn = semi_global::PhaseTurn<C>;
   constexpr int kWidth = C.output_width_px(), kRows = 5, kStride = C.width_px, kColumns = kRows * kStride;
   Random random(test_seed());
   struct Column {
      int smallest = 0;
      std::vector<int> costs, sums;
   };
   std::vector<Column> columns = std::vector<Column>(kColumns);
   for (Column& column : columns) {
      column.smallest = random.below(C.largest_cost() + 1);
      for (int d = 0; d < C.disparities; ++d) {
         column.costs.push_back(random.below(C.largest_cost() + 1));
         column.sums.push_back(random.below(C.largest_forward_sum() + 1));
      }
   }
   /// What comes out beside a column of the map: of the row before, from its last column to its first.
   const auto turned = [&](int column) -> const Column* {
      const int x = column % kStride, y = column / kStride;
      return column < 0 || x >= kWidth || y == 0 ? nullptr : &columns[std::size_t((y - 1) * kStride + kWidth - 1 - x)];
   };

   HeapMemories memories;
   Turn turn(memories, MemoryId<0>());
   PhaseStream<C> stream(random, bubbles_percent);
   int compared = 0;
   for (int rest = 200; rest > 0;) {
      const auto before = stream.at(At::kPaths - 1), here = stream.at(At::kPaths), later = stream.at(At::kPathCosts);
      if (const Column* const column = turned(before.column); column && before.phase == 0) {
         ASSERT_EQ(int(turn.ready_smallest[0]), column->smallest) << "column " << before.column;
      }
      if (const Column* const column = turned(here.column)) {
         semi_global::PathCost<C> costs[At::kLanes];
         turn.costs(costs);
         for (int l = 0; l < At::kLanes; ++l) {
            const int d = here.phase * At::kLanes + l;
            ASSERT_EQ(int(costs[l]), column->costs[std::size_t(d)]) << "column " << here.column << " d=" << d;
            ++compared;
         }
      }
      if constexpr (Turn::kHasSums)
         if (const Column* const column = turned(later.column))
            for (int l = 0; l < At::kLanes; ++l) {
               const int d = later.phase * At::kLanes + l;
               ASSERT_EQ(int(turn.sum(l)), column->sums[std::size_t(d)]) << "column " << later.column << " d=" << d;
            }
      semi_global::PathCost<C> smallest = semi_global::PathCost<C>(random.below(C.largest_cost() + 1));
      if (before.column >= 0 && before.phase == 0)
         smallest = semi_global::PathCost<C>(columns[std::size_t(before.column)].smallest);
      semi_global::PathCost<C> costs_in[At::kLanes];
      semi_global::ForwardSum<C> sums_in[At::kLanes];
      for (int l = 0; l < At::kLanes; ++l) {
         const auto of = [&](const auto& place, const auto& values, int largest) {
            return place.column < 0 ? random.below(largest + 1) : values[std::size_t(place.phase * At::kLanes + l)];
         };
         const Column none;
         costs_in[l] = semi_global::PathCost<C>(
             of(here, here.column < 0 ? none.costs : columns[std::size_t(here.column)].costs, C.largest_cost()));
         sums_in[l] = semi_global::ForwardSum<C>(of(
             later, later.column < 0 ? none.sums : columns[std::size_t(later.column)].sums, C.largest_forward_sum()));
      }
      turn.clock(stream.line, smallest, costs_in, sums_in);
      PixelTag tag;
      const int x = stream.sent() % kStride;
      tag.valid = stream.sent() < kColumns;
      tag.map_column = x < kWidth;
      tag.output_column = tag.map_column;
      tag.first_column = x == 0;
      tag.end_of_line = x == kWidth - 1;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_EQ(compared, (kRows - 1) * kWidth * C.disparities);
}

TEST(PhaseTurn, ShowsTheRowBeforeFromItsEnd) {
   for (const int bubbles : {0, 10, 70}) {
      expect_turned_rows<kFourPhases>(bubbles);
      expect_turned_rows<kNoSums>(bubbles);
   }
   expect_turned_rows<kWide>(10);
}

}  // namespace
}  // namespace stereo::test
