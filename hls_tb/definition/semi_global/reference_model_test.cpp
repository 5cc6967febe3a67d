// SPDX-License-Identifier: Apache-2.0
#include "definition/semi_global/reference_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "definition/mirror.hpp"
#include "definition/semi_global/matching_input.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

using semi_global::Matching;
using semi_global::RowDirection;

/// One row of costs. [x][d]
CostVolume one_row(const std::vector<std::vector<int>>& columns) {
   CostVolume costs(int(columns.size()), 1, int(columns[0].size()));
   for (int x = 0; x < costs.width; ++x)
      for (int d = 0; d < costs.disparities; ++d) costs.at(x, 0, d) = columns[std::size_t(x)][std::size_t(d)];
   return costs;
}

CostVolume random_costs(int width, int height, int disparities, int largest, uint64_t seed) {
   Random random(seed);
   CostVolume costs(width, height, disparities);
   for (int& value : costs.values) value = random.below(largest + 1);
   return costs;
}

/// Reliefs of pictures without edges.
DeepImage flat(const CostVolume& costs) { return {costs.width, costs.height}; }

TEST(SemiGlobalReference, RowPathByHand) {
   // P1 = 2, P2 = 5, D = 3, so the fresh start looks back 6 columns, beyond this row.
   const CostVolume costs = one_row({{4, 0, 7}, {4, 1, 1}, {0, 6, 6}});
   const Matching matching{DisparityCount{3}, semi_global::Paths{.p1 = 2, .p2 = 5}};
   // Column 0: g = 0 + 5: K = -1 -5 2, A = 1 -3 4.
   // Column 1: g = 1: c - g = 3 0 0. Stay: min(0, K, A) = -1 -5 0. K = 2 -5 0. Step: -5 -1 -5: A = 0 1 -3.
   // Column 2: g = 0: c - g = 0 6 6. Stay: 0 -5 -3. K = 0 1 3.
   const CostVolume path = semi_global::row_path(costs, flat(costs), RowDirection::from_left, matching);
   EXPECT_EQ(path.values, (std::vector<int>{-1, -5, 2, 2, -5, 0, 0, 1, 3}));
}

TEST(SemiGlobalReference, TheFreshStartMakesUpForWhatTheBestPathHasLost) {
   // Disparity 0 costs nothing, disparity 1 more than any jump, but in column 2 it is the other way round.
   // D = 2, look back 5. P2 = 4: q(0) = 4, then 0 until column 5 sees column 0, whose best path stands at -4.
   const Matching matching{DisparityCount{2}, semi_global::Paths{.p1 = 100, .p2 = 4}};
   std::vector<std::vector<int>> columns(8, {0, 9});
   columns[2] = {3, 0};  // the best path loses 3 here
   const CostVolume path =
       semi_global::row_path(one_row(columns), flat(one_row(columns)), RowDirection::from_left, matching);
   std::vector<int> best;
   for (int x = 0; x < path.width; ++x) best.push_back(path.at(x, 0, 0));
   // Column 5: q = max(0, 4 - 4 - (0+0+0+0)) = 0. Column 6 sees column 1: -4: 0. Column 7 sees column 2: -1: q = 3.
   EXPECT_EQ(best, (std::vector<int>{-4, -4, -1, -1, -1, -1, -1, -4}));
}

TEST(SemiGlobalReference, P2FallsWithTheGreyDifferenceByHand) {
   // As RowPathByHand, but P2 falls by 3 on the way to column 1: f(1) = -3.
   const CostVolume costs = one_row({{4, 0, 7}, {4, 1, 1}, {0, 6, 6}});
   const Matching matching{DisparityCount{3}, semi_global::Paths{.p1 = 2, .p2 = 5, .p2_least = 2}};
   DeepImage relief = flat(costs);
   relief.at(1, 0) = 3;
   // Column 1: c - g = 3 0 0. Stay: min(-3, K, A) = -3 -5 -3. K = 0 -5 -3. Step: -5 -1 -5: A = 0 1 -3.
   // Column 2: c - g = 0 6 6. Stay: 0 -5 -3. K = 0 1 3.
   const CostVolume path = semi_global::row_path(costs, relief, RowDirection::from_left, matching);
   EXPECT_EQ(path.values, (std::vector<int>{-1, -5, 2, 0, -5, -3, 0, 1, 3}));
   // From the right, the same two columns are columns 1 and 0: the relief between them counts for column 0 of the map.
   relief = flat(costs);
   relief.at(2, 0) = 3;
   const CostVolume back = semi_global::row_path(costs, relief, RowDirection::from_right, matching);
   // Column 2: g = 5: K = -5 1 1, A = -3 3 3. Column 1: c - g = 3 0 0; stay: min(-3, K, A) = -5 -3 -3: K = -2 -3 -3.
   EXPECT_EQ((std::vector<int>(back.values.begin() + 3, back.values.end())), (std::vector<int>{-2, -3, -3, -5, 1, 1}));
}

TEST(SemiGlobalReference, AFreshStartKnowsTheReliefsThatItLooksBackOver) {
   // Disparity 0 costs nothing. D = 2, look back 5. Column 5 sees column 0, where the best path stands at -4, and the
   // relief of any column since then is no deeper: q = 0. In column 7 the best path of column 2 has lost 3, but the
   // fresh start of column 4 was cheaper by 2, so only 4 - 2 = 2 are left to rise by.
   std::vector<std::vector<int>> columns(8, {0, 9});
   columns[2] = {3, 0};
   const CostVolume costs = one_row(columns);
   const Matching matching{DisparityCount{2}, semi_global::Paths{.p1 = 100, .p2 = 4, .p2_least = 1}};
   DeepImage relief = flat(costs);
   relief.at(4, 0) = 2;
   const CostVolume path = semi_global::row_path(costs, relief, RowDirection::from_left, matching);
   std::vector<int> best;
   for (int x = 0; x < path.width; ++x) best.push_back(path.at(x, 0, 0));
   EXPECT_EQ(best, (std::vector<int>{-4, -4, -1, -1, -2, -2, -2, -4}));
}

TEST(SemiGlobalReference, ReliefsAreHalvesOfTheGreyDifferenceUpToTheFallOfP2) {
   GrayImage image(6, 1);
   image.pixels = {10, 13, 13, 255, 250, 100};
   const Matching all{DisparityCount{2}, semi_global::Paths{.p2 = 60, .p2_least = 20}};
   // The map has the columns 0 ... 4, and no relief in its first one.
   EXPECT_EQ(reliefs(image, all).pixels, (std::vector<uint16_t>{0, 1, 0, 40, 2}));
   const Matching deep{DisparityCount{2}, PixelFormat{12}, semi_global::Paths{.p2 = 60, .p2_least = 20}};
   EXPECT_EQ(reliefs(image, deep).pixels, (std::vector<uint16_t>{0, 0, 0, 7, 0}));
   const Matching none{DisparityCount{2}, semi_global::Paths{.p2 = 60, .p2_least = 60}};
   EXPECT_EQ(reliefs(image, none).pixels, (std::vector<uint16_t>{0, 0, 0, 0, 0}));
}

TEST(SemiGlobalReference, ThePathFromAboveHasPenaltiesOfItsOwn) {
   const CostVolume costs = random_costs(4, 12, 7, 15, test_seed());
   const Matching rows{DisparityCount{7}, semi_global::Paths{.p1 = 3, .p2 = 11}};
   const Matching own{DisparityCount{7}, semi_global::Paths{.p1 = 30, .p2 = 90, .above_p1 = 3, .above_p2 = 11}};
   EXPECT_EQ(path_from_above(costs, own).values, path_from_above(costs, rows).values);
   EXPECT_EQ(row_path(costs, flat(costs), RowDirection::from_left, own).values,
             row_path(costs, flat(costs), RowDirection::from_left,
                      Matching{DisparityCount{7}, semi_global::Paths{.p1 = 30, .p2 = 90}})
                 .values);
}

TEST(SemiGlobalReference, PathFromAboveByHand) {
   CostVolume costs(1, 3, 3);
   costs.values = {4, 0, 7, 4, 1, 1, 0, 6, 6};
   const Matching matching{DisparityCount{3}, semi_global::Paths{.p1 = 2, .p2 = 5}};
   // Row 0: T = 5: K = 4 0 7; min(K, 5) = 4 0 5; T = 2 0 2. Row 1: 6 1 3: K = 5 0 2; T = 2 0 2.
   // Row 2: 2 6 8: K = 0 4 6.
   EXPECT_EQ(path_from_above(costs, matching).values, (std::vector<int>{4, 0, 7, 5, 0, 2, 0, 4, 6}));
}

/// The classical recurrence (Hirschmueller): L = c + min(L(d), L(d-1) + P1, L(d+1) + P1, min L + P2) - min L.
TEST(SemiGlobalReference, PathFromAboveIsTheClassicalOne) {
   const Matching matching{DisparityCount{7}, semi_global::Paths{.p1 = 3, .p2 = 11}};
   const CostVolume costs = random_costs(5, 20, 7, 15, test_seed());
   const CostVolume path = path_from_above(costs, matching);
   for (int x = 0; x < costs.width; ++x) {
      std::vector<int> above;
      for (int y = 0; y < costs.height; ++y) {
         std::vector<int> now;
         for (int d = 0; d < 7; ++d) {
            int arriving = 0;
            if (y > 0) {
               const int least = *std::min_element(above.begin(), above.end());
               arriving = std::min(above[std::size_t(d)], least + matching.p2);
               if (d > 0) arriving = std::min(arriving, above[std::size_t(d) - 1] + matching.p1);
               if (d < 6) arriving = std::min(arriving, above[std::size_t(d) + 1] + matching.p1);
               arriving -= least;
            }
            now.push_back(costs.at(x, y, d) + arriving);
         }
         const int least = *std::min_element(now.begin(), now.end());
         for (int d = 0; d < 7; ++d)
            ASSERT_EQ(path.at(x, y, d), now[std::size_t(d)] - least) << x << ' ' << y << ' ' << d;
         above = now;
      }
   }
}

TEST(SemiGlobalReference, TheRowPathsAreMirrorImages) {
   const Matching matching{DisparityCount{6}, semi_global::Paths{.p1 = 3, .p2 = 12}};
   const CostVolume costs = random_costs(40, 3, 6, 13, test_seed());
   CostVolume turned = costs;
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < 6; ++d) turned.at(costs.width - 1 - x, y, d) = costs.at(x, y, d);
   const CostVolume left = row_path(costs, flat(costs), RowDirection::from_left, matching);
   const CostVolume right = row_path(turned, flat(turned), RowDirection::from_right, matching);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < 6; ++d) ASSERT_EQ(left.at(x, y, d), right.at(costs.width - 1 - x, y, d));
}

TEST(SemiGlobalReference, RowPathsStayWithinTheirBounds) {
   Random random(test_seed());
   for (int i = 0; i < 60; ++i) {
      const int largest = 1 + random.below(30), disparities = 2 + random.below(20);
      Matching matching{DisparityCount{disparities},
                        semi_global::Paths{.p1 = random.below(20), .p2 = 1 + random.below(60)}};
      if (i % 3 != 0) matching.p2_least = random.below(matching.p2);
      CostVolume costs = random_costs(120, 1, disparities, largest, test_seed() + uint64_t(i));
      if (i % 2 == 0)
         for (int& value : costs.values) value = value > largest / 2 ? largest : 0;
      DeepImage relief = flat(costs);
      for (uint16_t& fall : relief.pixels)
         fall = uint16_t(random.percent(30) ? matching.largest_relief() : random.below(matching.largest_relief() + 1));
      const CostVolume path = row_path(costs, relief, RowDirection::from_left, matching);
      const auto [lowest, highest] = std::minmax_element(path.values.begin(), path.values.end());
      EXPECT_GE(*lowest, -(matching.p2 + std::max(0, largest - matching.p1)));
      EXPECT_LE(*highest, largest);
   }
}

TEST(SemiGlobalReference, SumsThePathsThatAreOn) {
   const CostVolume costs = random_costs(30, 8, 5, 13, test_seed());
   const Matching all{DisparityCount{5}};
   const CostVolume left = row_path(costs, flat(costs), RowDirection::from_left, all);
   const CostVolume right = row_path(costs, flat(costs), RowDirection::from_right, all);
   const CostVolume above = path_from_above(costs, all);
   for (int set = 1; set < 8; ++set) {
      Matching matching = all;
      matching.path_left = set & 1, matching.path_right = set & 2, matching.path_above = set & 4;
      const CostVolume sums = path_sums(costs, flat(costs), matching);
      for (std::size_t i = 0; i < sums.values.size(); ++i)
         ASSERT_EQ(sums.values[i],
                   (set & 1 ? left.values[i] : 0) + (set & 2 ? right.values[i] : 0) + (set & 4 ? above.values[i] : 0));
   }
}

TEST(SemiGlobalReference, ScalesAndCapsTheWindowCosts) {
   const ImagePair pair = random_pair(30, 12, test_seed());
   Matching matching{DisparityCount{6}, Comparison{Cost::sad}, CostScale{.cost_shift = 0}};
   const CostVolume plain = path_costs(pair.left, pair.right, matching);
   matching.cost_shift = 5;
   matching.cost_cap = 20;
   const CostVolume scaled = path_costs(pair.left, pair.right, matching);
   bool capped = false, smaller = false;
   for (std::size_t i = 0; i < plain.values.size(); ++i) {
      ASSERT_EQ(scaled.values[i], std::min(plain.values[i] / 32, 20));
      (plain.values[i] / 32 > 20 ? capped : smaller) = true;
   }
   EXPECT_TRUE(capped && smaller);
}

TEST(SemiGlobalReference, DistanceCheckLooksBeyondTheNeighbours) {
   CostVolume sums(4, 1, 4);
   sums.values = {5, 6, 9, 9, 5, 6, 8, 9, 5, 9, 9, 5, 5, 5, 9, 9};
   DisparityMap best(4, 1);
   EXPECT_EQ(distance_check(sums, best, 4).pixels, (std::vector<uint8_t>{1, 0, 0, 1}));
}

TEST(SemiGlobalReference, FindsAKnownShiftEverywhere) {
   const ImagePair pair = shifted_pair(48, 16, 5, test_seed());
   for (const Cost cost : {Cost::census, Cost::sad}) {
      const DisparityMap map = match_reference(
          pair.left, pair.right, Matching{DisparityCount{12}, Comparison{cost}, CostScale{.cost_shift = 4}});
      // The columns beside the border of the image have a census that sees beyond it.
      int found = 0;
      for (int y = 0; y < map.height; ++y)
         for (int x = 0; x < map.width; ++x) found += map.at(x, y) == 5 ? 1 : 0;
      EXPECT_EQ(found, map.width * map.height);
   }
}

TEST(SemiGlobalReference, ALeftReferenceIsTheMirrorImage) {
   const ImagePair pair = random_pair(40, 9, test_seed(), 8);
   const Matching matching{DisparityCount{9}, semi_global::Paths{.path_right = false}, LeftRightThreshold{1},
                           SubpixelSteps{true}};
   const DisparityMap map = match_reference(pair.left, pair.right, matching);
   const ImagePair turned = mirrored(pair);
   EXPECT_TRUE(same_map(mirrored(map), match_reference(turned.left, turned.right, semi_global::mirrored(matching))));
}

TEST(SemiGlobalInput, SaysWhatIsWrong) {
   const auto problem = [](const Matching& matching) { return std::string(matching.problem().text); };
   EXPECT_EQ(problem({}), "");
   EXPECT_EQ(problem({DisparityCount{1}}), "the disparity range is 1 but must be 2 ... 256");
   EXPECT_EQ(problem({semi_global::Paths{.p2 = 4096}}), "the penalty P2 is 4096 but must be 0 ... 4095");
   EXPECT_EQ(problem({CensusWindow{.census_width_px = 4}}), "the census window is 4x5 but both sides must be odd");
   EXPECT_EQ(problem({semi_global::Paths{.path_left = false, .path_right = false, .path_above = false}}),
             "at least one path must be on");
   EXPECT_THROW(match_reference(GrayImage(9, 9), GrayImage(9, 8), Matching{DisparityCount{4}}), std::invalid_argument);
   EXPECT_THROW(match_reference(GrayImage(9, 9), GrayImage(9, 9), Matching{DisparityCount{9}}), std::invalid_argument);
}

}  // namespace
}  // namespace stereo::test
