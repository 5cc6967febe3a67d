// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_winners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "semi_global/settings.hpp"
#include "testing/expect_candidate.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, Reference side, Ties ties, int uniqueness, bool subpixel,
                           bool full_width = false) {
   return {{.width_px = 50, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{full_width ? 2 : 1}, ReferenceImage{side}, TieRule{ties},
            semi_global::UniquenessDistance{uniqueness}, SubpixelSteps{subpixel}, FullWidth{.full_width = full_width}},
           {Folding{clocks}}};
}
constexpr SgmConfig kRight = config(12, 4, Reference::right, Ties::smallest, 0, false),
                    kLeft = config(12, 4, Reference::left, Ties::smallest, 0, true),
                    kRightTies = config(15, 5, Reference::right, Ties::largest, 3, true),
                    kLeftTies = config(32, 16, Reference::left, Ties::largest, 5, true),
                    kTwoLanes = config(16, 8, Reference::right, Ties::smallest, 4, false),
                    kFullWidth = config(20, 4, Reference::right, Ties::smallest, 0, false, true);

/// What the block sees of the paths.
template <const SgmConfig& C>
struct Paths {
   WindowCost<semi_global::kSumConfig<C>> sums[semi_global::Stages<C>::kLanes];

   auto shown(int lane) const { return sums[lane]; }
};

template <const SgmConfig& C>
void expect_winners(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   constexpr int kWidth = C.output_width_px(), kStride = kWidth + 5, kRows = 4, kColumns = kRows * kStride;
   constexpr bool kIsRight = C.reference == Reference::right;
   Random random(test_seed());
   semi_global::PhaseWinners<C> winners;
   std::vector<std::vector<int>> sums(kColumns, std::vector<int>(C.disparities));
   for (std::vector<int>& column : sums)
      for (int& sum : column)
         sum = random.percent(90) ? random.below(4) : random.below(C.largest_sum() + 1);  // few, often equal
   const auto expected = [&](int column) {
      std::vector<int> costs = sums[std::size_t(column)];
      if constexpr (C.full_width) {
         constexpr int kNone = semi_global::kSumConfig<C>.largest_window_cost() + 1;
         const int x = kWidth - 1 - column % kStride;  // turned
         for (int d = 0; d < C.disparities; ++d)
            if (const int other = kIsRight ? x + d : x - d; other < 0 || other >= kWidth) costs[std::size_t(d)] = kNone;
      }
      return NaiveWinner(costs, C.ties);
   };
   PhaseStream<C> stream(random, bubbles_percent);
   std::optional<int> late;  // whose losers come in this clock
   int compared = 0;
   for (int rest = 200; rest > 0;) {
      if (late) expect_losers<semi_global::kSumConfig<C>>(expected(*late), winners.best.losers(0, 0));
      late.reset();
      const auto shown = stream.centre_at(At::kBest);
      const auto newest = stream.at(At::kBest);
      ASSERT_EQ(winners.best_tag.valid, newest.column >= 0 && newest.phase == 0);
      if (winners.best_tag.valid && shown.column >= 0) {
         const int x = shown.column % kStride, row = shown.column / kStride;
         ASSERT_EQ(winners.best_tag.map_column, x < kWidth);
         // The row before, turned round.
         ASSERT_EQ(winners.best_tag.output_column, x < kWidth && row > 0);
         ASSERT_EQ(winners.best_tag.first_column, x == 0);
         ASSERT_EQ(winners.best_tag.start_of_frame, x == 0 && row == 1);
         ASSERT_EQ(winners.best_tag.end_of_line, x == kWidth - 1);
         if (x < kWidth) {
            expect_candidate<semi_global::kSumConfig<C>>(expected(shown.column), winners.best.get(0, 0));
            late = shown.column;
            ++compared;
         }
      }
      Paths<C> paths;
      const auto entering = stream.centre_at(At::kSums);
      for (int l = 0; l < At::kLanes; ++l) {
         const int lane = entering.phase * At::kLanes + l, d = kIsRight ? C.disparities - 1 - lane : lane;
         paths.sums[l] = WindowCost<semi_global::kSumConfig<C>>(
             entering.column < 0 ? random.below(4) : sums[std::size_t(entering.column)][std::size_t(d)]);
      }
      winners.clock(paths, stream.line, NoSettings(), FixedSize<semi_global::kWindowConfig<C>>());
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
   EXPECT_EQ(compared, kRows * kWidth);
}

TEST(PhaseWinners, GiveTheBestOfAllPhases) {
   for (const int bubbles : {0, 10, 70}) {
      expect_winners<kRight>(bubbles);
      expect_winners<kLeft>(bubbles);
      expect_winners<kRightTies>(bubbles);
      expect_winners<kLeftTies>(bubbles);
      expect_winners<kTwoLanes>(bubbles);
      expect_winners<kFullWidth>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
