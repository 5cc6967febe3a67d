// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <deque>

#include "block_matching/config.hpp"
#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/expect_candidate.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/types.hpp"
#include "winner/gated_tree.hpp"

namespace stereo::test {
namespace {

enum class Extras { none, second, neighbours, both };

/// `Spare`: levels beyond those that the tree of `Largest` candidates needs, with which this one keeps step. MayGate:
/// losers are cleared where that is possible.
template <int Pixels, int N, int Group, int Spare = 0, Ties Rule = Ties::smallest, Extras Needs = Extras::none,
          bool MayGate = true, int Largest = N>
struct TreeType {
   static constexpr block_matching::Config kConfig{
       {.width_px = 64, .height_px = 32, .pixels_per_clock = Pixels},
       {DisparityCount{32}, MatchingWindow{16}, TieRule{Rule},
        UniquenessPercent{Needs == Extras::second || Needs == Extras::both ? 5 : 0},
        SubpixelSteps{Needs == Extras::neighbours || Needs == Extras::both}},
       {WinnerGroup{Group}}};
   static constexpr int kCandidates = N;
   static constexpr bool kGated = MayGate && can_be_gated<WindowCandidate<kConfig>>(Largest, Group);
   static constexpr int kLevels = winner_clocks(kGated, Largest, Group) + Spare;
   using Tree = WinnerBlock<kGated, WindowCandidate<kConfig>, PixelTag, Pixels, Group, N, kLevels>;
};

template <class Tree>
class WinnerTreeTest : public ::testing::Test {};
using Few = ::testing::Types<TreeType<1, 3, 2>, TreeType<2, 4, 2, 2>, TreeType<1, 9, 2, 0, Ties::largest>,
                             TreeType<4, 5, 2, 2, Ties::smallest, Extras::both>,
                             TreeType<1, 26, 3, 0, Ties::largest, Extras::both>,
                             TreeType<2, 5, 2, 0, Ties::largest, Extras::none, false>,
                             TreeType<1, 7, 2, 0, Ties::largest, Extras::none, true, 16>>;
using More = ::testing::Types<
    TreeType<1, 2, 2>, TreeType<1, 6, 2, 1>, TreeType<2, 2, 2, 3>, TreeType<4, 3, 2, 0, Ties::largest>,
    TreeType<2, 3, 3, 1>, TreeType<1, 4, 4, 0, Ties::largest>, TreeType<4, 5, 4>, TreeType<2, 17, 16>,
    TreeType<2, 25, 2, 0, Ties::largest>, TreeType<4, 25, 2, 0, Ties::largest>, TreeType<1, 26, 3>, TreeType<1, 37, 7>,
    TreeType<1, 255, 16, 0, Ties::largest>, TreeType<1, 256, 2>, TreeType<1, 2, 2, 1, Ties::smallest, Extras::both>,
    TreeType<2, 3, 2, 0, Ties::largest, Extras::both>, TreeType<1, 4, 2, 0, Ties::smallest, Extras::second>,
    TreeType<1, 5, 3, 0, Ties::largest, Extras::neighbours>, TreeType<1, 37, 16, 0, Ties::smallest, Extras::both>,
    // losers are not cleared, although they could be
    TreeType<1, 3, 2, 1, Ties::smallest, Extras::none, false>,
    TreeType<4, 25, 2, 0, Ties::smallest, Extras::none, false>,
    TreeType<1, 256, 2, 0, Ties::largest, Extras::none, false>,
    // in step with a larger tree
    TreeType<1, 2, 2, 0, Ties::smallest, Extras::none, true, 12>,
    TreeType<1, 16, 2, 0, Ties::largest, Extras::none, false, 17>>;
using Trees = FewOrAll<Few, More>;
TYPED_TEST_SUITE(WinnerTreeTest, Trees);

/// Feeds a tree and compares its root.
template <class Type, const block_matching::Config& C = Type::kConfig>
struct TreeBench {
   static constexpr int P = C.pixels_per_clock, N = Type::kCandidates;
   struct Step {
      PixelTag tag;
      std::array<NaiveWinner, P> winners;
   };

   Random random{test_seed()};
   typename Type::Tree tree;
   std::deque<Step> pipeline = std::deque<Step>(Type::kLevels - 1);  // the winners on their way
   Step before{};                                                    // whose losers are shown
   int compared = 0;

   /// costs: of lane 0; each further lane has them turned by one disparity.
   void clock(std::vector<int> costs) {
      Step step{random_tag(random), {}};
      WindowCost<C> shown[P][N];
      for (int p = 0; p < P; ++p) {
         for (int d = 0; d < N; ++d) shown[p][d] = WindowCost<C>(costs[std::size_t(d)]);
         step.winners[std::size_t(p)] = NaiveWinner(costs, C.ties);
         std::rotate(costs.begin(), costs.begin() + 1, costs.end());
      }
      tree.clock(shown, step.tag);
      pipeline.push_back(step);
      const Step expected = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(tree.root().tag, expected.tag);
      for (int p = 0; p < P && before.tag.valid; ++p)
         ASSERT_NO_FATAL_FAILURE(expect_losers<C>(before.winners[std::size_t(p)], tree.root().best.losers(p, 0)))
             << "lane " << p;
      before = expected;
      if (!expected.tag.valid) return;
      ++compared;
      for (int p = 0; p < P; ++p)
         ASSERT_NO_FATAL_FAILURE(expect_candidate<C>(expected.winners[std::size_t(p)], tree.root().best.get(p, 0)))
             << "lane " << p;
   }
};

TYPED_TEST(WinnerTreeTest, FindsTheWinnerAndWhatTheChecksNeed) {
   constexpr int N = TypeParam::kCandidates;
   TreeBench<TypeParam> bench;
   if (N <= 5)
      for_all_costs(N, 4, [&bench](const std::vector<int>& costs) {
         if (!::testing::Test::HasFatalFailure()) bench.clock(costs);
      });
   for (int clock = 0; clock < 1000 && !::testing::Test::HasFatalFailure(); ++clock) {
      const int levels[] = {1, 2, 3, 10, 65281}, count = levels[bench.random.below(5)];  // 1: all tie
      std::vector<int> costs(N);
      for (int& cost : costs) cost = TypeParam::kConfig.largest_window_cost() - bench.random.below(count);
      bench.clock(costs);
   }
   EXPECT_GT(bench.compared, 500);
}

TYPED_TEST(WinnerTreeTest, HasAsManyLevelsAsNeeded) {
   constexpr int kGroup = TypeParam::kConfig.winner_group;
   int levels = 0;
   for (int64_t reach = 1; reach < TypeParam::kCandidates; reach *= kGroup) ++levels;
   EXPECT_EQ(winner_levels(TypeParam::kCandidates, kGroup), levels);
}

}  // namespace
}  // namespace stereo::test
