// SPDX-License-Identifier: Apache-2.0
#include "block_matching/row_best.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/expect_candidate.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// Shows candidates as the last slice of the lanes does: of a pass over some columns.
template <const block_matching::Config& C>
struct Slice {
   using Best = WindowCandidate<C>;
   using Others = WindowLosers<C>;

   Candidates<Best, 1, 1> best;
   PixelTag best_tag;
   Others losers;  ///< of the candidate that is shown: a clock later

   void show(const PixelTag& tag, const std::vector<int>& costs) {
      const NaiveWinner winner(costs, C.ties);
      const auto value = [](int cost) { return cost < 0 ? Best::Others::kNone : typename Best::Value(cost); };
      const auto least = [&](std::size_t from, std::size_t to) {
         return from < to ? *std::min_element(costs.begin() + long(from), costs.begin() + long(to)) : -1;
      };
      Best candidate;
      candidate.cost = value(winner.cost);
      candidate.index = uint8_t(winner.index);
      candidate.below = value(winner.below);
      candidate.above = value(winner.above);
      candidate.first = value(costs.front());
      candidate.last = value(costs.back());
      if constexpr (Best::kHasSecond) best.set_losers(0, 0, losers);
      best.set(0, 0, candidate);
      losers.second = value(winner.second);
      losers.but_first = value(least(1, costs.size()));
      losers.but_last = value(least(0, costs.size() - 1));
      best_tag = tag;
   }
};

template <Ties Rule, int Uniqueness, bool Subpixel, int Passes, int Width = 60, int Window = 3>
struct Type {
   static constexpr block_matching::Config kConfig{{.width_px = Width, .height_px = 12},
                                                   {DisparityCount{12}, MatchingWindow{Window}, TieRule{Rule},
                                                    UniquenessPercent{Uniqueness}, SubpixelSteps{Subpixel}},
                                                   {Folding{Passes}}};
};
// The next pass asks for what the one before it has just written: Config::passes_are_apart.
using Narrow = Type<Ties::smallest, 5, true, 6, 15, 2>;
static_assert(Narrow::kConfig.pass_columns() == block_matching::Config::kColumnsToBest);

template <class Type>
class RowBestTest : public ::testing::Test {};
using Types = ::testing::Types<Type<Ties::smallest, 0, false, 2>, Type<Ties::largest, 0, true, 3>,
                               Type<Ties::smallest, 5, true, 4>, Type<Ties::largest, 5, false, 6>, Narrow>;
TYPED_TEST_SUITE(RowBestTest, Types);

template <const block_matching::Config& C>
void expect_the_best_of_all_passes() {
   constexpr int kColumns = C.output_width_px(), kLanes = C.pass_disparities(), kRows = 3;
   Random random(test_seed());
   HeapMemories memories;
   block_matching::RowBest<C> row(memories, MemoryId<0>());
   Slice<C> slice;
   std::vector<NaiveWinner> expected;
   std::size_t compared = 0;
   std::optional<std::size_t> late;  // whose losers come in this clock
   const auto clock = [&](const PixelTag& tag, const std::vector<int>& costs) {
      row.clock(slice);
      slice.show(tag, costs);
      if (late) expect_losers<C>(expected.at(*late), row.best.losers(0, 0));
      late.reset();
      if (!row.best_tag.valid || !row.best_tag.map_column) return;
      ASSERT_EQ(row.best_tag.first_column, compared % kColumns == 0);
      ASSERT_EQ(row.best_tag.end_of_line, compared % kColumns == kColumns - 1);
      expect_candidate<C>(expected.at(compared), row.best.get(0, 0));
      late = compared++;
   };
   const auto bubbles = [&](int count) {
      for (int i = 0; i < count; ++i) {
         PixelTag tag;
         tag.valid = random.percent(50);  // a column beside the map
         clock(tag, std::vector<int>(kLanes, random.below(4)));
      }
   };
   for (int y = 0; y < kRows; ++y) {
      std::vector<std::vector<int>> costs(kColumns, std::vector<int>(C.disparities));
      for (std::vector<int>& of_column : costs) {
         for (int& cost : of_column) cost = random.below(4);  // few, so that they are often equal
         expected.emplace_back(of_column, C.ties);
      }
      for (int pass = 0; pass < C.clocks_per_pixel; ++pass) {
         bubbles(C.pass_columns() - kColumns + random.below(2));  // as close as they come, or one clock later
         for (int x = 0; x < kColumns; ++x) {
            PixelTag tag;
            tag.valid = tag.map_column = tag.output_column = true;
            tag.first_column = x == 0;
            tag.end_of_line = x == kColumns - 1;
            const auto first = costs[std::size_t(x)].begin() + pass * kLanes;
            clock(tag, std::vector<int>(first, first + kLanes));
         }
      }
   }
   bubbles(10);
   EXPECT_EQ(compared, std::size_t(kRows * kColumns));
}

TYPED_TEST(RowBestTest, GivesTheBestOfAllPassesWithTheLastOne) { expect_the_best_of_all_passes<TypeParam::kConfig>(); }

}  // namespace
}  // namespace stereo::test
