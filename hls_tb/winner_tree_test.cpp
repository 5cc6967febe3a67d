// SPDX-License-Identifier: Apache-2.0
#include "winner_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "models/random.hpp"
#include "support/seed.hpp"

namespace stereo::test {
namespace {

template <int N, int Group>
struct TreeType {
   static constexpr int kCandidates = N;
   static constexpr int kGroup = Group;
};

template <class Tree>
class WinnerTreeTest : public ::testing::Test {};
using Trees = ::testing::Types<TreeType<2, 2>, TreeType<2, 16>, TreeType<3, 2>, TreeType<4, 4>, TreeType<5, 4>,
                               TreeType<8, 2>, TreeType<17, 16>, TreeType<37, 7>, TreeType<64, 4>, TreeType<100, 3>,
                               TreeType<100, 4>, TreeType<255, 16>, TreeType<256, 2>, TreeType<256, 4>>;
TYPED_TEST_SUITE(WinnerTreeTest, Trees);

TYPED_TEST(WinnerTreeTest, FindsTheFirstSmallest) {
   constexpr int N = TypeParam::kCandidates;
   using Tree = WinnerTree<N, TypeParam::kGroup>;
   Random random(test_seed());
   Tree tree;
   std::deque<int> pipeline;  // the winners on their way; -1 for a bubble
   for (int clock = 0; clock < 2000; ++clock) {
      uint16_t costs[N];
      const int levels[] = {1, 2, 3, 10, 65536};  // 1: all tie
      const int count = levels[random.below(5)];
      for (uint16_t& cost : costs) cost = uint16_t(65535 - random.below(count));
      PixelTag tag;
      tag.valid = !random.percent(25);
      pipeline.push_back(tag.valid ? int(std::min_element(costs, costs + N) - costs) : -1);
      tree.clock(costs, tag);
      if (int(pipeline.size()) < Tree::kLevels) continue;
      const int expected = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(tree.winner_tag().valid, expected >= 0) << "clock " << clock;
      if (expected < 0) continue;
      ASSERT_EQ(tree.winner(), expected) << "clock " << clock;
   }
}

TYPED_TEST(WinnerTreeTest, HasAsManyLevelsAsNeeded) {
   int levels = 0;
   for (int64_t reach = 1; reach < TypeParam::kCandidates; reach *= TypeParam::kGroup) ++levels;
   EXPECT_EQ((WinnerTree<TypeParam::kCandidates, TypeParam::kGroup>::kLevels), levels);
}

}  // namespace
}  // namespace stereo::test
