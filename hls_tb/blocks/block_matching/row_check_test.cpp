// SPDX-License-Identifier: Apache-2.0
#include "block_matching/row_check.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using block_matching::Config;

constexpr Config config(int width, int disparities, int min_disparity, int passes, Reference side, Ties ties,
                        int threshold) {
   return {{.width_px = width, .height_px = 12},
           {DisparityCount{disparities}, MatchingWindow{2}, SmallestDisparity{min_disparity}, ReferenceImage{side},
            TieRule{ties}, LeftRightThreshold{threshold}},
           {Folding{passes}}};
}

constexpr Config kRight = config(70, 12, 0, 2, Reference::right, Ties::smallest, 1),
                 kRightTies = config(60, 12, 0, 4, Reference::right, Ties::largest, 0),
                 kLeft = config(70, 12, 0, 3, Reference::left, Ties::smallest, 2),
                 kLeftTies = config(60, 30, 0, 5, Reference::left, Ties::largest, 0);
// The next pass asks for what the one before it has just written: Config::passes_are_apart.
constexpr Config kNarrow = config(34, 30, -8, 6, Reference::right, Ties::smallest, 0);
static_assert(kNarrow.pass_columns() - kNarrow.pass_disparities() == Config::kColumnsToOther);

/// What the block sees of the last slice.
template <const Config& C>
struct Slice {
   struct Window {
      PixelTag tag;
   } window;
   struct Other {
      static constexpr int kOldest = 0;
      WindowCost<C> cost[1][1];
      uint8_t winner[1][1];
   } other;
};

/// Costs of the columns of one row of the map for each disparity.
template <const Config& C>
struct MapRow {
   static constexpr int D = C.disparities, kMap = C.output_width_px(), kLanes = C.pass_disparities();
   std::vector<int> costs;

   explicit MapRow(Random& random) {
      for (int i = 0; i < kMap * D; ++i) costs.push_back(random.below(5));  // few: many ties
   }

   struct Best {
      int cost = -1, winner = -1;
   };
   /// docs/algorithm.md, 5.: of the other image's pixel, of the disparities from `first` on.
   Best best(int other, int first, int count) const {
      Best best;
      for (int d = first; d < first + count; ++d) {
         const int x = C.reference == Reference::right ? other - d : other + d;
         if (x < 0 || x >= kMap) continue;
         const int cost = costs[std::size_t(x * D + d)];
         if (best.winner < 0 || cost < best.cost || (cost == best.cost && C.ties == Ties::largest)) best = {cost, d};
      }
      return best;
   }
};

/// Rows whose passes follow one another as closely as they may. While a row is matched, the winners of the row before
/// it leave.
template <const Config& C>
void expect_checks() {
   using Row = MapRow<C>;
   using Rows = block_matching::TwoRows<C>;
   constexpr int F = C.clocks_per_pixel, kRows = 8;
   constexpr bool kIsRight = C.reference == Reference::right;
   Random random(test_seed());
   HeapMemories memories, unused;
   block_matching::RowWinners<C> winners(unused, MemoryId<0>());
   block_matching::RowCheck<C> check(memories, MemoryId<0>());
   Slice<C> slice;
   std::vector<Row> rows;
   for (int y = 0; y < kRows; ++y) rows.emplace_back(random);
   struct Answer {
      bool valid = false, passed = false;
   };
   std::deque<Answer> expected = std::deque<Answer>(2);
   int compared = 0, consistent = 0;
   typename Row::Best shown;  // with the tag of the last clock
   for (int y = 0; y <= kRows; ++y)
      for (int at = 0, asked = 0; at < C.width_px * F; ++at) {
         // The other image's pixels come a clock behind their column's tag.
         slice.other.cost[0][0] = WindowCost<C>(shown.winner < 0 ? random.below(5) : shown.cost);
         slice.other.winner[0][0] = uint8_t(shown.winner < 0 ? random.below(Row::kLanes) : shown.winner % Row::kLanes);
         const bool shows = y < kRows && at < C.passes_columns();
         const int pass = at / C.pass_columns() < F ? at / C.pass_columns() : F - 1;
         const int column = at - pass * C.pass_columns();
         slice.window.tag = PixelTag();
         slice.window.tag.valid = shows;
         slice.window.tag.first_column = column == 0;
         shown = {};
         if (shows) {
            const int first = pass * Row::kLanes;
            const int other = kIsRight ? column + first : column - (first + Row::kLanes - 1);
            shown = rows[std::size_t(y)].best(other, first, Row::kLanes);
         }
         Answer answer;
         winners.winners = Winners<C>();
         if (y > 0 && at % F == 0 && asked < Row::kMap) {
            const int x = asked++;
            const auto other_of = [&](int d) { return kIsRight ? x + d : x - d; };
            const auto other_winner = [&](int d) {
               return rows[std::size_t(y - 1)].best(other_of(d), 0, Row::D).winner;
            };
            int d = random.below(Row::D);
            for (int tries = 0; tries < 20 && std::abs(other_winner(d) - d) > C.left_right_threshold + 1; ++tries)
               d = random.below(Row::D);
            winners.winners.tag.valid = true;
            winners.winners.disparity[0] = uint8_t(d);
            winners.winners.passed[0] = random.percent(80);
            winners.address_out = Rows::address((y - 1) % 2 != 0, unsigned(x));
            const bool agrees = std::abs(other_winner(d) - d) <= C.left_right_threshold;
            answer = {true, winners.winners.passed[0] && agrees};
            consistent += agrees;
         }
         check.clock(slice, winners);
         expected.push_back(answer);
         const Answer now = expected.front();
         expected.pop_front();
         ASSERT_EQ(check.checked.tag.valid, now.valid);
         if (!now.valid) continue;
         ASSERT_EQ(check.checked.passed[0], now.passed) << "row " << y - 1 << ", the other image's winners differ";
         ++compared;
      }
   EXPECT_EQ(compared, kRows * Row::kMap);
   EXPECT_GT(consistent, compared / 4);
   EXPECT_LT(consistent, compared);
}

TEST(RowCheck, ComparesWithTheOtherImagesWinnersOfAllPasses) {
   expect_checks<kRight>();
   expect_checks<kRightTies>();
   expect_checks<kLeft>();
   expect_checks<kLeftTies>();
   expect_checks<kNarrow>();
}

}  // namespace
}  // namespace stereo::test
