// SPDX-License-Identifier: Apache-2.0
#include "dynamic_range/stream_delay.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

constexpr int kGroups = 9;
using Delay = dynamic_range::StreamDelay<16, kGroups>;

TEST(StreamDelay, ShowsTheGroupOfSoManyGroupsAgo) {
   Random random(test_seed());
   HeapMemories memories;
   // The second one begins on the memories of the first, as after a reset: what they hold must not come out again.
   for (int run = 0; run < 2; ++run) {
      Delay delay(memories, MemoryId<0>());
      std::vector<std::pair<uint16_t, bool>> sent;
      for (int clock = 0; clock < 400; ++clock) {
         const bool valid = random.percent(60), starts = random.percent(40);
         const uint16_t data = uint16_t(random.bits());
         delay.clock(data, starts, valid);
         ASSERT_EQ(delay.valid, valid);
         if (!valid) continue;
         sent.emplace_back(data, starts);
         if (int(sent.size()) <= kGroups) {
            ASSERT_FALSE(delay.start_of_frame()) << "run " << run << ", group " << sent.size();
            continue;
         }
         const auto& [old_data, old_start] = sent[sent.size() - 1 - kGroups];
         ASSERT_EQ(delay.data(), old_data);
         ASSERT_EQ(delay.start_of_frame(), old_start);
      }
   }
}

}  // namespace
}  // namespace stereo::test
