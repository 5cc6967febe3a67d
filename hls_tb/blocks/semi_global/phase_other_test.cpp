// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_other.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "semi_global/phase_winners.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, Reference side, Ties ties, bool path_right,
                           bool full_width = false) {
   return {{.width_px = 50, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{full_width ? 2 : 1}, ReferenceImage{side}, TieRule{ties},
            LeftRightThreshold{1}, FullWidth{.full_width = full_width}, semi_global::Paths{.path_right = path_right}},
           {Folding{clocks}}};
}
constexpr SgmConfig kRight = config(12, 4, Reference::right, Ties::smallest, true),
                    kLeft = config(15, 5, Reference::left, Ties::largest, true),
                    kTwoLanes = config(16, 8, Reference::right, Ties::largest, true),
                    kRightForward = config(12, 4, Reference::right, Ties::largest, false),
                    kLeftForward = config(20, 5, Reference::left, Ties::smallest, false),
                    kFullWidth = config(12, 4, Reference::left, Ties::smallest, true, true),
                    kFullForward = config(12, 6, Reference::right, Ties::smallest, false, true);

/// What the block sees of the paths.
template <const SgmConfig& C>
struct Paths {
   WindowCost<semi_global::kSumConfig<C>> sums[semi_global::Stages<C>::kLanes];

   auto shown(int lane) const { return sums[lane]; }
};

template <const SgmConfig& C>
void expect_other_winners(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   using Other = semi_global::PhaseOther<C>;
   using Mask = typename semi_global::PhaseWinners<C>::Mask;
   constexpr int D = C.disparities, kWidth = C.output_width_px(), kStride = C.width_px, kRows = 5;
   constexpr int kColumns = kRows * kStride;
   constexpr bool kIsRight = C.reference == Reference::right, kTurned = C.path_right;
   Random random(test_seed());
   std::vector<int> sums(std::size_t(kColumns * D));
   for (int& sum : sums) sum = random.percent(90) ? random.below(4) : random.below(C.largest_sum() + 1);
   /// Sum of the row that comes out with number `row`, at column x of the map.
   const auto at = [&](int row, int x, int d) {
      return sums[std::size_t((row * kStride + (kTurned ? kWidth - 1 - x : x)) * D + d)];
   };
   /// docs/algorithm.md, 5.; -1: no disparity of the map leads there.
   const auto winner = [&](int row, int other) {
      int best = -1, smallest = 0;
      for (int d = 0; d < D; ++d) {
         const int x = kIsRight ? other - d : other + d;
         if (x < 0 || x >= kWidth) continue;
         const int sum = at(row, x, d);
         if (best < 0 || sum < smallest || (sum == smallest && C.ties == Ties::largest)) {
            best = d;
            smallest = sum;
         }
      }
      return best;
   };

   HeapMemories memories;
   Other other(memories, MemoryId<0>());
   [[maybe_unused]] Mask mask;
   PhaseStream<C> stream(random, bubbles_percent);
   int compared = 0;
   for (int rest = 200; rest > 0;) {
      const auto shown = stream.centre_at(At::kSums + 1);
      const int row = shown.column / kStride;
      if (shown.column >= 0 && shown.phase == At::kPhases - 1 && (!kTurned || row > 0)) {
         // The pixel that has met its last disparity with column k: turned rows come from their last column to their
         // first, so that the other image's pixels meet the disparities the other way round.
         const int k = shown.column % kStride, x = kTurned ? kWidth - 1 - k : k;
         const bool leaves_at_zero = kIsRight != kTurned;
         const int of = (kIsRight ? 1 : -1) * (leaves_at_zero ? 0 : D - 1) + x;
         const bool is_in_map = !C.full_width || (of >= 0 && of < kWidth && k < kWidth);
         if (const int expected = winner(row, of); expected >= 0 && is_in_map) {
            ASSERT_EQ(int(other.leaving()), expected) << "row " << row << " k=" << k;
            ++compared;
         }
      }
      Paths<C> paths;
      const auto entering = stream.centre_at(At::kSums);
      for (int l = 0; l < At::kLanes; ++l) {
         const int lane = entering.phase * At::kLanes + l, d = kIsRight ? D - 1 - lane : lane;
         paths.sums[l] = WindowCost<semi_global::kSumConfig<C>>(
             entering.column < 0 ? random.below(4) : sums[std::size_t(entering.column * D + d)]);
      }
      other.clock(paths, stream.line, mask);
      if constexpr (C.full_width) mask.clock(stream.line, NoSettings(), FixedSize<semi_global::kWindowConfig<C>>());
      PixelTag tag;
      const int x = stream.sent() % kStride;
      tag.valid = stream.sent() < kColumns;
      tag.map_column = tag.output_column = x < kWidth;
      tag.first_column = x == 0;
      tag.start_of_frame = stream.sent() == 0;
      tag.end_of_line = x == kWidth - 1;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_GE(compared, (kRows - 1) * (kWidth - D));
}

TEST(PhaseOther, FindsTheOtherImagesWinners) {
   for (const int bubbles : {0, 10, 70}) {
      expect_other_winners<kRight>(bubbles);
      expect_other_winners<kLeft>(bubbles);
      expect_other_winners<kTwoLanes>(bubbles);
      expect_other_winners<kRightForward>(bubbles);
      expect_other_winners<kLeftForward>(bubbles);
      expect_other_winners<kFullWidth>(bubbles);
      expect_other_winners<kFullForward>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
