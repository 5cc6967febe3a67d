// SPDX-License-Identifier: Apache-2.0
// The steps of the definition on cases small enough to work out by hand.
#include "definition/trellis/reference_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using trellis::Matching;

/// costs[x][d] of one row.
CostVolume row_of(const std::vector<std::vector<int>>& costs) {
   CostVolume volume(int(costs.size()), 1, int(costs[0].size()));
   for (int x = 0; x < volume.width; ++x)
      for (int d = 0; d < volume.disparities; ++d) volume.at(x, 0, d) = costs[std::size_t(x)][std::size_t(d)];
   return volume;
}

std::vector<int> disparities_of(const CostVolume& costs, const Matching& matching) {
   return trellis::traced_back(trellis::forward(costs, 0, matching), matching);
}

/// Costs that are 0 on the wanted disparity and `wrong` elsewhere; -1: as bad everywhere.
CostVolume costs_for(const std::vector<int>& wanted, int states, int wrong) {
   CostVolume costs(int(wanted.size()), 1, states);
   for (int x = 0; x < costs.width; ++x)
      for (int d = 0; d < states; ++d) costs.at(x, 0, d) = d == wanted[std::size_t(x)] ? 0 : wrong;
   return costs;
}

TEST(Trellis, ForwardPassByHand) {
   const Matching matching{DisparityCount{3}, trellis::Drops{.drop_cost = 1, .occlusion_cost = 4, .far_drop = 2}};
   const trellis::Row row = trellis::forward(row_of({{5, 0, 9}, {1, 9, 9}, {2, 9, 9}}), 0, matching);
   // E(0) = c. P(0) = {6, 1, 10}.
   EXPECT_EQ(row.path[0], (std::vector<int>{5, 0, 9}));
   // E(1,0) = min(5, 6) + 1, E(1,1) = min(0, 1) + 9, occluded 5 + 4; E(1,2) = occluded 0 + 4.
   EXPECT_EQ(row.path[1], (std::vector<int>{6, 9, 4}));
   EXPECT_EQ(row.decision[1], (std::vector<int>{0, 0, 3}));
   // P(1,0) = min(0 near, 9 far) + 1 + 1 = 2, P(1,1) = min(9, 9) + 1 + 9: E(2,0) = min(6, 2) + 2 by a near drop.
   EXPECT_EQ(row.path[2], (std::vector<int>{4, 10, 13}));
   EXPECT_EQ(row.decision[2], (std::vector<int>{1, 3, 0}));
   // Column 2 shows 0 and says that the drop was one column before, which shows 0 too and comes from 1.
   EXPECT_EQ(trellis::traced_back(row, matching), (std::vector<int>{1, 0, 0}));
}

TEST(Trellis, FindsAnObjectWithTheOcclusionOnItsLeft) {
   const Matching matching{DisparityCount{12}, trellis::Drops{.drop_cost = 2, .occlusion_cost = 5, .far_drop = 6}};
   // Background 2, an object of 8: six pixels of the background are hidden to its left; it ends with a far drop.
   std::vector<int> wanted{2, 2, 2, 2, -1, -1, -1, -1, -1, -1, 8, 8, 8, 8, 8, 8, 2, 2, 2, 2, 2};
   const std::vector<int> found = disparities_of(costs_for(wanted, 12, 13), matching);
   for (int& disparity : wanted) disparity = disparity == -1 ? trellis::kNoPartner : disparity;
   EXPECT_EQ(found, wanted);
   const std::vector<int> shown = trellis::filled(found);
   EXPECT_EQ(std::vector<int>(shown.begin() + 4, shown.begin() + 10), std::vector<int>(6, 2)) << "the background";
}

TEST(Trellis, FillsFromTheLeft) {
   constexpr int kNone = trellis::kNoPartner;
   EXPECT_EQ(trellis::filled({kNone, kNone, 5, kNone, 3, kNone}), (std::vector<int>{0, 0, 5, 5, 3, 3}));
}

/// The cost of a path that shows these disparities, -1 for occluded, by the words of the definition: the smallest over
/// the ways to read drops into it is what the forward pass finds.
int cheapest(const CostVolume& costs, const Matching& matching) {
   const int states = costs.disparities, width = costs.width;
   // Every path is tried, column after column. falling: the column before has just dropped, and must show its state
   // again.
   const std::function<int(int, int)> from = [&](int x, int d) {
      if (x == width - 1) return 0;
      int best = from(x + 1, d) + costs.at(x + 1, 0, d);
      if (d + 1 < states) best = std::min(best, from(x + 1, d + 1) + matching.occlusion_cost);
      if (x + 2 < width)
         for (const int drop : {1, matching.far_drop})
            if (d - drop >= 0) {
               const int cost = matching.drop_cost + costs.at(x + 1, 0, d - drop) + costs.at(x + 2, 0, d - drop);
               best = std::min(best, from(x + 2, d - drop) + cost);
            }
      return best;
   };
   int best = std::numeric_limits<int>::max();
   for (int d = 0; d < states; ++d) best = std::min(best, costs.at(0, 0, d) + from(0, d));
   // The first column may be dropped to as well: it then costs a drop for nothing, which never pays.
   return best;
}

TEST(Trellis, NoPathIsCheaper) {
   Random random(test_seed());
   for (int i = 0; i < 300; ++i) {
      const Matching matching{DisparityCount{2 + random.below(5)}, trellis::Drops{.drop_cost = random.below(6),
                                                                                  .occlusion_cost = 1 + random.below(6),
                                                                                  .far_drop = 2 + random.below(3)}};
      CostVolume costs(1 + random.below(7), 1, matching.disparities);
      for (int& value : costs.values) value = random.below(10);
      const std::vector<int> last = trellis::forward(costs, 0, matching).path.back();
      ASSERT_EQ(*std::min_element(last.begin(), last.end()), cheapest(costs, matching)) << i;
   }
}

}  // namespace
}  // namespace stereo::test
