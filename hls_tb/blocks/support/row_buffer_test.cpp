// SPDX-License-Identifier: Apache-2.0
#include "support/row_buffer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <int LaneBits, int Pixels, int Stored, int Width>
struct Shape {
   using Rows = RowBuffer<LaneBits, Pixels, Stored, Width>;
   static constexpr int kBits = LaneBits, kPixels = Pixels, kStored = Stored, kWidth = Width;
};

template <class Shape>
class RowBufferTest : public ::testing::Test {};
/// 4 columns are the fewest: a column is written three clocks after it was read.
using Shapes = ::testing::Types<Shape<8, 1, 2, 4>, Shape<8, 1, 1, 5>, Shape<8, 2, 2, 9>, Shape<8, 4, 7, 8>,
                                Shape<8, 4, 3, 6>, Shape<13, 2, 3, 7>, Shape<62, 4, 6, 5>, Shape<8, 1, 31, 4>>;
TYPED_TEST_SUITE(RowBufferTest, Shapes);

TYPED_TEST(RowBufferTest, ShowsTheLastRowsAboveTheNewest) {
   constexpr int P = TypeParam::kPixels, kStored = TypeParam::kStored, W = TypeParam::kWidth;
   using Rows = typename TypeParam::Rows;
   using Lane = typename Rows::Lane;
   struct Place {
      bool valid = false;
      int column = 0;
      std::size_t height = 0;  ///< rows that the column has up to here
   };
   Random random(test_seed());
   HeapMemories memories;
   Rows rows(memories, MemoryId<5>());
   std::vector<std::vector<Lane>> columns(W, std::vector<Lane>(kStored, 0));  // reset: rows of zeros came before
   Place read, ready;
   int write_column = 0;
   for (int n = 0; n < W * 3 * (kStored + P);) {
      Place now;
      now.valid = !random.percent(30);
      now.column = now.valid ? n % W : random.below(W);
      Lane newest[P];
      for (Lane& lane : newest) lane = Lane(mix_bits(random.bits()) >> (64 - TypeParam::kBits));
      auto& column = columns[std::size_t(now.column)];
      if (now.valid) column.insert(column.end(), newest, newest + P);
      now.height = column.size();
      rows.clock(newest, uint16_t(now.column), ready.valid, uint16_t(write_column));
      if (ready.valid) write_column = ready.column;
      ready = read;
      read = now;
      n += now.valid ? 1 : 0;
      if (!ready.valid) continue;
      const auto& shown = columns[std::size_t(ready.column)];
      for (int row = 0; row < kStored + P; ++row)
         ASSERT_EQ(rows.row(row), shown[ready.height - std::size_t(kStored + P - row)])
             << "record " << n << " column " << ready.column << " row " << row;
   }
}

}  // namespace
}  // namespace stereo::test
