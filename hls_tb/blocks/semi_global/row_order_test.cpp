// SPDX-License-Identifier: Apache-2.0
#include "semi_global/row_order.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "frontend/image_size.hpp"
#include "scene/random.hpp"
#include "semi_global/winner_turn.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"

namespace stereo::test {
namespace {

/// A row of the stream: which row of the map it is, or none, and how many of its columns come.
struct Row {
   bool output, first;
   int columns;
};

/// Whole rows and rows that break off.
std::vector<Row> random_rows(Random& random, int width, int count) {
   std::vector<Row> rows;
   for (int i = 0; i < count; ++i)
      rows.push_back({random.percent(80), random.percent(20), random.percent(20) ? 1 + random.below(width) : width});
   return rows;
}

/// Rows of `width` columns.
template <class Order, class Size>
void expect_order(const int width, const Size& size) {
   Random random(test_seed());
   Order order;
   order.last.clock(size);
   std::vector<int> memory(std::size_t(width), -1);
   const std::vector<Row> rows = random_rows(random, width, 60);
   int turned_rows = 0;
   for (std::size_t r = 0; r < rows.size(); ++r)
      for (int i = 0; i < rows[r].columns + 3;) {
         PixelTag tag;
         tag.valid = random.percent(70);
         tag.map_column = i < rows[r].columns;
         tag.output_column = tag.map_column && rows[r].output;
         tag.first_column = i == 0;
         tag.start_of_frame = i == 0 && rows[r].first;
         tag.end_of_line = i == width - 1;
         order.clock(tag, size);
         ASSERT_EQ(order.turned.valid, tag.valid);
         if (!tag.valid) continue;
         if (tag.map_column) {
            const bool held = r > 0 && rows[r - 1].columns == width;
            int& word = memory.at(order.address);
            // The row before, from its last column to its first.
            if (held) {
               ASSERT_EQ(word, int(r - 1) * width + width - 1 - i) << "row " << r << " column " << i;
            }
            word = int(r) * width + i;
            ASSERT_EQ(order.turned.output_column, held && rows[r - 1].output) << "row " << r << " column " << i;
            ASSERT_EQ(order.turned.first_column, i == 0);
            ASSERT_EQ(order.turned.start_of_frame, i == 0 && held && rows[r - 1].output && rows[r - 1].first);
            ASSERT_EQ(order.turned.end_of_line, i == width - 1);
            turned_rows += held && i == width - 1 ? 1 : 0;
         }
         ASSERT_EQ(order.turned.map_column, tag.map_column);
         ++i;
      }
   EXPECT_GT(turned_rows, 10);
}

TEST(RowOrder, GivesEachWholeRowBackFromItsLastColumnOn) {
   using semi_global::RowOrder;
   expect_order<RowOrder<1>>(1, 0);
   expect_order<RowOrder<2>>(2, 0);
   expect_order<RowOrder<9>>(9, 0);
   expect_order<RowOrder<32>>(32, 0);
}

/// What RowOrder reads of a RunTimeSize.
struct Width {
   struct {
      uint16_t last_column;
   } windows;
};
constexpr Image kWide{.width_px = 45, .height_px = 2};

TEST(RowOrder, GivesNarrowerRowsBackToo) {
   constexpr int kMap = 32;
   using Order = semi_global::RowOrder<kMap, RunTimeNumber<kWide, kMap - 1>>;
   for (const int narrower : {0, 1, 13, 30, 31})
      expect_order<Order>(kMap - narrower, Width{{uint16_t(kWide.width_px - 1 - narrower)}});
}

constexpr semi_global::Config kWhole{{.width_px = 30, .height_px = 9}, {DisparityCount{12}}, {}};
constexpr semi_global::Config kSixteenths{
    {.width_px = 30, .height_px = 9}, {DisparityCount{12}, SubpixelSteps{true}}, {}};

template <const semi_global::Config& C>
void expect_winners() {
   constexpr int kWidth = C.output_width_px(), kClocks = semi_global::WinnerTurn<C>::kClocks;
   Random random(test_seed());
   HeapMemories memories;
   semi_global::WinnerTurn<C> turn(memories, MemoryId<0>());
   using Record = Winners<semi_global::kSumConfig<C>>;
   std::vector<Record> before, now;                // the columns of the last row, and of this one
   std::vector<std::pair<Record, bool>> expected;  // what each clock puts in, and whether it has a meaning
   int compared = 0;
   for (int y = 0; y < 12; ++y) {
      before = now;
      now.clear();
      for (int i = 0; i < C.width_px;) {
         Record in;
         in.tag.valid = random.percent(70);
         in.tag.map_column = i < kWidth;
         in.tag.output_column = in.tag.map_column;
         in.tag.start_of_frame = i == 0 && y % 4 == 0;
         in.tag.end_of_line = i == kWidth - 1;
         in.disparity[0] = random.byte();
         in.fraction[0] = C.subpixel ? uint8_t(random.below(17)) : 8;
         in.passed[0] = random.percent(50);
         turn.clock(in);
         Record out;
         const bool shows = in.tag.valid && i < kWidth && y > 0;
         if (shows) {
            out = before[std::size_t(kWidth - 1 - i)];
            out.tag.start_of_frame = i == 0 && (y - 1) % 4 == 0;
            out.tag.end_of_line = i == kWidth - 1;
         }
         expected.push_back({out, shows});
         if (expected.size() >= std::size_t(kClocks)) {
            const auto& [wanted, known] = expected[expected.size() - std::size_t(kClocks)];
            const Record got = turn.output();
            ASSERT_EQ(got.tag.valid && got.tag.output_column, known);
            if (known) {
               ASSERT_EQ(got.disparity[0], wanted.disparity[0]) << "row " << y << " column " << i;
               ASSERT_EQ(got.fraction[0], wanted.fraction[0]);
               ASSERT_EQ(got.passed[0], wanted.passed[0]);
               ASSERT_EQ(got.tag.start_of_frame, wanted.tag.start_of_frame);
               ASSERT_EQ(got.tag.end_of_line, wanted.tag.end_of_line);
               ++compared;
            }
         }
         if (!in.tag.valid) continue;
         if (in.tag.map_column) now.push_back(in);
         ++i;
      }
   }
   EXPECT_EQ(compared, 11 * kWidth);
}

TEST(WinnerTurn, GivesTheWinnersBackInRasterOrder) {
   expect_winners<kWhole>();
   expect_winners<kSixteenths>();
}

}  // namespace
}  // namespace stereo::test
