// SPDX-License-Identifier: Apache-2.0
#include "rectification/bilinear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// Numbers of `Bits` bits, the extreme ones often. The weighted sum in doubles is exact.
template <int Bits, int WeightBits, int Shift>
void expect_weighted_sums() {
   Random random(test_seed());
   constexpr int kHigh = (1 << Bits) - 1, kUnit = 1 << WeightBits;
   rectification::Bilinear<Bits, WeightBits, Shift> block;
   std::deque<int> pipeline(block.kClocks - 1);
   for (int clock = 0; clock < 2000; ++clock) {
      int32_t taps[2][2];
      for (auto& row : taps)
         for (int32_t& tap : row) {
            tap = random.percent(30) ? (random.percent(50) ? 0 : kHigh) : random.below(kHigh + 1);
         }
      const int x = random.percent(20) ? kUnit - 1 : random.below(kUnit);
      const int y = random.percent(20) ? kUnit - 1 : random.below(kUnit);
      const double u = x / double(kUnit), v = y / double(kUnit);
      const double mean =
          (1 - v) * ((1 - u) * taps[0][0] + u * taps[0][1]) + v * ((1 - u) * taps[1][0] + u * taps[1][1]);
      pipeline.push_back(int(std::floor(mean * kUnit * kUnit / std::exp2(Shift) + 0.5)));
      block.clock(taps, uint8_t(x), uint8_t(y));
      if (clock >= block.kClocks - 1) {
         ASSERT_EQ(int(block.value()), pipeline.front()) << "clock " << clock;
      }
      pipeline.pop_front();
   }
}

TEST(Bilinear, IsTheWeightedSumRounded) {
   expect_weighted_sums<8, 5, 10>();
   expect_weighted_sums<8, 1, 2>();
   expect_weighted_sums<8, 8, 16>();
   expect_weighted_sums<16, 4, 9>();
   expect_weighted_sums<16, 6, 15>();
   expect_weighted_sums<8, 2, 0>();
   expect_weighted_sums<10, 5, 10>();
   expect_weighted_sums<12, 5, 10>();
   expect_weighted_sums<12, 1, 2>();
   expect_weighted_sums<12, 8, 16>();
}

}  // namespace
}  // namespace stereo::test
