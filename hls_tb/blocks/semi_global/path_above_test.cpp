// SPDX-License-Identifier: Apache-2.0
#include "semi_global/path_above.hpp"

#include <gtest/gtest.h>

#include "definition/semi_global/reference_model.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int width, int disparities, int cost_cap, int p1, int p2) {
   return {{.width_px = width, .height_px = 20},
           {DisparityCount{disparities}, CostScale{.cost_shift = 0, .cost_cap = cost_cap},
            semi_global::Paths{.p1 = p1, .p2 = p2}},
           {}};
}

constexpr SgmConfig kD12 = config(40, 12, 13, 5, 22), kD17 = config(50, 17, 40, 0, 300),
                    kD19 = config(37, 19, 3, 50, 1);

/// Two frames, one behind the other, each a volume of costs.
template <const SgmConfig& C>
void expect_path(int bubbles_percent) {
   constexpr int kWidth = C.output_width_px(), kRows = 6, kFrames = 2, kStride = C.width_px;
   constexpr int kMoves = semi_global::PathAbove<C>::kMoves;
   Random random(test_seed());
   std::vector<CostVolume> frames(kFrames, CostVolume(kWidth, kRows, C.disparities)), expected;
   for (CostVolume& frame : frames) {
      for (int& value : frame.values) value = random.below(C.cost_cap + 1);
      expected.push_back(path_from_above(frame, C));
   }

   HeapMemories memories;
   semi_global::PathAbove<C> path(memories, MemoryId<0>());
   semi_global::PathEntry<C> entry;
   const int columns = kFrames * kRows * kStride;
   int sent = 0, entered = 0, compared = 0;
   // What enters in the next clock, -1 for a bubble: its address comes a clock before it.
   int next = -1;
   while (entered < columns + kMoves) {
      const int now = next;
      next = random.percent(bubbles_percent) ? -1 : sent++;
      const int x = next % kStride;
      entry.next_column = next >= 0 && x < kWidth ? uint16_t(x) : uint16_t(random.below(kWidth));
      entry.next_tag.valid = next >= 0;
      entry.tag.valid = now >= 0;
      entry.moves_above.clock(now >= 0);
      const int frame = now / (kRows * kStride), y = now / kStride % kRows, at = now % kStride;
      entry.tag.map_column = now >= 0 ? at < kWidth : random.percent(50);
      entry.top = now >= 0 && y == 0;
      entry.column = uint16_t(now >= 0 && at < kWidth ? at : random.below(kWidth));
      const bool real = now >= 0 && now < columns && at < kWidth;
      for (int d = 0; d < C.disparities; ++d)
         entry.cost[d] =
             semi_global::PathCost<C>(real ? frames[std::size_t(frame)].at(at, y, d) : random.below(C.cost_cap + 1));
      path.clock(entry);
      if (now < 0) continue;
      ++entered;
      const int shown = now + 1 - kMoves;
      if (shown < 0 || shown >= columns || shown % kStride >= kWidth) continue;
      for (int d = 0; d < C.disparities; ++d)
         ASSERT_EQ(path.cost[d],
                   expected[std::size_t(shown / (kRows * kStride))].at(shown % kStride, shown / kStride % kRows, d))
             << "column " << shown << " d=" << d;
      ++compared;
   }
   EXPECT_EQ(compared, kFrames * kRows * kWidth);
}

TEST(PathAbove, IsThatOfTheDefinition) {
   for (const int bubbles : {0, 40}) {
      expect_path<kD12>(bubbles);
      expect_path<kD17>(bubbles);
      expect_path<kD19>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
