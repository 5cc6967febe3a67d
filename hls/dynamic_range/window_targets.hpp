// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/block_ranges.hpp"
#include "dynamic_range/config.hpp"
#include "support/row_buffer.hpp"

namespace stereo::dynamic_range {

/// Where the two search windows should begin in each block: a row of blocks, a band, as soon as the row below it is
/// known. It walks the band from its last block to its first, a block a clock. Memory: W/8 x 3 ranges.
template <const Config& C>
struct WindowTargets {
   using Range = typename BlockRanges<C>::Range;
   using Word = typename Range::Word;
   static constexpr int kColumns = C.block_columns(), kRows = C.block_rows();
   /// [0]: two rows above the newest one, [2]: the newest one.
   using Rows = RowBuffer<Range::kWordBits, 1, 3, kColumns>;
   static constexpr int kMemories = Rows::kMemories;
   /// Bands whose targets are kept: those of the rows that a window covers, and those that come.
   static constexpr int kBands = 8;
   static constexpr int kColumnBits = bits_for(kColumns - 1);
   static constexpr int kPlaces = kBands << kColumnBits;
   /// Clocks until the last range of a row can be read.
   static constexpr int kPause = 6;
   /// From the last block of a row to the last target of a band, and of the next one behind the last row.
   static constexpr int kClocks = 2 * (kColumns + kPause) + 8;

   struct Walk {
      uint16_t column;  ///< of the block that comes in, 65535: before the first one
      uint16_t band;
      bool has_above, has_below;  ///< the rows above and below the band are of the image
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("band", band);
         visit("has_above", has_above);
         visit("has_below", has_below);
         visit("valid", valid);
      }
   };

   // clock 1: a block comes, or the walk goes on
   Word newest[1];
   uint16_t read_column;
   bool comes;
   uint16_t pause;       ///< clocks since the last block of a row has come, up to kPause
   uint16_t walked;      ///< blocks, kWalk: it has ended
   uint16_t walk_place;  ///< of the next block; behind the first block it stands at the last one again
   uint16_t next_band;
   bool last_row;  ///< the newest row is the last one
   bool again;     ///< the walk is that of the last row itself
   Walk walk;
   // clocks 2, 3
   Rows rows;
   bool read_comes, ready_comes;
   uint16_t read_place, ready_place, write_column;
   Walk read_walk, ready_walk;
   // clock 4: of one column of blocks
   Word column_range;
   Walk column_walk;
   // clock 5: the column behind, the one at hand and the one before it
   Word behind, here, around;
   Walk around_walk;
   // clock 6: what the surfaces ask for
   uint16_t low_wish, high_wish;
   bool known;
   Walk wish_walk;
   // clock 7
   uint16_t low, high;
   uint16_t place;  ///< of the targets

   template <class Source, int First>
   HLS_INLINE WindowTargets(Source& memories, MemoryId<First> first) : rows(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("newest", newest);
      visit("read_column", read_column);
      visit("comes", comes);
      visit("pause", pause, kPause);
      visit("walked", walked, kWalk);
      visit("walk_place", walk_place);
      visit("next_band", next_band);
      visit("last_row", last_row);
      visit("again", again);
      visit("walk", walk);
      visit("rows", rows);
      visit("read_comes", read_comes);
      visit("ready_comes", ready_comes);
      visit("read_place", read_place);
      visit("ready_place", ready_place);
      visit("write_column", write_column);
      visit("read_walk", read_walk);
      visit("ready_walk", ready_walk);
      visit("column_range", column_range);
      visit("column_walk", column_walk);
      visit("behind", behind);
      visit("here", here);
      visit("around", around);
      visit("around_walk", around_walk);
      visit("low_wish", low_wish);
      visit("high_wish", high_wish);
      visit("known", known);
      visit("wish_walk", wish_walk);
      visit("low", low);
      visit("high", high);
      visit("place", place);
   }

   HLS_INLINE void clock(const BlockRanges<C>& blocks) {
      limit();
      wish();
      look_around();
      join_rows();
      rows.clock(newest, read_column, ready_comes, write_column);
      write_column = at_most<kColumns - 1>(select<uint16_t>(ready_comes, ready_place, write_column));
      ready_comes = read_comes;
      ready_place = read_place;
      ready_walk = read_walk;
      read_comes = comes;
      read_place = read_column;
      read_walk = walk;
      take(blocks);
   }

  private:
   static constexpr int kWalk = kColumns + 1;  ///< the block before the first one, too

   /// Clock 1.
   HLS_INLINE void take(const BlockRanges<C>& blocks) {
      const bool row_ends = blocks.valid & (blocks.block_column == kColumns - 1);
      const bool is_last = blocks.block_row == kRows - 1;
      // Behind the first row no band is complete, unless it is the last one too.
      const bool begins = row_ends & (is_last | (blocks.block_row != 0));
      const bool walks = (pause == kPause) & (walked != kWalk);
      const bool ends = walks & (walked == kWalk - 1);
      const bool repeats = ends & last_row & !again;

      walk.valid = walks;
      walk.column = uint16_t(kColumns - 1 - walked);
      walk.band = next_band;
      walk.has_above = next_band != 0;
      walk.has_below = !again;
      newest[0] = blocks.range;
      comes = blocks.valid;
      read_column = at_most<kColumns - 1>(select<uint16_t>(blocks.valid, blocks.block_column, walk_place));

      const bool single = kRows == 1;
      const uint16_t next_walked = select<uint16_t>(walks, uint16_t(walked + 1), walked);
      const uint16_t next_pause = select<uint16_t>(pause != kPause, uint16_t(pause + 1), pause);
      const uint16_t band_above = select<uint16_t>(single, blocks.block_row, uint16_t(blocks.block_row - 1));
      const uint16_t place_before = select<uint16_t>(walk_place == 0, kColumns - 1, uint16_t(walk_place - 1));
      const uint16_t next_place = select<uint16_t>(walks, place_before, walk_place);
      walked = select<uint16_t>(begins | repeats, 0, next_walked);
      walk_place = at_most<kColumns - 1>(select<uint16_t>(begins | repeats, kColumns - 1, next_place));
      pause = select<uint16_t>(begins, 0, next_pause);
      next_band = select<uint16_t>(begins, band_above, select<uint16_t>(repeats, uint16_t(next_band + 1), next_band));
      again = select<bool>(begins, single, again | repeats);
      last_row = select<bool>(begins, is_last, last_row);
   }

   /// Clock 4. The walk of the last row finds it as the newest, that of another band one below the newest.
   HLS_INLINE void join_rows() {
      const bool is_newest = !ready_walk.has_below;
      const Word above = select<Word>(is_newest, rows.row(1), rows.row(0));
      const Word middle = select<Word>(is_newest, rows.row(2), rows.row(1));
      const Word below = select<Word>(is_newest, 0, rows.row(2));
      const bool inside = ready_walk.column < kColumns;
      const Word two = Range::joined(select<Word>(ready_walk.has_above, above, 0), middle);
      column_range = select<Word>(inside, Range::joined(two, below), 0);
      column_walk = ready_walk;
   }

   /// Clock 5. The block behind the one that comes in is the centre.
   HLS_INLINE void look_around() {
      const bool begins = column_walk.column == kColumns - 1;
      const Word old_here = select<Word>(begins, 0, here), old_behind = select<Word>(begins, 0, behind);
      around = Range::joined(Range::joined(old_behind, old_here), column_range);
      behind = select<Word>(column_walk.valid, old_here, behind);
      here = select<Word>(column_walk.valid, column_range, here);
      around_walk = column_walk;
   }

   /// Clock 6. Disparities are 4 times those of the coarse map, and up to 3 more.
   HLS_INLINE void wish() {
      constexpr int kScale = Config::kCoarse, kLast = C.last_base();
      const int lowest = kScale * int(Range::low(around)) - Config::kMargin;
      const int highest = kScale * int(Range::high(around)) + kScale + Config::kMargin - C.window_disparities;
      low_wish = clamped(lowest, kLast);
      high_wish = clamped(highest, kLast);
      known = Range::known(around);
      wish_walk = around_walk;
   }
   static HLS_INLINE uint16_t clamped(int value, int last) {
      return uint16_t(select<int>(value < 0, 0, select<int>(value > last, last, value)));
   }

   /// Clock 7. A window that falls by 1 or rises by 3 a column must arrive in time.
   HLS_INLINE void limit() {
      constexpr int kLowStep = Config::kBlock * Config::kFall, kHighStep = Config::kBlock * Config::kRise;
      constexpr int kHighStart = C.window_disparities < C.last_base() ? C.window_disparities : C.last_base();
      const bool is_first = wish_walk.column == kColumns - 2;  // the centre is the last block of the band
      const uint16_t low_before = select<uint16_t>(is_first, 0, low);
      const uint16_t high_before = select<uint16_t>(is_first, kHighStart, high);
      const uint16_t low_reach = uint16_t(low_before + kLowStep);
      const uint16_t low_limited = select<uint16_t>(!is_first & (low_reach < low_wish), low_reach, low_wish);
      const bool falls_far = high_wish + kHighStep < high_before;
      const uint16_t high_limited =
          select<uint16_t>(!is_first & falls_far, uint16_t(high_before - kHighStep), high_wish);
      const bool writes = wish_walk.valid & (wish_walk.column != kColumns - 1);
      low = select<uint16_t>(writes, select<uint16_t>(known, low_limited, low_before), low);
      high = select<uint16_t>(writes, select<uint16_t>(known, high_limited, high_before), high);
      const uint16_t column = uint16_t(wish_walk.column + 1);
      const uint16_t wanted = uint16_t((wish_walk.band & (kBands - 1)) << kColumnBits | column);
      place = at_most<kPlaces - 1>(select<uint16_t>(writes, wanted, place));
   }
};

}  // namespace stereo::dynamic_range
