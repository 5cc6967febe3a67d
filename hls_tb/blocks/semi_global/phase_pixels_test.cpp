// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_pixels.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(Cost cost, int census_width, int census_height) {
   return {{.width_px = 40, .height_px = 20},
           {DisparityCount{12}, MatchingWindow{1}, Comparison{cost},
            CensusWindow{.census_width_px = census_width, .census_height_px = census_height}},
           {Folding{4}}};
}

constexpr SgmConfig kSad = config(Cost::sad, 5, 5), kSsd = config(Cost::ssd, 5, 5);
constexpr SgmConfig kCensus3x3 = config(Cost::census, 3, 3), kCensus5x5 = config(Cost::census, 5, 5),
                    kCensus9x5 = config(Cost::census, 9, 5), kCensus9x7 = config(Cost::census, 9, 7);

template <const SgmConfig& C>
struct Shown {
   Feature<semi_global::kWindowConfig<C>> search[1][semi_global::PhasePixels<C>::kLanes], reference[1];
};

/// docs/algorithm.md, 2.
template <const SgmConfig& C>
int cost_of(uint64_t a, uint64_t b) {
   const int difference = std::abs(int(a) - int(b));
   return C.cost == Cost::census ? std::popcount(a ^ b) : C.cost == Cost::ssd ? difference * difference : difference;
}

template <const SgmConfig& C>
void expect_costs() {
   using Block = semi_global::PhasePixels<C>;
   using Word = Feature<semi_global::kWindowConfig<C>>;
   constexpr uint64_t kMask = (uint64_t(1) << semi_global::kWindowConfig<C>.feature_bits()) - 1;
   Random random(test_seed());
   HeapMemories memories;
   Block block(memories, MemoryId<0>());
   std::deque<std::vector<int>> expected;
   for (int clock = 0; clock < 3000; ++clock) {
      Shown<C> shift{};
      shift.reference[0] = Word(mix_bits(random.bits()) & kMask);
      std::vector<int> costs;
      for (Word& search : shift.search[0]) {
         // Also all bits and none of them.
         const uint64_t other = random.percent(10) ? ~uint64_t(shift.reference[0]) : mix_bits(random.bits());
         search = random.percent(10) ? shift.reference[0] : Word(other & kMask);
         costs.push_back(cost_of<C>(search, shift.reference[0]));
      }
      block.clock(shift);
      expected.push_back(costs);
      if (int(expected.size()) < Block::kClocks) continue;
      for (int l = 0; l < Block::kLanes; ++l)
         ASSERT_EQ(int(block.sum[0][l]), expected.front()[std::size_t(l)]) << "clock " << clock << " lane " << l;
      expected.pop_front();
   }
}

TEST(PhasePixels, CostsOfEachClock) {
   expect_costs<kSad>();
   expect_costs<kSsd>();
   expect_costs<kCensus3x3>();
   expect_costs<kCensus5x5>();
   expect_costs<kCensus9x5>();
   expect_costs<kCensus9x7>();
}

}  // namespace
}  // namespace stereo::test
