// SPDX-License-Identifier: Apache-2.0
#include "support/memory_bank.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// Gives zeros and keeps the numbers that were asked for, and the memories' sizes.
struct NumberedMemories {
   std::vector<int> numbers;

   template <class Word, int Depth, int Number>
   Word (&words())[Depth] {
      static Word memory[Depth];
      fill<Word>(memory, 0);
      numbers.push_back(Number);
      return memory;
   }
};

constexpr int kDepth = 7, kCount = 3;
using Bank = MemoryBank<uint16_t, kDepth, kCount>;
using Model = std::array<std::array<uint16_t, kDepth>, kCount>;

TEST(MemoryBank, TakesItsNumbersInTurn) {
   NumberedMemories memories;
   const Bank bank(memories, MemoryId<40>());
   EXPECT_EQ(std::set<int>(memories.numbers.begin(), memories.numbers.end()), (std::set<int>{40, 41, 42}));
   EXPECT_EQ(memories.numbers.size(), 3u);
}

TEST(MemoryBank, ReadsTogetherOrEachAtItsAddressWhatWasWritten) {
   Random random(test_seed());
   NumberedMemories memories;
   Bank bank(memories, MemoryId<0>());
   Model model{};
   for (int round = 0; round < 1000; ++round) {
      const uint16_t address = uint16_t(random.below(kDepth));
      uint16_t in[kCount], out[kCount], addresses[kCount];
      for (std::size_t i = 0; i < kCount; ++i) {
         in[i] = uint16_t(random.bits());
         model[i][address] = in[i];
         addresses[i] = uint16_t(random.below(kDepth));
      }
      bank.write(address, in);
      bank.read(addresses[0], out);
      for (std::size_t i = 0; i < kCount; ++i) ASSERT_EQ(out[i], model[i][addresses[0]]) << "memory " << i;
      bank.read_each(addresses, out);
      for (std::size_t i = 0; i < kCount; ++i) ASSERT_EQ(out[i], model[i][addresses[i]]) << "memory " << i;
   }
}

}  // namespace
}  // namespace stereo::test
