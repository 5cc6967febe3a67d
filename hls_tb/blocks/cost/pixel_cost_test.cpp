// SPDX-License-Identifier: Apache-2.0
#include "cost/pixel_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "cost/disparity_shift.hpp"
#include "cost/feature_distance.hpp"
#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

/// docs/algorithm.md, 2.
template <const block_matching::Config& C>
int naive_cost(uint64_t a, uint64_t b) {
   const int difference = std::abs(int(a) - int(b));
   return C.cost == Cost::census ? std::popcount(a ^ b) : C.cost == Cost::ssd ? difference * difference : difference;
}

template <Cost Kind, int P = 1, int CensusWidth = 5, int CensusHeight = 5, Prefilter Filter = Prefilter::none>
using CostConfig =
    Exactly<block_matching::Config{{.width_px = 16, .height_px = 8, .pixels_per_clock = P},
                                   {DisparityCount{4}, Comparison{Kind},
                                    CensusWindow{.census_width_px = CensusWidth, .census_height_px = CensusHeight},
                                    Prefiltering{.prefilter = Filter, .prefilter_cap = 63}},
                                   {}}>;

template <class Config>
class PixelCostTest : public ::testing::Test {};
using Configs = ::testing::Types<CostConfig<Cost::sad>, CostConfig<Cost::ssd>, CostConfig<Cost::ssd, 4>,
                                 CostConfig<Cost::ssd, 1, 5, 5, Prefilter::xsobel>, CostConfig<Cost::census>,
                                 CostConfig<Cost::census, 2, 3, 3>, CostConfig<Cost::census, 1, 9, 7>>;
TYPED_TEST_SUITE(PixelCostTest, Configs, ConfigNames);

TYPED_TEST(PixelCostTest, OfAllPairsOfGreyValues) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   using Distance = FeatureDistance<C, C.cost>;
   const int values = 1 << std::min(C.feature_bits(), 8);
   for (int a = 0; a < values; ++a)
      for (int b = 0; b < values; ++b)
         ASSERT_EQ(int(Distance::second(Distance::first(Feature<C>(a), Feature<C>(b)))),
                   naive_cost<C>(uint64_t(a), uint64_t(b)))
             << "a=" << a << " b=" << b;
}

TYPED_TEST(PixelCostTest, ComesWithItsTagTwoClocksLater) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kCount = 3, kTaps = C.tap_rows();
   constexpr uint64_t kMask = (uint64_t(1) << C.feature_bits()) - 1;
   struct Step {
      PixelTag tag;
      std::vector<int> costs = std::vector<int>(kTaps * kCount, 0);  ///< [t][i]
   };
   Random random(test_seed());
   DisparityShift<C, kCount> shift;
   PixelCost<C, kCount> pixels;
   std::deque<Step> pipeline(1);
   int largest = 0;
   for (int clock = 0; clock < 500; ++clock) {
      Step now;
      now.tag = shift.tag = random_tag(random);
      const bool extreme = random.percent(20);
      for (int t = 0; t < kTaps; ++t) {
         shift.reference[t] = Feature<C>(extreme ? 0 : mix_bits(random.bits()) & kMask);
         for (int i = 0; i < kCount; ++i) {
            shift.search[t][i] = Feature<C>(extreme ? kMask : mix_bits(random.bits()) & kMask);
            const int cost = naive_cost<C>(shift.search[t][i], shift.reference[t]);
            now.costs[std::size_t(t * kCount + i)] = cost;
            largest = std::max(largest, cost);
         }
      }
      pipeline.push_back(now);
      pixels.clock(shift);
      const Step expected = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(pixels.tag, expected.tag) << "clock " << clock;
      for (int t = 0; t < kTaps; ++t)
         for (int i = 0; i < kCount; ++i)
            ASSERT_EQ(pixels.cost[t][i], expected.costs[std::size_t(t * kCount + i)])
                << "clock " << clock << " t=" << t << " i=" << i;
   }
   EXPECT_GE(largest, C.largest_pixel_cost());
}

}  // namespace
}  // namespace stereo::test
