// SPDX-License-Identifier: Apache-2.0
#include "winner/candidate.hpp"

#include "block_matching/config.hpp"
#include "cost/costs.hpp"
#include "scene/random.hpp"
#include "testing/expect_candidate.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <Ties Rule, int Uniqueness, bool Subpixel>
using CandidateConfig = Exactly<block_matching::Config{
    {.width_px = 64, .height_px = 32},
    {DisparityCount{32}, MatchingWindow{16}, TieRule{Rule}, UniquenessPercent{Uniqueness}, SubpixelSteps{Subpixel}},
    {}}>;

template <class Config>
class CandidateTest : public ::testing::Test {};
using Configs = ::testing::Types<CandidateConfig<Ties::smallest, 0, false>, CandidateConfig<Ties::largest, 0, false>,
                                 CandidateConfig<Ties::smallest, 15, false>, CandidateConfig<Ties::largest, 15, false>,
                                 CandidateConfig<Ties::smallest, 0, true>, CandidateConfig<Ties::largest, 0, true>,
                                 CandidateConfig<Ties::smallest, 15, true>, CandidateConfig<Ties::largest, 15, true>>;
TYPED_TEST_SUITE(CandidateTest, Configs, ConfigNames);

template <const block_matching::Config& C>
struct Range {
   WindowCandidate<C> best;
   WindowLosers<C> losers;
};

/// The best of the disparities first ... end-1, joined in a random order.
template <const block_matching::Config& C>
Range<C> joined_at_random(const std::vector<int>& costs, int first, int end, Random& random) {
   if (end - first == 1) {
      const auto cost = WindowCost<C>(costs[std::size_t(first)]);
      return {WindowCandidate<C>::single(cost, uint8_t(first)), WindowLosers<C>::single(cost)};
   }
   const int split = first + 1 + random.below(end - first - 1);
   const Range<C> a = joined_at_random<C>(costs, first, split, random);
   const Range<C> b = joined_at_random<C>(costs, split, end, random);
   const bool upper = WindowCandidate<C>::wins(b.best.cost, a.best.cost);
   const Choice choice = Choice::chosen(upper, Choice::of(0, false, a.best.index == split - 1),
                                        Choice::of(1, b.best.index == split, false));
   return {WindowCandidate<C>::joined(a.best, split - 1, b.best, split),
           WindowLosers<C>::joined(a.losers.template left_by<0, 2>(choice), b.losers.template left_by<1, 2>(choice))};
}

TYPED_TEST(CandidateTest, JoinedRangesKnowWhatTheWholeRangeShows) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   Random random(test_seed());
   const auto check = [&random](const std::vector<int>& costs) {
      if (::testing::Test::HasFatalFailure()) return;
      SCOPED_TRACE(::testing::PrintToString(costs));
      const Range<C> range = joined_at_random<C>(costs, 0, int(costs.size()), random);
      expect_candidate<C>(NaiveWinner(costs, C.ties), range.best);
      expect_losers<C>(NaiveWinner(costs, C.ties), range.losers);
   };
   for (int order = 0; order < 5; ++order)
      for (const int count : {1, 2, 3, 4, 5}) for_all_costs(count, 4, check);
   for (int round = 0; round < 3000; ++round) {
      std::vector<int> costs(std::size_t(2 + random.below(31)));
      const int levels[] = {1, 2, 5, 30, 65281}, count = levels[random.below(5)];
      for (int& cost : costs) cost = C.largest_window_cost() - random.below(count);
      check(costs);
   }
}

}  // namespace
}  // namespace stereo::test
