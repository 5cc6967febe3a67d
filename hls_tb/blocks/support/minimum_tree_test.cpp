// SPDX-License-Identifier: Apache-2.0
#include "support/minimum_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int N>
void expect_smallest() {
   Random random(test_seed());
   MinimumTree<uint16_t, N> tree;
   std::deque<int> expected(std::size_t(tree.kLevels - 1), 0);
   int shown = 0;
   for (int i = 0; i < 400; ++i) {
      uint16_t values[N];
      for (uint16_t& value : values) value = uint16_t(random.percent(20) ? random.below(3) : random.below(65536));
      const bool move = random.percent(70);
      tree.clock(values, move);
      if (move) {
         expected.push_back(*std::min_element(values, values + N));
         shown = expected.front();
         expected.pop_front();
      }
      ASSERT_EQ(tree.root(), shown) << N << " numbers, clock " << i;
   }
}

TEST(MinimumTree, GivesTheSmallestALevelAMoveLater) {
   EXPECT_EQ((MinimumTree<uint8_t, 2>::kLevels), 1);
   EXPECT_EQ((MinimumTree<uint8_t, 64>::kLevels), 6);
   EXPECT_EQ((MinimumTree<uint8_t, 65>::kLevels), 7);
   expect_smallest<2>();
   expect_smallest<3>();
   expect_smallest<5>();
   expect_smallest<8>();
   expect_smallest<19>();
   expect_smallest<64>();
}

}  // namespace
}  // namespace stereo::test
