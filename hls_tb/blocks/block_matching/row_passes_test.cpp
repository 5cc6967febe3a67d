// SPDX-License-Identifier: Apache-2.0
#include "block_matching/row_passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

template <Reference Role, int MinDisparity, int Passes, int Window, Aggregation Sums, int LeftRight>
struct Type {
   static constexpr block_matching::Config kConfig{
       {.width_px = 70, .height_px = 12},
       {DisparityCount{12}, MatchingWindow{Window}, SmallestDisparity{MinDisparity}, ReferenceImage{Role},
        LeftRightThreshold{LeftRight}},
       {Summation{Sums}, Folding{Passes}}};
};

template <class Type>
class RowPassesTest : public ::testing::Test {};
using Types = ::testing::Types<Type<Reference::right, 0, 2, 3, Aggregation::direct, -1>,
                               Type<Reference::left, -3, 3, 6, Aggregation::recursive, -1>,
                               Type<Reference::right, -5, 4, 2, Aggregation::direct, 1>,
                               Type<Reference::left, 4, 6, 7, Aggregation::recursive, 1>>;
TYPED_TEST_SUITE(RowPassesTest, Types);

/// By definition of a disparity: the reference's pixel x meets the searched one at x + d (right reference) or x - d.
template <const block_matching::Config& C>
void expect_passes() {
   constexpr int kTaps = C.tap_rows(), kLanes = C.pass_disparities(), kRows = 5;
   constexpr bool kFalls = C.reference == Reference::right;
   using Front = LineBuffer<block_matching::kFront<C>>;
   Random random(test_seed());
   HeapMemories memories;
   Front in(memories, MemoryId<0>());
   block_matching::RowPasses<C> passes(memories, MemoryId<Front::kMemories>());
   const auto pixel = [](int image, int y, int x, int t) { return uint8_t(31 * image + 101 * y + 7 * x + 59 * t); };
   int shown = 0;  // columns of passes
   const auto clock = [&] {
      passes.clock(in);
      if (!passes.tag.valid) return;
      const int y = shown / C.passes_columns(), place = shown % C.passes_columns();
      const int pass = std::min(place / C.pass_columns(), C.clocks_per_pixel - 1);
      const int column = place - pass * C.pass_columns();
      ++shown;
      const int cost_column = column - C.columns_before_pass();
      const PixelTag& tag = passes.tag;
      ASSERT_EQ(tag.row_start, place == 0);
      ASSERT_EQ(tag.first_group, y == 0);
      ASSERT_EQ(tag.border_column, cost_column < 0 || cost_column >= C.cost_columns());
      ASSERT_EQ(tag.first_cost, cost_column == 0);
      ASSERT_EQ(tag.leaves_window, cost_column >= C.window_px);
      const int map_column = cost_column + C.first_cost_column() - C.first_map_column();
      ASSERT_EQ(tag.map_column, map_column >= 0 && map_column < C.output_width_px());
      ASSERT_EQ(tag.output_column, tag.map_column && y > 0);
      ASSERT_EQ(tag.first_column, map_column == 0);
      ASSERT_EQ(tag.start_of_frame, map_column == 0 && y == 1);
      ASSERT_EQ(tag.end_of_line, map_column == C.output_width_px() - 1);
      // The pixel of the first cost column, and what it meets at the end of the range where pixels come in.
      const int x = C.first_cost_column() - C.reference_delay() + cost_column;
      const int d = C.min_disparity + pass * kLanes + (kFalls ? kLanes - 1 : 0);
      const int searched = kFalls ? x + d : x - d;
      for (int t = 0; t < kTaps; ++t) {
         if (!tag.border_column) {
            ASSERT_EQ(passes.reference[t], pixel(0, y, x, t));
         }
         // All that the lanes hold at the first cost column has come in before.
         if (cost_column > -kLanes && searched >= 0 && searched < C.width_px) {
            ASSERT_EQ(passes.search[t], pixel(1, y, searched, t));
         }
      }
   };
   for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         in.tag.valid = true;
         in.tag.row_start = x == 0;
         in.tag.first_column = x == (kFalls ? 0 : 1);
         in.tag.first_group = y == 0;
         in.tag.output_column = y > 0;
         in.tag.start_of_frame = in.tag.first_column && y == 1;
         in.write_column = uint16_t(x);
         for (int t = 0; t < kTaps; ++t) {
            in.reference[t] = pixel(0, y, x, t);
            in.search[t] = pixel(1, y, x, t);
         }
         clock();
         // As close as the contract allows in some rows.
         const int more = y % 2 == 0 ? 0 : random.below(4);
         for (int i = 0; i < C.clocks_per_pixel - 1 + more; ++i) {
            in.tag.valid = false;
            for (int t = 0; t < kTaps; ++t) in.search[t] = uint8_t(random.below(256));
            clock();
         }
      }
   in.tag.valid = false;
   for (int i = 0; i < C.clocks_per_pixel * C.width_px; ++i) clock();
   EXPECT_EQ(shown, kRows * C.passes_columns());
}

TYPED_TEST(RowPassesTest, ShowEachRowOnceForEachRangeOfDisparities) { expect_passes<TypeParam::kConfig>(); }

}  // namespace
}  // namespace stereo::test
