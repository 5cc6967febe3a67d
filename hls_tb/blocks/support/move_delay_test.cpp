// SPDX-License-Identifier: Apache-2.0
#include "support/move_delay.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int LaneBits, int Lanes, int Moves>
void expect_delay() {
   using Delay = MoveDelay<LaneBits, Lanes, Moves>;
   using Record = std::array<int, Lanes>;
   Random random(test_seed());
   HeapMemories memories;
   Delay delay(memories, MemoryId<0>());
   std::deque<Record> inside(Moves - 1, Record{});
   Record shown{};
   for (int i = 0; i < 300; ++i) {
      typename Delay::Lane lanes[Lanes];
      Record record;
      for (std::size_t lane = 0; lane < Lanes; ++lane)
         record[lane] = lanes[lane] = typename Delay::Lane(random.below(1 << LaneBits));
      const bool move = random.percent(60);
      delay.clock(lanes, move);
      if (move) {
         inside.push_back(record);
         shown = inside.front();
         inside.pop_front();
      }
      for (int lane = 0; lane < Lanes; ++lane)
         ASSERT_EQ(delay.lane(lane), shown[std::size_t(lane)]) << Moves << " moves, clock " << i << ", lane " << lane;
   }
}

TEST(MoveDelay, ShowsWhatCameSoManyMovesAgo) {
   expect_delay<4, 12, 2>();
   expect_delay<6, 7, 5>();
   expect_delay<7, 64, 8>();
   expect_delay<12, 3, 9>();
}

}  // namespace
}  // namespace stereo::test
