// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_row_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "definition/semi_global/reference_model.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using semi_global::RowDirection;
using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, int cost_cap, int p1, int p2, int p2_least = -1) {
   return {{.width_px = 100 + disparities, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{1}, CostScale{.cost_shift = 0, .cost_cap = cost_cap},
            semi_global::Paths{.p1 = p1, .p2 = p2, .p2_least = p2_least}},
           {Folding{clocks}}};
}

// The shortest loop, and longer ones; two lanes, and more, also an odd number; penalties around the largest cost.
constexpr SgmConfig kD12 = config(12, 4, 13, 5, 22), kD8 = config(8, 4, 15, 0, 1), kD20 = config(20, 5, 11, 7, 90);
constexpr SgmConfig kD64 = config(64, 8, 15, 4, 24), kD32 = config(32, 16, 3, 12, 50);
// P2 that falls: by little, to 0, by more than the largest cost; a look back of 7 to 12 columns.
constexpr SgmConfig kFalls8 = config(8, 4, 7, 8, 60, 16), kFalls12 = config(12, 4, 13, 5, 22, 20);
constexpr SgmConfig kFalls20 = config(20, 4, 11, 7, 90, 63), kFalls32 = config(32, 16, 3, 12, 50, 0);
constexpr SgmConfig kFalls64 = config(64, 8, 5, 7, 60, 20), kFalls128 = config(128, 8, 5, 7, 60, 20);
constexpr SgmConfig kFalls256 = config(256, 32, 1, 0, 1, 0);

/// Stands for the block that knows the relief of each column.
template <const SgmConfig& C>
struct GivenStarts {
   const PhaseStream<C>& stream;
   const DeepImage& relief;
   int stride;

   template <bool Turned, int Stage>
   semi_global::RowPathValue<C> at() const {
      const auto place = stream.at(Stage);
      const int x = place.column < 0 ? 0 : place.column % stride;
      const int fall = x == 0 || x >= relief.width ? 0 : relief.at(x, place.column / stride);
      return semi_global::RowPathValue<C>(C.row_path_bias() - fall);
   }
};

/// Rows and what stands between them; every second row has costs that drive the path to its bounds.
template <const SgmConfig& C>
void expect_path(int bubbles_percent) {
   using Path = semi_global::PhaseRowPath<C>;
   using At = semi_global::Stages<C>;
   constexpr int kWidth = 60, kRows = 7, kStride = kWidth + 9, kColumns = kRows * kStride;
   Random random(test_seed());
   CostVolume costs(kStride, kRows, C.disparities), of_map(kWidth, kRows, C.disparities);
   for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kStride; ++x)
         for (int d = 0; d < C.disparities; ++d) {
            const bool follows = y % 3 == 2 && d == 3 + x / 9 % 3;
            const int cap = C.largest_cost();
            costs.at(x, y, d) = follows ? 0 : y % 2 == 0 ? random.below(cap + 1) : cap * random.below(2);
            if (x < kWidth) of_map.at(x, y, d) = costs.at(x, y, d);
         }
   DeepImage relief(kWidth, kRows);
   for (int y = 0; y < kRows && C.has_relief(); ++y)
      for (int x = 0; x < kWidth; ++x)  // edges stand far apart, in runs, or everywhere
         if (random.percent(y % 3 == 0 ? 8 : y % 3 == 1 ? 40 : 90))
            relief.at(x, y) = uint16_t(random.percent(50) ? C.largest_relief() : random.below(C.largest_relief() + 1));
   const CostVolume expected = row_path(of_map, relief, RowDirection::from_left, C);

   HeapMemories memories;
   Path path(memories, MemoryId<0>());
   PhaseStream<C> stream(random, bubbles_percent);
   const GivenStarts<C> starts{stream, relief, kStride};
   int compared = 0;
   for (int rest = 200; rest > 0;) {
      const auto shown = stream.at(At::kPathCosts);
      if (shown.column >= 0 && shown.column % kStride < kWidth)
         for (int l = 0; l < At::kLanes; ++l) {
            const int x = shown.column % kStride, y = shown.column / kStride, d = shown.phase * At::kLanes + l;
            ASSERT_EQ(int(path.cost[l]) - C.row_path_bias(), expected.at(x, y, d))
                << "x=" << x << " y=" << y << " d=" << d;
            ++compared;
         }
      semi_global::PathCost<C> costs_in[At::kLanes], smallest = 0;
      const auto entering = stream.at(At::kPaths), next = stream.at(At::kPaths - 1);
      for (int l = 0; l < At::kLanes; ++l)
         costs_in[l] = semi_global::PathCost<C>(
             entering.column < 0
                 ? random.below(C.largest_cost() + 1)
                 : costs.at(entering.column % kStride, entering.column / kStride, entering.phase * At::kLanes + l));
      if (next.column >= 0 && next.phase == 0) {
         int least = C.largest_cost();
         for (int d = 0; d < C.disparities; ++d)
            least = std::min(least, costs.at(next.column % kStride, next.column / kStride, d));
         smallest = semi_global::PathCost<C>(least);
      }
      path.clock(stream.line, smallest, costs_in, starts);
      PixelTag tag;
      const int x = stream.sent() % kStride;
      tag.valid = stream.sent() < kColumns;
      tag.map_column = x < kWidth;
      tag.first_column = x == 0;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_EQ(compared, kWidth * kRows * C.disparities);
}

TEST(PhaseRowPath, IsThatOfTheDefinition) {
   for (const int bubbles : {0, 10, 70}) {
      expect_path<kD8>(bubbles);
      expect_path<kD12>(bubbles);
      expect_path<kD20>(bubbles);
      expect_path<kD32>(bubbles);
      expect_path<kD64>(bubbles);
      expect_path<kFalls8>(bubbles);
      expect_path<kFalls12>(bubbles);
      expect_path<kFalls20>(bubbles);
      expect_path<kFalls32>(bubbles);
      expect_path<kFalls64>(bubbles);
      expect_path<kFalls128>(bubbles);
      expect_path<kFalls256>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
