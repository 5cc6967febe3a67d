// SPDX-License-Identifier: Apache-2.0
#include "rectification/quad_memory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// Reads and writes anywhere in each clock. A word is written in the clock in which a place that came in with it is
/// read, which shows the word of before.
template <int Columns, int Rows>
void expect_quads() {
   using rectification::QuadPlace;
   using Quad = std::array<int, 4>;
   Random random(test_seed());
   HeapMemories memories;
   rectification::QuadMemory<uint16_t, Columns, Rows> memory(memories, MemoryId<3>());
   std::vector<uint16_t> words(Columns * Rows);
   const auto word = [&words](int column, int row) -> uint16_t& {
      return words[std::size_t(row % Rows * Columns + column)];
   };
   std::deque<Quad> pipeline(memory.kClocks - 1);
   for (int clock = 0; clock < 50 * Columns * Rows; ++clock) {
      const QuadPlace read{uint16_t(random.below(Columns - 1)), uint16_t(random.below(Rows))};
      const QuadPlace write{uint16_t(random.below(Columns)), uint16_t(random.below(Rows))};
      const uint16_t newest = uint16_t(random.bits());
      const bool writes = random.percent(60);
      pipeline.push_back({word(read.column, read.row), word(read.column + 1, read.row), word(read.column, read.row + 1),
                          word(read.column + 1, read.row + 1)});
      if (writes) word(write.column, write.row) = newest;
      memory.clock(read, writes, write, newest);
      uint16_t taps[2][2];
      memory.taps(taps);
      if (clock >= memory.kClocks - 1) {
         ASSERT_EQ((Quad{taps[0][0], taps[0][1], taps[1][0], taps[1][1]}), pipeline.front()) << "clock " << clock;
      }
      pipeline.pop_front();
   }
}

TEST(QuadMemory, ShowsAnyFourNeighbours) {
   expect_quads<2, 2>();
   expect_quads<4, 2>();
   expect_quads<2, 6>();
   expect_quads<10, 8>();
   expect_quads<34, 14>();
}

}  // namespace
}  // namespace stereo::test
