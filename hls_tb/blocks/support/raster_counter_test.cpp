// SPDX-License-Identifier: Apache-2.0
#include "support/raster_counter.hpp"

#include <gtest/gtest.h>

#include <string>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// Frames of any length, whole ones most often: behind one another, behind flush groups, and broken off.
template <int Width, int Groups, int Delay, bool Joins>
void expect_the_same_places(int least_clocks, int stall_percent) {
   RasterCounter<Width, Groups, Delay, Joins> expected;
   EarlyRasterCounter<Width, Groups, Delay, Joins> counter;
   Random random(test_seed());
   constexpr int kFrame = Width * Groups;
   int until_start = 3, rest = 0;
   for (int i = 0; i < 40 * kFrame * least_clocks; ++i) {
      const bool valid = rest == 0 && !random.percent(stall_percent);
      const bool starts = valid && until_start-- == 0;
      rest = valid ? least_clocks - 1 : rest > 0 ? rest - 1 : 0;
      if (starts) {
         const int lengths[] = {kFrame, kFrame, kFrame + Delay * Width, kFrame + 3 * Width + 1,
                                1 + random.below(kFrame)};
         until_start = lengths[random.below(5)] - 1;
      }
      const bool start_of_frame = valid ? starts : random.percent(50);
      expected.clock(valid, start_of_frame);
      counter.clock(valid, start_of_frame);
      ASSERT_EQ(counter.column, expected.column) << "clock " << i;
      ASSERT_EQ(counter.group, expected.group) << "clock " << i;
      ASSERT_EQ(counter.next_frame, expected.next_frame) << "clock " << i;
   }
}

TEST(EarlyRasterCounter, CountsAsTheOneThatComparesAtOnce) {
   for (const int least_clocks : {3, 4, 7}) {
      for (const int stall_percent : {0, 30}) {
         SCOPED_TRACE(std::to_string(least_clocks) + " clocks a group, " + std::to_string(stall_percent) + " % stalls");
         expect_the_same_places<9, 6, 2, true>(least_clocks, stall_percent);
         expect_the_same_places<9, 6, 2, false>(least_clocks, stall_percent);
         expect_the_same_places<8, 5, 1, true>(least_clocks, stall_percent);
         expect_the_same_places<10, 4, 0, true>(least_clocks, stall_percent);
         expect_the_same_places<2, 3, 1, true>(least_clocks, stall_percent);
      }
   }
}

/// From its first clock on: nothing in front of it waits after a reset.
TEST(EarlyRasterCounter, StartsAtOnce) {
   RasterCounter<5, 4, 1, true> expected;
   EarlyRasterCounter<5, 4, 1, true> counter;
   for (int i = 0; i < 60; ++i) {
      const bool valid = i % 3 == 0;
      expected.clock(valid, false);
      counter.clock(valid, false);
      ASSERT_EQ(counter.column, expected.column) << "clock " << i;
      ASSERT_EQ(counter.group, expected.group) << "clock " << i;
   }
}

}  // namespace
}  // namespace stereo::test
