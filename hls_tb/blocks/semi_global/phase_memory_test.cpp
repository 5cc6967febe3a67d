// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_memory.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// One memory of so many words, two or three clocks from a register of its address to its words, with pauses between
/// the writes.
template <int Places>
void expect_words() {
   constexpr int kCount = 2;
   Random random(test_seed());
   HeapMemories memories;
   semi_global::PhaseMemory<uint16_t, Places, kCount> memory(memories, MemoryId<0>());
   std::vector<int> words = std::vector<int>(std::size_t(kCount * Places));
   std::deque<std::vector<int>> expected;
   for (int clock = 0; clock < 20000; ++clock) {
      const int from = random.below(Places), to = random.percent(20) ? random.below(Places) : clock % Places;
      const bool writes = random.percent(70);
      uint16_t in[kCount];
      for (uint16_t& word : in) word = uint16_t(random.below(1 << 16));
      memory.clock(uint16_t(from), writes, uint16_t(to), in);
      if (expected.size() == memory.kReadClocks) {
         for (int w = 0; w < kCount; ++w)
            ASSERT_EQ(memory.ready_words[w], expected.front()[std::size_t(w)]) << "clock " << clock;
         expected.pop_front();
      }
      // What is given to be written in a clock is in the memory for addresses of the next one.
      std::vector<int> read;
      for (int w = 0; w < kCount; ++w) read.push_back(words[std::size_t(from * kCount + w)]);
      expected.push_back(read);
      if (writes)
         for (int w = 0; w < kCount; ++w) words[std::size_t(to * kCount + w)] = in[w];
   }
}

TEST(PhaseMemory, HoldsWordsInBanks) {
   expect_words<100>();
   expect_words<4096>();
   expect_words<4097>();
   expect_words<4616>();
   expect_words<9000>();
}

}  // namespace
}  // namespace stereo::test
