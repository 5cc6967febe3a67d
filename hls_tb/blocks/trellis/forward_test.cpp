// SPDX-License-Identifier: Apache-2.0
#include "trellis/forward.hpp"

#include <gtest/gtest.h>

#include "definition/trellis/reference_model.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using TrellisConfig = trellis::Config;

constexpr TrellisConfig config(int disparities, int cost_cap, int drop_cost, int occlusion_cost, int far_drop,
                               bool run_time_settings = false) {
   return {{.width_px = 100, .height_px = 20},
           {DisparityCount{disparities}, CostScale{.cost_shift = 0, .cost_cap = cost_cap},
            trellis::Drops{.drop_cost = drop_cost, .occlusion_cost = occlusion_cost, .far_drop = far_drop}},
           {RunTime{.run_time_settings = run_time_settings}}};
}

constexpr TrellisConfig kPlain = config(12, 13, 4, 7, 6), kFree = config(17, 40, 0, 1, 2),
                        kDear = config(19, 3, 200, 255, 3), kNear = config(14, 30, 3, 9, 14),
                        kSet = config(12, 13, 31, 100, 6, true);

trellis::Settings random_settings(Random& random, const TrellisConfig& largest) {
   trellis::Settings settings;
   settings.drop_cost = uint8_t(random.below(largest.drop_cost + 1));
   settings.occlusion_cost = uint8_t(1 + random.below(largest.occlusion_cost));
   return settings;
}

/// Rows one behind the other, with columns between them that belong to none. Where settings come from ports, each row
/// is a frame with its own.
template <const TrellisConfig& C>
void expect_rows(int bubbles_percent) {
   constexpr int kWidth = 60, kRows = 8, kBetween = 5, kMoves = trellis::Forward<C>::kMoves;
   Random random(test_seed());
   CostVolume costs(kWidth, kRows, C.disparities);
   // Rows of extremes drive the path costs to their bounds.
   for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kWidth; ++x)
         for (int d = 0; d < C.disparities; ++d)
            costs.at(x, y, d) = y % 2 == 0 ? random.below(C.cost_cap + 1) : random.percent(50) ? C.cost_cap : 0;
   trellis::Forward<C> forward;
   semi_global::PathEntry<trellis::kCostConfig<C>> entry;
   std::vector<trellis::Row> expected;
   std::vector<trellis::Settings> settings;
   for (int y = 0; y < kRows; ++y) {
      trellis::Matching matching = C;
      if (C.run_time_settings) {
         settings.push_back(random_settings(random, C));
         matching.drop_cost = settings.back().drop_cost;
         matching.occlusion_cost = settings.back().occlusion_cost;
      }
      expected.push_back(trellis::forward(costs, y, matching));
   }
   constexpr int kStride = kWidth + kBetween;
   int compared = 0;
   for (int moves = 0; moves < kRows * kStride + kMoves - 1;) {
      const int x = moves % kStride, y = moves / kStride;
      const bool move = !random.percent(bubbles_percent), inside = x < kWidth && y < kRows;
      entry.tag.valid = move;
      entry.moves_costs.clock(move);
      entry.tag.map_column = inside;
      entry.tag.first_column = move ? inside && x == 0 : random.percent(50);
      entry.tag.start_of_frame = entry.tag.first_column;
      for (int d = 0; d < C.disparities; ++d)
         entry.cost[d] = trellis::PathCost<C>(inside && move ? costs.at(x, y, d) : random.below(C.cost_cap + 1));
      // Those of another frame, but where its first column comes.
      trellis::Settings shown = random_settings(random, C);
      if (C.run_time_settings && inside && x == 0) shown = settings[std::size_t(y)];
      forward.clock(entry, shown);
      if (!move) continue;
      ++moves;
      const int newest = moves - kMoves, at = newest % kStride, row = newest / kStride;
      if (newest < 0 || at >= kWidth) continue;
      const trellis::Row& wanted = expected[std::size_t(row)];
      for (int d = 0; d < C.disparities; ++d) {
         const auto difference = [&](int from) {
            return wanted.path[std::size_t(at)][std::size_t(d)] - wanted.path[std::size_t(at)][std::size_t(from)];
         };
         ASSERT_EQ(int(forward.decision[d]), wanted.decision[std::size_t(at)][std::size_t(d)])
             << row << ' ' << at << ' ' << d;
         ASSERT_EQ(trellis::PathValue<C>(forward.path[d] - forward.path[0]) & trellis::Forward<C>::kMask,
                   trellis::PathValue<C>(difference(0)) & trellis::Forward<C>::kMask);
         ASSERT_LE(difference(0), C.largest_spread());
      }
      ++compared;
   }
   EXPECT_EQ(compared, kWidth * kRows);
}

TEST(TrellisForward, IsThatOfTheDefinition) {
   for (const int bubbles : {0, 40}) {
      expect_rows<kPlain>(bubbles);
      expect_rows<kFree>(bubbles);
      expect_rows<kDear>(bubbles);
      expect_rows<kNear>(bubbles);
      expect_rows<kSet>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
