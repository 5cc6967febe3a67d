// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_shift.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, int window, Cost cost) {
   return {{.width_px = 60, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{window}, Comparison{cost}},
           {Folding{clocks}}};
}
constexpr SgmConfig kSingle = config(12, 4, 1, Cost::census), kWindow = config(15, 5, 3, Cost::sad),
                    kTwoLanes = config(32, 16, 2, Cost::sad);

/// Lane l of phase p has the pixel that came p * lanes + l columns before.
template <const SgmConfig& C>
void expect_phases(int bubbles_percent) {
   using Shift = semi_global::PhaseShift<C>;
   using Value = typename Shift::Value;
   Random random(test_seed());
   HeapMemories memories;
   Shift shift(memories, MemoryId<0>());
   std::vector<std::vector<Value>> search, reference;
   int rest = 0, shown = 0;
   for (int clock = 0; clock < 3000; ++clock) {
      Value search_in[Shift::kTaps], reference_in[Shift::kTaps];
      for (int t = 0; t < Shift::kTaps; ++t) {
         search_in[t] = Value(random.below(256));
         reference_in[t] = Value(random.below(256));
      }
      PixelTag tag;
      tag.valid = rest == 0 && !random.percent(bubbles_percent);
      tag.map_column = search.size() % 3 == 0;
      rest = tag.valid ? Shift::kPhases - 1 : rest > 0 ? rest - 1 : 0;
      if (tag.valid) {
         search.emplace_back(search_in, search_in + Shift::kTaps);
         reference.emplace_back(reference_in, reference_in + Shift::kTaps);
      }
      shift.clock(search_in, reference_in, tag);
      if (!shift.tag.valid) continue;
      const int column = shown / Shift::kPhases, phase = shown % Shift::kPhases;
      ++shown;
      ASSERT_EQ(shift.tag.map_column, column % 3 == 0);
      for (int t = 0; t < Shift::kTaps; ++t) {
         ASSERT_EQ(shift.reference[t], reference[std::size_t(column)][std::size_t(t)]) << "column " << column;
         for (int l = 0; l < Shift::kLanes; ++l) {
            const int from = column - phase * Shift::kLanes - l;
            const Value expected = from < 0 ? Value(0) : search[std::size_t(from)][std::size_t(t)];
            ASSERT_EQ(shift.search[t][l], expected) << "column " << column << " phase " << phase << " lane " << l;
         }
      }
   }
   EXPECT_GE(shown, int(search.size() - 2) * Shift::kPhases);
   EXPECT_GT(search.size(), 50u);
}

TEST(PhaseShift, ShowsEachPhaseItsPixels) {
   for (const int bubbles : {0, 30, 80}) {
      expect_phases<kSingle>(bubbles);
      expect_phases<kWindow>(bubbles);
      expect_phases<kTwoLanes>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
