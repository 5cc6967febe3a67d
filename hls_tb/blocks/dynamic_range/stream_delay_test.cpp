// SPDX-License-Identifier: Apache-2.0
#include "dynamic_range/stream_delay.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int kGroups>
void expect_delay() {
   using Delay = dynamic_range::StreamDelay<16, kGroups>;
   Random random(test_seed());
   HeapMemories memories;
   // The second one begins on the memories of the first, as after a reset: what they hold must not come out again.
   for (int run = 0; run < 2; ++run) {
      Delay delay(memories, MemoryId<0>());
      std::vector<std::pair<uint16_t, bool>> sent;
      std::deque<bool> valids(Delay::kClocks - 1, false);
      int shown = 0;
      for (int clock = 0; clock < 4 * kGroups + 100; ++clock) {
         const bool valid = random.percent(60), starts = random.percent(40);
         const uint16_t data = uint16_t(random.bits());
         delay.clock(data, starts, valid);
         if (valid) sent.emplace_back(data, starts);
         valids.push_back(valid);
         ASSERT_EQ(delay.valid(), valids.front());
         const bool shows = valids.front();
         valids.pop_front();
         if (!shows) continue;
         ++shown;
         if (shown <= kGroups) {
            ASSERT_FALSE(delay.start_of_frame()) << "run " << run << ", group " << shown;
            continue;
         }
         const auto& [old_data, old_start] = sent[std::size_t(shown - 1 - kGroups)];
         ASSERT_EQ(delay.data(), old_data);
         ASSERT_EQ(delay.start_of_frame(), old_start);
      }
   }
}

TEST(StreamDelay, ShowsTheGroupOfSoManyGroupsAgo) {
   expect_delay<9>();
   static_assert(dynamic_range::StreamDelay<16, 7000>::kClocks == 3);
   expect_delay<7000>();
}

}  // namespace
}  // namespace stereo::test
