// SPDX-License-Identifier: Apache-2.0
#include "cost/sign_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "cost/column_cost.hpp"
#include "cost/disparity_shift.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <int B, int P>
using Remembering = Exactly<block_matching::Config{{.width_px = 8, .height_px = 12, .pixels_per_clock = P},
                                                   {DisparityCount{5}, MatchingWindow{B}},
                                                   {SliceSize{5}, block_matching::CostSteps{.sign_memory = true}}}>;

template <class Config>
class SignMemoryTest : public ::testing::Test {};
using Configs = ::testing::Types<Remembering<2, 1>, Remembering<3, 1>, Remembering<5, 1>, Remembering<3, 2>,
                                 Remembering<4, 2>, Remembering<3, 4>, Remembering<6, 4>>;
TYPED_TEST_SUITE(SignMemoryTest, Configs, ConfigNames);

/// Rows come group after group, with bubbles, as the line buffer and the shift show them: each row P taps higher than
/// with the group before. The narrowest image that is allowed leaves the fewest clocks between a write and its read.
TYPED_TEST(SignMemoryTest, SumsAreThoseOfTheAbsoluteDifferences) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int kCount = 5, kTaps = C.tap_rows(), P = C.pixels_per_clock, W = C.width_px, kGroups = 60;
   Random random(test_seed());
   struct Place {
      bool valid;
      int group, column;
   };
   std::vector<Place> places(2);  // the first pixels come when their column has
   for (int group = 0; group < kGroups; ++group)
      for (int column = 0; column < W; ++column) {
         while (group > kGroups / 2 && random.percent(30)) places.push_back({false, 0, random.below(W)});
         places.push_back({true, group, column});
      }
   const int rows = kGroups * P + kTaps;
   std::vector<uint8_t> reference(std::size_t(rows * W)), search(std::size_t(rows * W * kCount));
   for (uint8_t& pixel : reference) pixel = random.byte();
   for (uint8_t& pixel : search) pixel = random.byte();

   HeapMemories memories;
   RememberingSadColumn<C, kCount> cost(memories, MemoryId<0>());
   DisparityShift<C, kCount> shift;
   std::deque<std::vector<int>> pipeline(std::size_t(C.cost_clocks - 1));
   int compared = 0;
   for (std::size_t n = 0; n < places.size(); ++n) {
      const Place& place = places[n];
      const bool known = place.group * P >= kTaps - P;  // all rows have come in as newest ones
      std::vector<int> sums(place.valid && known ? P * kCount : 0);
      for (int t = 0; t < kTaps; ++t) {
         const std::size_t pixel = std::size_t((place.group * P + t) * W + place.column);
         shift.reference[t] = place.valid ? reference[pixel] : random.byte();
         for (int i = 0; i < kCount; ++i) {
            shift.search[t][i] = place.valid ? search[pixel * kCount + std::size_t(i)] : random.byte();
            for (int p = 0; p < P && !sums.empty(); ++p)
               if (t >= p && t < p + C.window_px)
                  sums[std::size_t(p * kCount + i)] += std::abs(shift.reference[t] - shift.search[t][i]);
         }
      }
      shift.tag = PixelTag{.valid = place.valid, .newest_inside = 15};
      cost.clock(shift, uint16_t(n + 2 < places.size() ? places[n + 2].column : 0));
      pipeline.push_back(sums);
      const std::vector<int> expected = pipeline.front();
      pipeline.pop_front();
      if (expected.empty()) continue;
      ++compared;
      for (int p = 0; p < P; ++p)
         for (int i = 0; i < kCount; ++i)
            ASSERT_EQ(cost.column[p][i], expected[std::size_t(p * kCount + i)])
                << "place " << n << " lane " << p << " i=" << i;
   }
   EXPECT_GT(compared, (kGroups - 6) * W);
}

}  // namespace
}  // namespace stereo::test
