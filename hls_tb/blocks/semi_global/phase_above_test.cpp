// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_above.hpp"

#include <gtest/gtest.h>

#include "definition/semi_global/reference_model.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int width, int disparities, int clocks, int cost_cap, int p1, int p2) {
   return {{.width_px = width, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{1}, CostScale{.cost_shift = 0, .cost_cap = cost_cap},
            semi_global::Paths{.p1 = p1, .p2 = p2}},
           {Folding{clocks}}};
}

constexpr SgmConfig kD12 = config(40, 12, 4, 13, 5, 22), kD15 = config(50, 15, 5, 11, 0, 300),
                    kD32 = config(45, 32, 16, 3, 50, 1);
// Rows in two banks of memory.
constexpr SgmConfig kWide = config(300, 32, 16, 7, 4, 20);

/// Two frames, one behind the other, each a volume of costs.
template <const SgmConfig& C>
void expect_path(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   constexpr int kWidth = C.output_width_px(), kRows = 4, kFrames = 2, kStride = C.width_px;
   constexpr int kColumns = kFrames * kRows * kStride;
   Random random(test_seed());
   std::vector<CostVolume> frames(kFrames, CostVolume(kWidth, kRows, C.disparities)), expected;
   for (CostVolume& frame : frames) {
      for (int& value : frame.values) value = random.below(C.largest_cost() + 1);
      expected.push_back(path_from_above(frame, C));
   }
   const auto in = [](const std::vector<CostVolume>& volumes, int column, int d) {
      return volumes[std::size_t(column / (kRows * kStride))].at(column % kStride, column / kStride % kRows, d);
   };

   HeapMemories memories;
   semi_global::PhaseAbove<C> path(memories, MemoryId<0>());
   PhaseStream<C> stream(random, bubbles_percent);
   int compared = 0;
   for (int rest = 200; rest > 0;) {
      const auto shown = stream.at(At::kPathCosts);
      if (shown.column >= 0 && shown.column % kStride < kWidth)
         for (int l = 0; l < At::kLanes; ++l) {
            const int d = shown.phase * At::kLanes + l;
            ASSERT_EQ(path.cost[l], in(expected, shown.column, d)) << "column " << shown.column << " d=" << d;
            ++compared;
         }
      semi_global::PathCost<C> costs_in[At::kLanes];
      const auto entering = stream.at(At::kCosts);
      const bool real = entering.column >= 0 && entering.column % kStride < kWidth;
      for (int l = 0; l < At::kLanes; ++l)
         costs_in[l] = semi_global::PathCost<C>(real ? in(frames, entering.column, entering.phase * At::kLanes + l)
                                                     : random.below(C.largest_cost() + 1));
      path.clock(stream.line, costs_in);
      PixelTag tag;
      const int x = stream.sent() % kStride;
      tag.valid = stream.sent() < kColumns;
      tag.map_column = x < kWidth;
      tag.first_column = x == 0;
      tag.start_of_frame = x == 0 && stream.sent() / kStride % kRows == 0;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_EQ(compared, kFrames * kRows * kWidth * C.disparities);
}

TEST(PhaseAbove, IsThatOfTheDefinition) {
   for (const int bubbles : {0, 10, 70}) {
      expect_path<kD12>(bubbles);
      expect_path<kD15>(bubbles);
      expect_path<kD32>(bubbles);
   }
   expect_path<kWide>(10);
}

}  // namespace
}  // namespace stereo::test
