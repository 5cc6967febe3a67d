// SPDX-License-Identifier: Apache-2.0
#include "support/ring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

struct Record {
   uint16_t words[2];
};

/// After each clock `oldest` is the record taken in `Places` - 1 moves before the newest; bubbles carry rubbish.
template <int Places>
void expect_delay() {
   Random random(test_seed());
   HeapMemories memories;
   Ring<uint16_t, Places, 2> ring(memories, MemoryId<0>());
   std::deque<Record> taken(Places - 1, Record{{0, 0}});
   for (int clock = 0; clock < 20 * Places; ++clock) {
      const Record newest{{uint16_t(random.bits()), uint16_t(random.bits())}};
      const bool move = random.below(3) != 0;
      uint16_t oldest[2];
      ring.clock(newest.words, move, oldest);
      ASSERT_TRUE(std::equal(oldest, oldest + 2, taken.front().words)) << Places << " places, clock " << clock;
      if (!move) continue;
      taken.push_back(newest);
      taken.pop_front();
   }
}

TEST(Ring, ShowsTheRecordOfPlacesLessOneMovesBefore) {
   expect_delay<2>();
   expect_delay<3>();
   expect_delay<8>();
   expect_delay<100>();
}

}  // namespace
}  // namespace stereo::test
