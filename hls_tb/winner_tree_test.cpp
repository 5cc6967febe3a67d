// SPDX-License-Identifier: Apache-2.0
#include "winner_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>

#include "models/random.hpp"
#include "support/seed.hpp"

namespace stereo::test {
namespace {

/// `Spare`: levels beyond those that N candidates need.
template <int Pixels, int N, int Group, int Spare = 0>
struct TreeType {
   static constexpr int kPixels = Pixels;
   static constexpr int kCandidates = N;
   static constexpr int kGroup = Group;
   static constexpr int kLevels = winner_levels(N, Group) + Spare;
   using Tree = WinnerTree<Pixels, N, Group, kLevels>;
};

template <class Tree>
class WinnerTreeTest : public ::testing::Test {};
using Trees = ::testing::Types<TreeType<1, 2, 2>, TreeType<2, 2, 2, 3>, TreeType<1, 2, 16>, TreeType<4, 3, 2>,
                               TreeType<2, 3, 3, 1>, TreeType<1, 4, 4>, TreeType<4, 5, 4>, TreeType<1, 8, 2>,
                               TreeType<2, 17, 16>, TreeType<4, 25, 2>, TreeType<2, 25, 2, 2>, TreeType<1, 26, 3>,
                               TreeType<1, 37, 7>, TreeType<1, 64, 4>, TreeType<2, 100, 3>, TreeType<4, 100, 4, 2>,
                               TreeType<1, 255, 16>, TreeType<1, 256, 2>, TreeType<4, 256, 4>>;
TYPED_TEST_SUITE(WinnerTreeTest, Trees);

TYPED_TEST(WinnerTreeTest, FindsTheFirstSmallest) {
   constexpr int P = TypeParam::kPixels, N = TypeParam::kCandidates;
   struct Winner {
      PixelTag tag;
      std::array<int, P> index{}, cost{};
   };
   Random random(test_seed());
   typename TypeParam::Tree tree;
   std::deque<Winner> pipeline(TypeParam::kLevels - 1);  // the winners on their way
   for (int clock = 0; clock < 2000; ++clock) {
      uint16_t costs[P][N];
      Winner winner;
      winner.tag.valid = !random.percent(25);
      winner.tag.end_of_line = random.percent(50);
      for (int p = 0; p < P; ++p) {
         const int levels[] = {1, 2, 3, 10, 65536};  // 1: all tie
         const int count = levels[random.below(5)];
         for (uint16_t& cost : costs[p]) cost = uint16_t(65535 - random.below(count));
         const uint16_t* const smallest = std::min_element(costs[p], costs[p] + N);
         winner.index[std::size_t(p)] = int(smallest - costs[p]);
         winner.cost[std::size_t(p)] = *smallest;
      }
      tree.clock(costs, winner.tag);
      pipeline.push_back(winner);
      const Winner expected = pipeline.front();
      pipeline.pop_front();
      const auto& root = tree.root();
      ASSERT_EQ(root.tag.valid, expected.tag.valid) << "clock " << clock;
      ASSERT_EQ(root.tag.end_of_line, expected.tag.end_of_line) << "clock " << clock;
      if (!expected.tag.valid) continue;
      for (int p = 0; p < P; ++p) {
         ASSERT_EQ(root.index[p][0], expected.index[std::size_t(p)]) << "clock " << clock << " lane " << p;
         ASSERT_EQ(root.cost[p][0], expected.cost[std::size_t(p)]) << "clock " << clock << " lane " << p;
      }
   }
}

TYPED_TEST(WinnerTreeTest, HasAsManyLevelsAsNeeded) {
   int levels = 0;
   for (int64_t reach = 1; reach < TypeParam::kCandidates; reach *= TypeParam::kGroup) ++levels;
   EXPECT_EQ(winner_levels(TypeParam::kCandidates, TypeParam::kGroup), levels);
}

}  // namespace
}  // namespace stereo::test
