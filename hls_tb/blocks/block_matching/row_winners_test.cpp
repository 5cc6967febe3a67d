// SPDX-License-Identifier: Apache-2.0
#include "block_matching/row_winners.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"

namespace stereo::test {
namespace {

template <int Disparities, int Passes, bool Subpixel, int Uniqueness>
struct Type {
   static constexpr block_matching::Config kConfig{
       {.width_px = 70, .height_px = 12},
       {DisparityCount{Disparities}, SubpixelSteps{Subpixel}, UniquenessPercent{Uniqueness}},
       {Folding{Passes}}};
};

template <class Type>
class RowWinnersTest : public ::testing::Test {};
using Types =
    ::testing::Types<Type<12, 2, false, 0>, Type<12, 3, true, 0>, Type<32, 4, false, 5>, Type<48, 6, true, 5>>;
TYPED_TEST_SUITE(RowWinnersTest, Types);

struct Winner {
   int disparity, fraction;
   bool passed;
};

/// A column of the row that comes in, and what must be shown for it.
struct Shown {
   PixelTag tag;
   uint16_t address;
   const Winner* winner = nullptr;  ///< of the row two rows before
};

/// The winners of row y-1 come a column a clock, while the columns of row y come in and bring out those of row y-2.
template <const block_matching::Config& C>
void expect_winners() {
   using Rows = block_matching::TwoRows<C>;
   constexpr int kWidth = C.width_px, kMap = C.output_width_px(), kRows = 9, F = C.clocks_per_pixel;
   Random random(test_seed());
   HeapMemories memories, unused;
   block_matching::RowPasses<C> passes(unused, MemoryId<0>());
   block_matching::RowWinners<C> row(memories, MemoryId<0>());
   std::vector<std::vector<Winner>> rows(kRows, std::vector<Winner>(kMap));
   for (std::vector<Winner>& winners : rows)
      for (Winner& winner : winners)
         winner = {random.below(C.disparities), C.subpixel ? random.below(17) : 8,
                   !C.has_check() || random.percent(50)};
   std::deque<Shown> expected = std::deque<Shown>(2);
   int compared = 0;
   const auto clock = [&](const Winners<C>& in, const Shown& shown) {
      passes.arrived = shown.tag.valid;
      passes.write_address = shown.address;
      row.clock(in, passes);
      expected.push_back(shown);
      // Two registers: what is given in a clock is shown behind the next one.
      expected.pop_front();
      const Shown& now = expected.front();
      ASSERT_EQ(row.winners.tag.valid, now.tag.valid);
      if (!now.tag.valid) return;
      ASSERT_PRED2(same_centre, now.tag, row.winners.tag);
      ASSERT_EQ(row.address_out, now.address);
      if (!now.winner || !now.tag.map_column) return;
      ASSERT_EQ(int(row.winners.disparity[0]), now.winner->disparity);
      ASSERT_EQ(int(row.winners.fraction[0]), now.winner->fraction);
      ASSERT_EQ(row.winners.passed[0], now.winner->passed);
      ++compared;
   };
   for (int y = 0; y < kRows; ++y) {
      // The last pass begins some time after the row, and ends before the next one.
      const int first = random.below(kWidth * F - kMap - 1);
      passes.leaving.output = random.percent(50);
      passes.leaving.starts = random.percent(50);
      Shown shown;
      for (int at = 0, x = -1; at < kWidth * F; ++at) {
         const bool arrives = at % F == 0;
         if (arrives) ++x;
         shown.tag = PixelTag();
         shown.tag.valid = arrives;
         shown.tag.map_column = x < kMap;
         shown.tag.output_column = x < kMap && passes.leaving.output;
         shown.tag.first_column = x == 0;
         shown.tag.start_of_frame = x == 0 && passes.leaving.starts;
         shown.tag.end_of_line = x == kMap - 1;
         shown.address = Rows::address(y % 2 != 0, unsigned(x));
         shown.winner = y >= 2 && x < kMap ? &rows[std::size_t(y - 2)][std::size_t(x)] : nullptr;
         Winners<C> in;
         const int column = at - first;
         in.tag.valid = y > 0 && (column < 0 || column >= kMap ? random.percent(50) : true);
         in.tag.map_column = column >= 0 && column < kMap;
         in.tag.first_column = column == 0;
         in.disparity[0] = uint8_t(random.below(C.disparities));
         if (y > 0 && in.tag.map_column) {
            const Winner& winner = rows[std::size_t(y - 1)][std::size_t(column)];
            in.disparity[0] = uint8_t(winner.disparity);
            in.fraction[0] = uint8_t(winner.fraction);
            in.passed[0] = winner.passed;
         }
         clock(in, shown);
      }
   }
   EXPECT_GE(compared, (kRows - 2) * kMap - 1);
}

TYPED_TEST(RowWinnersTest, LeaveWithTheSecondRowBehindThem) { expect_winners<TypeParam::kConfig>(); }

}  // namespace
}  // namespace stereo::test
