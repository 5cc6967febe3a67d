// SPDX-License-Identifier: Apache-2.0
#include "winner/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "block_matching/config.hpp"
#include "cost/costs.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"
#include "winner/candidate.hpp"
#include "winner/candidates.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/winners.hpp"

namespace stereo::test {
namespace {

/// Window costs up to 2^24 / 2^26: as large as they may get.
template <int Uniqueness, bool Subpixel, int P = 1, Cost Kind = Cost::ssd, int B = 16>
using RefinementConfig = Exactly<block_matching::Config{
    {.width_px = 300, .height_px = 32, .pixels_per_clock = P},
    {DisparityCount{256}, MatchingWindow{B}, Comparison{Kind}, UniquenessPercent{Uniqueness}, SubpixelSteps{Subpixel}},
    {}}>;

/// What the block reads of the last slice and of the texture block.
template <const block_matching::Config& C>
struct Before {
   Candidates<WindowCandidate<C>, C.pixels_per_clock, 1> best;
   PixelTag best_tag;
   bool texture[C.pixels_per_clock] = {};
   bool passed(int p) const { return texture[p]; }
};

struct Expected {
   PixelTag tag;
   bool passed = true;
   int disparity = -1;  ///< -1: without meaning
};

/// Feeds candidates to all lanes and compares what comes out.
template <const block_matching::Config& C>
struct RefinementBench {
   Random random{test_seed()};
   Refinement<C> block;
   WindowLosers<C> losers;  ///< of the candidate before
   std::deque<Expected> pipeline = std::deque<Expected>(block.kClocks > 0 ? std::size_t(block.kClocks) - 1 : 0);
   int passed = 0, failed = 0;

   void clock(const WindowCandidate<C>& candidate, bool passes, int disparity, WindowCost<C> second = 0) {
      Before<C> in;
      in.best_tag = random_tag(random);
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         in.best.late_cost[p][0] = losers.cost;
         in.best.second[p][0] = losers.second;
         in.best.set(p, 0, candidate);
      }
      losers = WindowLosers<C>::single(candidate.cost);
      losers.second = second;
      pipeline.push_back({in.best_tag, passes, disparity});
      block.clock(in, in);
      const Expected now = pipeline.front();
      pipeline.pop_front();
      const Winners<C> got = block.output(in, in);
      ASSERT_EQ(got.tag, now.tag);
      if (now.disparity < 0) return;
      (now.passed ? passed : failed) += 1;
      const MapGroup<C> map = map_group<C>(got);
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         ASSERT_EQ(got.passed[p], now.passed) << "lane " << p;
         ASSERT_EQ(int(map.disparity[p]), now.disparity) << "lane " << p;
      }
   }
   /// Everything that is on its way.
   void drain() {
      for (int i = 0; i < block.kClocks; ++i)
         if (!::testing::Test::HasFatalFailure()) clock(WindowCandidate<C>(), true, -1);
   }
};

template <class Config>
class UniquenessTest : public ::testing::Test {};
using UniquenessConfigs = ::testing::Types<RefinementConfig<1, false>, RefinementConfig<15, false, 4>,
                                           RefinementConfig<40, true>, RefinementConfig<100, false>>;
TYPED_TEST_SUITE(UniquenessTest, UniquenessConfigs, ConfigNames);

/// The other cost exactly at the limit S + floor(u S / 100), on both sides of it, anywhere, and missing.
TYPED_TEST(UniquenessTest, PassesAboveTheLimit) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   const int64_t most = C.largest_window_cost();
   RefinementBench<C> bench;
   const auto clock = [&bench](int64_t cost, int64_t second, bool passes) {
      if (::testing::Test::HasFatalFailure()) return;
      WindowCandidate<C> best = WindowCandidate<C>::single(WindowCost<C>(cost), 77);
      best.below = best.above = best.cost;
      SCOPED_TRACE("cost " + std::to_string(cost) + " second " + std::to_string(second) + " or some clocks before");
      bench.clock(best, passes, C.subpixel ? 16 * 77 : 77,
                  second >= 0 ? WindowCost<C>(second) : WindowLosers<C>::kNone);
   };
   const auto around = [&](int64_t cost) {
      const int64_t limit = cost + C.uniqueness_percent * cost / 100;
      for (const int64_t second : {limit - 1, limit, limit + 1})
         if (second >= cost && second <= most) clock(cost, second, second > limit);
   };
   for (int64_t cost = 0; cost < 3000; ++cost) around(cost);
   for (int i = 0; i < 20000; ++i) {
      around(bench.random.below(int(most) + 1));
      const int64_t cost = bench.random.below(int(most) + 1), second = cost + bench.random.below(int(most - cost) + 1);
      clock(cost, second, second > cost + C.uniqueness_percent * cost / 100);
      clock(cost, -1, true);
   }
   around(most);
   clock(most, -1, true);
   bench.drain();
   EXPECT_GT(bench.passed, 10000);
   EXPECT_GT(bench.failed, 10000);
}

/// docs/algorithm.md, 6., for whole numbers that C++ divides toward 0.
int naive_subpixel(int d, int64_t u, int64_t v) {
   const int64_t q = std::max(u, v) == 0 ? 0 : (u - v) * 128 / std::max(u, v);
   return int((256 * int64_t(d) + q + 15) >> 4);
}

template <class Config>
class SubpixelTest : public ::testing::Test {};
using SubpixelConfigs =
    ::testing::Types<RefinementConfig<0, true, 1, Cost::ssd, 31>, RefinementConfig<0, true, 2, Cost::sad, 3>>;
TYPED_TEST_SUITE(SubpixelTest, SubpixelConfigs, ConfigNames);

TYPED_TEST(SubpixelTest, IsTheFormula) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   const int most = C.largest_window_cost();
   RefinementBench<C> bench;
   const auto clock = [&bench](int d, int cost, int u, int v) {
      if (::testing::Test::HasFatalFailure()) return;
      WindowCandidate<C> best = WindowCandidate<C>::single(WindowCost<C>(cost), uint8_t(d));
      best.below = WindowCost<C>(cost + u);
      best.above = WindowCost<C>(cost + v);
      // At an end of the range the missing one is equal to the other, and what stands there has no meaning.
      const int real_u = d == 0 ? v : u, real_v = d == C.disparities - 1 ? u : v;
      SCOPED_TRACE("d=" + std::to_string(d) + " u=" + std::to_string(u) + " v=" + std::to_string(v) +
                   " or some clocks before");
      bench.clock(best, true, naive_subpixel(d, real_u, real_v));
   };
   const int reach = std::min(most, 260);
   for (int u = 0; u <= reach; ++u)
      for (int v = 0; v <= reach; ++v) clock(1 + bench.random.below(254), 0, u, v);
   for (int i = 0; i < 50000; ++i) {
      const int cost = bench.random.below(most + 1), rest = most - cost + 1;
      const int ends[] = {0, 1, 254, 255}, d = i % 5 == 4 ? bench.random.below(256) : ends[i % 5];
      const int v = bench.random.below(rest), u = bench.random.below(rest);
      clock(d, cost, u, v);
   }
   for (const int u : {0, 1, most - 1, most})
      for (const int v : {0, 1, most - 1, most}) clock(100, 0, u, v);
   bench.drain();
   EXPECT_GT(bench.passed, 50000);
}

TEST(Refinement, WithoutChecksPassesTheWinnerOnAtOnce) {
   static constexpr block_matching::Config C{{.width_px = 32, .height_px = 12}, {DisparityCount{8}}, {}};
   RefinementBench<C> bench;
   static_assert(Refinement<C>::kClocks == 0);
   for (int d = 0; d < 8; ++d) bench.clock(WindowCandidate<C>::single(WindowCost<C>(10 * d), uint8_t(d)), true, d);
}

/// The texture's result joins that of the uniqueness check.
template <const block_matching::Config& C>
void needs_texture_too() {
   Refinement<C> block;
   for (const bool texture : {true, false})
      for (const bool unique : {true, false}) {
         Before<C> in;
         in.best.set(0, 0, WindowCandidate<C>::single(10, 3));
         in.best.late_cost[0][0] = 10;
         in.best.second[0][0] = unique ? 1000 : 10;
         in.texture[0] = texture;
         for (int clock = 0; clock < std::max(1, block.kClocks); ++clock) {
            block.clock(in, in);
            in.texture[0] = block.kClocks > 0 ? !texture : texture;  // later ones belong to others
         }
         const bool unique_enough = unique || !C.has_uniqueness_check();
         EXPECT_EQ(block.output(in, in).passed[0], texture && unique_enough) << texture << unique;
      }
}

TEST(Refinement, PixelsWithoutTextureDoNotPass) {
   static constexpr block_matching::Config alone{
       {.width_px = 32, .height_px = 12},
       {DisparityCount{8}, Prefiltering{.prefilter = Prefilter::xsobel}, block_matching::TextureThreshold{10}},
       {}};
   static constexpr block_matching::Config with_uniqueness{
       {.width_px = 32, .height_px = 12},
       {DisparityCount{8}, Prefiltering{.prefilter = Prefilter::xsobel}, UniquenessPercent{20},
        block_matching::TextureThreshold{10}},
       {}};
   needs_texture_too<alone>();
   needs_texture_too<with_uniqueness>();
}

}  // namespace
}  // namespace stereo::test
