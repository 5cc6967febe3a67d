// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_window.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, int window, Cost cost) {
   return {{.width_px = 60, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{window}, Comparison{cost}},
           {Folding{clocks}}};
}
constexpr SgmConfig kPair = config(8, 4, 2, Cost::sad), kThree = config(15, 5, 3, Cost::census),
                    kLarge = config(32, 16, 9, Cost::sad);

/// What the block sees of the column costs.
template <const SgmConfig& C>
struct Columns {
   ColumnCost<semi_global::kWindowConfig<C>> column[1][semi_global::Stages<C>::kLanes];
};

template <const SgmConfig& C>
void expect_sums(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   static constexpr auto kWindows = C.windows();
   constexpr int kColumns = 80;
   Random random(test_seed());
   std::vector<int> costs(std::size_t(kColumns * C.disparities));
   for (int& cost : costs)
      cost = random.percent(20) ? kWindows.largest_column_cost() : random.below(kWindows.largest_column_cost() + 1);
   const auto of = [&](int x, int d) { return x < 0 ? 0 : costs[std::size_t(x * C.disparities + d)]; };

   HeapMemories memories;
   semi_global::PhaseWindow<C> window(memories, MemoryId<0>());
   PhaseStream<C> stream(random, bubbles_percent);
   int compared = 0;
   for (int rest = 100; rest > 0;) {
      const auto shown = stream.at(At::kWindows);
      if (shown.column >= 0)
         for (int l = 0; l < At::kLanes; ++l) {
            const int d = shown.phase * At::kLanes + l;
            int sum = 0;
            for (int i = 0; i < C.window_px; ++i) sum += of(shown.column - i, d);  // zeros before the first column
            ASSERT_EQ(int(window.sum[0][l]), sum) << "column " << shown.column << " d=" << d;
            ++compared;
         }
      Columns<C> in;
      const auto entering = stream.at(At::kWindows - 1);
      for (int l = 0; l < At::kLanes; ++l)
         in.column[0][l] = ColumnCost<semi_global::kWindowConfig<C>>(
             entering.column < 0 ? random.below(kWindows.largest_column_cost() + 1)
                                 : of(entering.column, entering.phase * At::kLanes + l));
      window.clock(in, stream.line);
      PixelTag tag;
      tag.valid = stream.sent() < kColumns;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_EQ(compared, kColumns * C.disparities);
}

TEST(PhaseWindow, SumsTheLastColumns) {
   for (const int bubbles : {0, 10, 70}) {
      expect_sums<kPair>(bubbles);
      expect_sums<kThree>(bubbles);
      expect_sums<kLarge>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
