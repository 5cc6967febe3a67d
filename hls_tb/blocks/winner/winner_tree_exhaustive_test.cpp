// SPDX-License-Identifier: Apache-2.0
// A tree of N candidates only compares them, so it finds the first smallest of all costs when it does for the costs
// 0 ... N-1 in every combination: they stand for every order with every tie.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "frontend/pixel_tag.hpp"
#include "winner/candidate.hpp"
#include "winner/gated_tree.hpp"
#include "winner/winner_tree.hpp"

namespace stereo::test {
namespace {

constexpr CandidateKind kPlain{.largest_cost = 65535};

template <int N, int kLevels, class Tree>
void expect_first_smallest_of_all_combinations(Tree tree) {
   std::array<int, N> digits{};
   long combinations = 0;
   for (bool more = true; more; ++combinations) {
      uint16_t costs[1][N];
      for (int i = 0; i < N; ++i) costs[0][i] = uint16_t(digits[std::size_t(i)]);
      for (int level = 0; level < kLevels; ++level) tree.clock(costs, {.valid = true});
      const auto smallest = std::min_element(digits.begin(), digits.end());
      ASSERT_EQ(tree.root().best.index[0][0], smallest - digits.begin()) << "combination " << combinations;
      ASSERT_EQ(tree.root().best.cost[0][0], *smallest) << "combination " << combinations;
      more = false;  // the next number of N digits in base N
      for (int& digit : digits) {
         if (++digit < N) {
            more = true;
            break;
         }
         digit = 0;
      }
   }
   long all = 1;
   for (int i = 0; i < N; ++i) all *= N;
   ASSERT_EQ(combinations, all);
}

template <int N, int Group>
void expect_first_smallest_of_all_combinations() {
   constexpr int kLevels = winner_levels(N, Group);
   expect_first_smallest_of_all_combinations<N, kLevels>(
       WinnerTree<Candidate<kPlain>, PixelTag, 1, Group, N, kLevels>());
}

template <int N>
void expect_gated_first_smallest_of_all_combinations() {
   constexpr int kClocks = gated_clocks(N);
   expect_first_smallest_of_all_combinations<N, kClocks>(GatedTree<Candidate<kPlain>, PixelTag, 1, N, kClocks>());
}

TEST(WinnerTreeExhaustive, TwoCandidates) { expect_first_smallest_of_all_combinations<2, 2>(); }
TEST(WinnerTreeExhaustive, ThreeCandidates) { expect_first_smallest_of_all_combinations<3, 2>(); }
TEST(WinnerTreeExhaustive, FourCandidates) { expect_first_smallest_of_all_combinations<4, 2>(); }
TEST(WinnerTreeExhaustive, FiveCandidates) { expect_first_smallest_of_all_combinations<5, 2>(); }
TEST(WinnerTreeExhaustive, FiveCandidatesInThrees) { expect_first_smallest_of_all_combinations<5, 3>(); }
TEST(WinnerTreeExhaustive, SixCandidatesInThrees) { expect_first_smallest_of_all_combinations<6, 3>(); }
TEST(WinnerTreeExhaustive, SevenCandidates) { expect_first_smallest_of_all_combinations<7, 2>(); }
TEST(WinnerTreeExhaustive, SevenCandidatesInFours) { expect_first_smallest_of_all_combinations<7, 4>(); }
TEST(GatedTreeExhaustive, ThreeCandidates) { expect_gated_first_smallest_of_all_combinations<3>(); }
TEST(GatedTreeExhaustive, FourCandidates) { expect_gated_first_smallest_of_all_combinations<4>(); }
TEST(GatedTreeExhaustive, FiveCandidates) { expect_gated_first_smallest_of_all_combinations<5>(); }
TEST(GatedTreeExhaustive, SevenCandidates) { expect_gated_first_smallest_of_all_combinations<7>(); }

}  // namespace
}  // namespace stereo::test
