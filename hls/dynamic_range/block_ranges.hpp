// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/coarse_range.hpp"
#include "dynamic_range/config.hpp"
#include "support/ports.hpp"
#include "support/row_buffer.hpp"

namespace stereo::dynamic_range {

/// From the coarse map to the surfaces of each block of 8x8 pixels, that is of 2x2 coarse ones. Behind each row of the
/// map it adds a column, and behind the last one a row, in which nothing is known. Memory: (W/4 + 1) x 2 coarse
/// disparities, W/8 ranges.
template <const Config& C>
struct BlockRanges {
   static constexpr int kBits = bits_for(C.coarse_disparities() - 1);
   using Range = CoarseRange<kBits>;
   using Word = typename Range::Word;
   using Value = typename Range::Value;
   static constexpr int kColumns = C.coarse_columns();  ///< also the number of the added column
   static constexpr int kRows = C.coarse_rows();        ///< also the number of the added row
   static constexpr int kIdle = kRows + 1;
   /// A disparity, and above it whether it counts.
   static constexpr int kLaneBits = kBits + 1;
   using Pixels = RowBuffer<kLaneBits, 1, 2, kColumns + 1>;
   /// Pair k ends with coarse column 2k - 1.
   using Pairs = RowBuffer<Range::kWordBits, 1, 1, C.block_columns() + 1>;
   using Lane = typename Pixels::Lane;
   static constexpr int kMemories = Pixels::kMemories + Pairs::kMemories;
   /// From a pixel of the coarse map to the block that it completes: a column later.
   static constexpr int kClocks = 1 + Pixels::kClocks + 1 + 1 + 1 + Pairs::kClocks + 1;

   struct Place {
      uint16_t column, row;
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("row", row);
         visit("valid", valid);
      }
   };

   // clock 1
   uint16_t column, row;  ///< of the next pixel
   Lane pixel[1];
   Place in;
   // clocks 2, 3
   Pixels pixels;
   Place read, ready;
   uint16_t pixels_written;
   // clock 4: rows of two columns
   Lane left, above, middle, below;     // the centre's column and the one before it
   Lane next_above, right, next_below;  // and the one behind it
   Place centre;                        ///< its column is the one behind the centre's
   // clock 5
   bool counts;
   Value disparity;
   Place counted;
   // clock 6: pairs of one row
   Word first_of_pair, pair[1];
   Place paired;
   // clocks 7, 8
   Pairs pairs;
   Place pair_read, pair_ready;
   uint16_t pairs_written;
   // clock 9
   Word range;
   uint16_t block_column, block_row;
   bool valid;

   template <class Source, int First>
   HLS_INLINE BlockRanges(Source& memories, MemoryId<First> first)
       : pixels(memories, first), pairs(memories, MemoryId<First + Pixels::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("row", row, kIdle);
      visit("pixel", pixel);
      visit("in", in);
      visit("pixels", pixels);
      visit("read", read);
      visit("ready", ready);
      visit("pixels_written", pixels_written);
      visit("left", left);
      visit("above", above);
      visit("middle", middle);
      visit("below", below);
      visit("next_above", next_above);
      visit("right", right);
      visit("next_below", next_below);
      visit("centre", centre);
      visit("counts", counts);
      visit("disparity", disparity);
      visit("counted", counted);
      visit("first_of_pair", first_of_pair);
      visit("pair", pair);
      visit("paired", paired);
      visit("pairs", pairs);
      visit("pair_read", pair_read);
      visit("pair_ready", pair_ready);
      visit("pairs_written", pairs_written);
      visit("range", range);
      visit("block_column", block_column);
      visit("block_row", block_row);
      visit("valid", valid);
   }

   HLS_INLINE void clock(const StereoOutput& coarse) {
      join_rows();
      join_columns();
      count();
      shift();
      take(coarse);
   }

  private:
   /// Clocks 7 to 9: the pair above, in the even row, and the one below it.
   HLS_INLINE void join_rows() {
      range = Range::joined(pairs.row(0), pairs.row(1));
      valid = pair_ready.valid & ((pair_ready.row & 1) != 0);
      block_column = uint16_t(pair_ready.column - 1);
      block_row = uint16_t(pair_ready.row >> 1);
      pairs.clock(pair, paired.column, pair_ready.valid, pairs_written);
      pairs_written = at_most<C.block_columns()>(select<uint16_t>(pair_ready.valid, pair_ready.column, pairs_written));
      pair_ready = pair_read;
      pair_read = paired;
   }

   /// Clock 6.
   HLS_INLINE void join_columns() {
      const Word here = select<Word>(counts, Range::of(disparity, disparity), 0);
      pair[0] = Range::joined(first_of_pair, here);
      paired.valid = counted.valid & ((counted.column & 1) == 0);
      paired.column = at_most<C.block_columns()>(counted.column >> 1);
      paired.row = counted.row;
      first_of_pair = select<Word>(counted.valid, here, first_of_pair);
   }

   static HLS_INLINE bool is_valid(Lane lane) { return (lane >> kBits & 1) != 0; }
   static HLS_INLINE Value value(Lane lane) { return Value(lane & ((1u << kBits) - 1)); }
   static HLS_INLINE uint8_t agrees(Lane a, Lane b) {
      const int difference = int(value(a)) - int(value(b));
      return uint8_t(is_valid(b) & (difference <= 1) & (difference >= -1));
   }

   /// Clock 5: two neighbours must agree.
   HLS_INLINE void count() {
      const uint8_t neighbours =
          uint8_t(agrees(middle, above) + agrees(middle, below) + agrees(middle, left) + agrees(middle, right));
      counts = is_valid(middle) & (neighbours >= 2);
      disparity = value(middle);
      counted = centre;
   }

   /// Clocks 2 to 4. When a column has come, the one before it is the centre, in the row above.
   HLS_INLINE void shift() {
      const bool moves = ready.valid;
      const Lane row_above = select<Lane>(ready.row >= 2, pixels.row(0), 0);
      const Lane row_here = select<Lane>(ready.row >= 1, pixels.row(1), 0);
      left = select<Lane>(moves, middle, left);  // of column 0: the added column
      middle = select<Lane>(moves, right, middle);
      right = select<Lane>(moves, row_here, right);
      above = select<Lane>(moves, next_above, above);
      below = select<Lane>(moves, next_below, below);
      next_above = select<Lane>(moves, row_above, next_above);
      next_below = select<Lane>(moves, pixels.row(2), next_below);
      centre.valid = moves & (ready.column >= 1) & (ready.row >= 1);
      centre.column = ready.column;
      centre.row = uint16_t(ready.row - 1);
      pixels.clock(pixel, in.column, ready.valid, pixels_written);
      pixels_written = at_most<kColumns>(select<uint16_t>(ready.valid, ready.column, pixels_written));
      ready = read;
      read = in;
   }

   /// Clock 1.
   HLS_INLINE void take(const StereoOutput& coarse) {
      const bool starts = coarse.valid & coarse.start_of_frame;
      const bool adds = (column == kColumns) | (row == kRows);
      const bool active = row != kIdle;
      const bool takes = starts | (active & (adds | coarse.valid));
      const uint16_t now_column = select<uint16_t>(starts, 0, column), now_row = select<uint16_t>(starts, 0, row);
      const bool line_ends = now_column == kColumns;
      const uint16_t column_after = select<uint16_t>(line_ends, 0, uint16_t(now_column + 1));
      const uint16_t row_after = select<uint16_t>(line_ends, uint16_t(now_row + 1), now_row);
      const bool known = coarse.valid & coarse.pixel_valid[0] & (starts | !adds);
      pixel[0] = Lane(Lane(coarse.disparity[0] & ((1u << kBits) - 1)) | Lane(Lane(known) << kBits));
      in.column = at_most<kColumns>(now_column);
      in.row = now_row;
      in.valid = takes;
      column = at_most<kColumns>(select<uint16_t>(takes, column_after, now_column));
      row = at_most<kIdle>(select<uint16_t>(takes, row_after, now_row));
   }
};

}  // namespace stereo::dynamic_range
