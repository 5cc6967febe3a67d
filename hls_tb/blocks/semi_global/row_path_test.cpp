// SPDX-License-Identifier: Apache-2.0
#include "semi_global/row_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "definition/semi_global/reference_model.hpp"
#include "scene/random.hpp"
#include "support/move_fan.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using semi_global::RowDirection;
using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int cost_cap, int p1, int p2, int p2_least = -1, int left_right = -1) {
   return {{.width_px = 100, .height_px = 20},
           {DisparityCount{disparities}, CostScale{.cost_shift = 0, .cost_cap = cost_cap},
            semi_global::Paths{.p1 = p1, .p2 = p2, .p2_least = p2_least}, LeftRightThreshold{left_right}},
           {}};
}

// Every rest of D by 4, powers of two and their neighbours; penalties around the largest cost.
constexpr SgmConfig kD12 = config(12, 13, 5, 22), kD16 = config(16, 13, 0, 1), kD17 = config(17, 40, 7, 90);
constexpr SgmConfig kD19 = config(19, 3, 12, 50), kD14 = config(14, 100, 3, 300), kD64 = config(64, 15, 5, 24);
// P2 that falls: by little, to 0, by more than the bits beside it would need, with K as it is for the left/right check.
constexpr SgmConfig kFalls12 = config(12, 13, 5, 22, 20), kFalls16 = config(16, 3, 12, 50, 0);
constexpr SgmConfig kFalls17 = config(17, 5, 8, 60, 16), kFalls19 = config(19, 40, 7, 90, 63, 1);
constexpr SgmConfig kFalls64 = config(64, 7, 8, 60, 16, 1), kFalls9 = config(9, 1, 0, 1, 0);
constexpr SgmConfig kFalls8 = config(8, 7, 8, 60, 16);

/// A row path between two columns of one pixel pair of input.
struct Column {
   std::vector<int> costs;
   bool first;
   bool of_map;
   int relief = 0;  ///< by how much P2 falls on the way to it
};

/// Rows of `width` columns and what stands between them; every second row has costs that drive the path to its bounds.
std::vector<Column> random_columns(Random& random, const SgmConfig& c, int width, int rows) {
   std::vector<Column> columns;
   for (int y = 0; y < rows; ++y)
      for (int x = 0; x < width + 12; ++x) {
         Column column{{}, x == 0, x < width};
         // Edges stand far apart, in runs, or everywhere.
         if (c.has_relief() && random.percent(y % 3 == 0 ? 8 : y % 3 == 1 ? 40 : 90))
            column.relief = random.percent(50) ? c.largest_relief() : random.below(c.largest_relief() + 1);
         const int levels = y % 2 == 0 ? c.cost_cap + 1 : 2;
         for (int d = 0; d < c.disparities; ++d)
            column.costs.push_back(random.below(levels) * (levels == 2 ? c.cost_cap : 1));
         if (y % 3 == 2 && column.of_map) column.costs[std::size_t(5 + x / 9 % 3)] = 0;  // something to follow
         columns.push_back(column);
      }
   return columns;
}

template <const SgmConfig& C>
void expect_path(int bubbles_percent) {
   constexpr int kWidth = 60, kRows = 7;
   Random random(test_seed());
   const std::vector<Column> columns = random_columns(random, C, kWidth, kRows);
   CostVolume costs(kWidth, kRows, C.disparities);
   DeepImage relief(kWidth, kRows);
   std::vector<std::pair<int, int>> places;  // of the columns of the map
   for (std::size_t i = 0; i < columns.size(); ++i) {
      const int x = int(i) % (kWidth + 12), y = int(i) / (kWidth + 12);
      if (columns[i].of_map)
         for (int d = 0; d < C.disparities; ++d) costs.at(x, y, d) = columns[i].costs[std::size_t(d)];
      if (columns[i].of_map) relief.at(x, y) = uint16_t(columns[i].relief);
   }
   const CostVolume expected = row_path(costs, relief, RowDirection::from_left, C);

   semi_global::RowPath<C> path;
   constexpr int kMoves = semi_global::RowPath<C>::kMoves;
   int compared = 0;
   for (int moves = 0; moves < int(columns.size()) + kMoves;) {
      const bool move = !random.percent(bubbles_percent);
      const auto column = [&](int i) {
         Column none{std::vector<int>(std::size_t(C.disparities), 0), false, false};
         return i >= 0 && i < int(columns.size()) ? columns[std::size_t(i)] : none;
      };
      const Column now = column(moves), older = column(moves - 2);
      semi_global::PathCost<C> costs_in[C.disparities];
      for (int d = 0; d < C.disparities; ++d) costs_in[d] = semi_global::PathCost<C>(older.costs[std::size_t(d)]);
      const int smallest = *std::min_element(now.costs.begin(), now.costs.end());
      const auto next_relief = semi_global::Relief<C>(column(moves + 1).relief);
      path.clock(OneMove{move}, semi_global::PathCost<C>(smallest), now.first, costs_in, next_relief);
      if (!move) continue;
      ++moves;
      const int shown = moves - kMoves;
      if (shown < 0 || !column(shown).of_map) continue;
      const int x = shown % (kWidth + 12), y = shown / (kWidth + 12);
      for (int d = 0; d < C.disparities; ++d)
         ASSERT_EQ(int(path.cost[d]) - C.row_path_bias(), expected.at(x, y, d) + column(shown + 1).relief)
             << "x=" << x << " y=" << y << " d=" << d;
      if constexpr (C.takes_relief_off()) {
         ASSERT_EQ(int(path.relief.shown()), column(shown + 1).relief);
      }
      ++compared;
   }
   EXPECT_EQ(compared, kWidth * kRows);
}

TEST(RowPath, IsThatOfTheDefinition) {
   for (const int bubbles : {0, 40}) {
      expect_path<kD12>(bubbles);
      expect_path<kD14>(bubbles);
      expect_path<kD16>(bubbles);
      expect_path<kD17>(bubbles);
      expect_path<kD19>(bubbles);
      expect_path<kD64>(bubbles);
      expect_path<kFalls8>(bubbles);
      expect_path<kFalls9>(bubbles);
      expect_path<kFalls12>(bubbles);
      expect_path<kFalls16>(bubbles);
      expect_path<kFalls17>(bubbles);
      expect_path<kFalls19>(bubbles);
      expect_path<kFalls64>(bubbles);
   }
}

}  // namespace
}  // namespace stereo::test
