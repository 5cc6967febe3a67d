// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "support/optional_block.hpp"
#include "support/raster_counter.hpp"
#include "support/row_buffer.hpp"
#include "winner/map_group.hpp"
#include "winner/sort_three.hpp"

namespace stereo {

/// Median of the 3x3 disparities around each pixel of the map, whose border repeats beyond it. 11 clocks, as three
/// numbers take two to be sorted; pixels come out a row of groups and a column later. Memory: map width x (P+1) x
/// (kValueBits + 1), and map width x P x what else the post-processing gives.
template <const auto& C>
struct Median {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = 11;
   /// Groups by which the medians come out later.
   static constexpr int kLagGroups = C.width_px + 1;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kRowGroups = C.row_groups();
   static constexpr int kValueBits = C.subpixel ? 12 : 8;
   static constexpr int kRows = kPixels + 2;
   using Counter = RasterCounter<kWidth, kRowGroups, 1, true>;
   using Rows = RowBuffer<kValueBits + 1, kPixels, kPixels + 1, kWidth>;
   using Lane = typename Rows::Lane;
   using Value = uint_of_bits<kValueBits>;
   /// Of the pixel itself: confidence, and whether it was filled.
   static constexpr int kBesideBits = (kHasMargin<C> ? 8 : 0) + (kFillsHoles<C> ? 1 : 0);
   static constexpr bool kHasBeside = kBesideBits > 0;
   using BesideRows = RowBuffer<(kHasBeside ? kBesideBits : 1), kPixels, kPixels, kWidth>;
   using BesideLane = typename BesideRows::Lane;
   static constexpr int kMemories = Rows::kMemories + (kHasBeside ? BesideRows::kMemories : 0);

   /// What travels beside a column. The column behind a line's last one only brings out the last median.
   struct Place {
      uint16_t column;
      bool arrives;      ///< a column of the map
      bool behind;       ///< the column behind a line
      bool top, bottom;  ///< the row above, below the group is outside the map
      bool output;       ///< the group above this one is in the map

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("arrives", arrives);
         visit("behind", behind);
         visit("top", top);
         visit("bottom", bottom);
         visit("output", output);
      }
   };
   /// What a window's medians are.
   struct Moment {
      bool complete, first, last;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("complete", complete);
         visit("first", first);
         visit("last", last);
      }
   };

   /// On its way beside `passed`.
   struct Beside {
      BesideRows rows;
      BesideLane newest[kPixels];
      BesideLane column[kPixels];
      BesideLane of_column[2][kPixels], in_window[2][kPixels], waiting[3][kPixels];

      template <class Source, int First>
      HLS_INLINE Beside(Source& memories, MemoryId<First> number) : rows(memories, number) {
         start(*this);
      }
      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("newest", newest);
         visit("rows", rows);
         visit("column", column);
         visit("of_column", of_column);
         visit("in_window", in_window);
         visit("waiting", waiting);
      }
   };

   // clock 1
   Counter counter;
   Lane newest[kPixels];
   bool arrives, behind, line_ended;
   // clocks 2 and 3
   Rows rows;
   Place read, ready;
   uint16_t write_column;
   // clock 4
   Lane column[kRows];
   Place at;
   // clocks 5 and 6: the three values above each other, for each row of the group
   SortThree<Value> of_column[kPixels];
   bool column_passed[2][kPixels];
   Place comparing, sorted;
   Value sorted_low[kPixels], sorted_middle[kPixels], sorted_high[kPixels];
   // clock 7
   Value low[3][kPixels], middle[3][kPixels], high[3][kPixels];  ///< [age][p]
   bool passed[2][kPixels];
   Moment window;
   // clocks 8 and 9: the three columns
   SortThree<Value> of_low[kPixels], of_middle[kPixels], of_high[kPixels];
   Value largest_low[kPixels], median_middle[kPixels], smallest_high[kPixels];
   // clocks 10 and 11: what they leave
   SortThree<Value> of_all[kPixels];
   Moment waiting[3];  ///< beside clocks 8 to 10
   bool waiting_passed[3][kPixels];
   [[no_unique_address]] Optional<kHasBeside, Beside> beside;
   MapGroup<C> out;

   template <class Source, int First>
   HLS_INLINE Median(Source& memories, MemoryId<First> number)
       : rows(memories, number), beside(memories, MemoryId<First + Rows::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("counter", counter);
      visit("newest", newest);
      visit("arrives", arrives);
      visit("behind", behind);
      visit("line_ended", line_ended);
      visit("rows", rows);
      visit("read", read);
      visit("ready", ready);
      visit("write_column", write_column);
      visit("column", column);
      visit("at", at);
      visit("of_column", of_column);
      visit("column_passed", column_passed);
      visit("comparing", comparing);
      visit("sorted", sorted);
      visit("sorted_low", sorted_low);
      visit("sorted_middle", sorted_middle);
      visit("sorted_high", sorted_high);
      visit("low", low);
      visit("middle", middle);
      visit("high", high);
      visit("passed", passed);
      visit("window", window);
      visit("of_low", of_low);
      visit("of_middle", of_middle);
      visit("of_high", of_high);
      visit("largest_low", largest_low);
      visit("median_middle", median_middle);
      visit("smallest_high", smallest_high);
      visit("of_all", of_all);
      visit("waiting", waiting);
      visit("waiting_passed", waiting_passed);
      if constexpr (kHasBeside) visit("beside", beside);
      visit("out", out);
   }

   /// in: winners, or a column of the post-processing.
   template <class In, class Size = FixedSize<C>>
   HLS_INLINE void clock(const In& in, const Size& size = Size()) {
      finish();
      if constexpr (kHasBeside) move_beside();
      sort_window();
      add_column();
      sort_column();
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) column[row] = rows.row(row);
      at = ready;
      rows.clock(newest, counter.column, ready.arrives, write_column);
      write_column = select<uint16_t>(ready.arrives, ready.column, write_column);
      ready = read;
      read.column = counter.column;
      read.arrives = arrives;
      read.behind = behind;
      read.top = counter.group == 1;
      read.bottom = counter.group == size.map.groups;
      read.output = counter.group >= 1 && counter.group <= size.map.groups;
      take(in, size);
   }

  private:
   template <class In, class Size>
   HLS_INLINE void take(const In& in, const Size& size) {
      const MapGroup<C> group = map_group<C>(in);
      const bool comes = in.tag.valid && in.tag.map_column;
      counter.clock(comes, in.tag.start_of_frame, size.map);
      arrives = comes;
      behind = in.tag.valid && line_ended;
      line_ended = select<bool>(in.tag.valid, in.tag.map_column && in.tag.end_of_line, line_ended);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) newest[p] = Lane(Lane(group.disparity[p]) << 1 | Lane(group.passed[p]));
      if constexpr (kHasBeside) take_beside(group);
   }

   HLS_INLINE void take_beside(const MapGroup<C>& group) {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         BesideLane lane = 0;
         if constexpr (kFillsHoles<C>) lane = BesideLane(group.filled.value[p]);
         if constexpr (kHasMargin<C>)
            lane = BesideLane(lane | BesideLane(BesideLane(group.confidence.value[p]) << (kBesideBits - 8)));
         beside.newest[p] = lane;
      }
   }

   /// As `passed` moves; before the columns do.
   HLS_INLINE void move_beside() {
      const bool move = sorted.arrives | sorted.behind;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const BesideLane shown = beside.waiting[2][p];
         if constexpr (kFillsHoles<C>) out.filled.value[p] = (shown & 1) != 0;
         if constexpr (kHasMargin<C>) out.confidence.value[p] = uint8_t(shown >> (kBesideBits - 8));
         beside.waiting[2][p] = beside.waiting[1][p];
         beside.waiting[1][p] = beside.waiting[0][p];
         beside.waiting[0][p] = beside.in_window[1][p];
         beside.in_window[1][p] = select<BesideLane>(move, beside.in_window[0][p], beside.in_window[1][p]);
         beside.in_window[0][p] = select<BesideLane>(sorted.arrives, beside.of_column[1][p], beside.in_window[0][p]);
         beside.of_column[1][p] = beside.of_column[0][p];
         beside.of_column[0][p] = beside.column[p];
         beside.column[p] = beside.rows.row(p);
      }
      beside.rows.clock(beside.newest, counter.column, ready.arrives, write_column);
   }

   HLS_INLINE void sort_column() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         sorted_low[p] = of_column[p].smallest();
         sorted_middle[p] = of_column[p].median();
         sorted_high[p] = of_column[p].largest();
         column_passed[1][p] = column_passed[0][p];
         const Value centre = Value(column[p + 1] >> 1);
         const Value above = Value(column[p] >> 1), below = Value(column[p + 2] >> 1);
         of_column[p].compare(p == 0 ? select<Value>(at.top, centre, above) : above, centre,
                              p == kPixels - 1 ? select<Value>(at.bottom, centre, below) : below);
         column_passed[0][p] = (column[p + 1] & 1) != 0;
      }
      sorted = comparing;
      comparing = at;
   }

   /// A new column goes in, or the one behind the line, which repeats the last; column 0 also is its own left
   /// neighbour.
   HLS_INLINE void add_column() {
      const bool move = sorted.arrives || sorted.behind;
      const bool starts = sorted.column == 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         push(low, p, sorted_low[p], move, starts);
         push(middle, p, sorted_middle[p], move, starts);
         push(high, p, sorted_high[p], move, starts);
         passed[1][p] = select<bool>(move, passed[0][p], passed[1][p]);
         passed[0][p] = select<bool>(sorted.arrives, column_passed[1][p], passed[0][p]);
      }
      window.complete = sorted.output && ((sorted.arrives && !starts) || sorted.behind);
      window.first = sorted.top && (kWidth > 1 ? sorted.arrives && sorted.column == 1 : sorted.behind);
      window.last = sorted.behind;
   }

   HLS_INLINE void push(Value (&values)[3][kPixels], int p, Value value, bool move, bool starts) {
      const Value next = select<Value>(sorted.behind, values[0][p], value);
      values[2][p] = select<Value>(move, values[1][p], values[2][p]);
      values[1][p] = select<Value>(move, select<Value>(starts && sorted.arrives, next, values[0][p]), values[1][p]);
      values[0][p] = select<Value>(move, next, values[0][p]);
   }

   HLS_INLINE void sort_window() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         of_all[p].compare(largest_low[p], median_middle[p], smallest_high[p]);
         largest_low[p] = of_low[p].largest();
         median_middle[p] = of_middle[p].median();
         smallest_high[p] = of_high[p].smallest();
         of_low[p].compare(low[0][p], low[1][p], low[2][p]);
         of_middle[p].compare(middle[0][p], middle[1][p], middle[2][p]);
         of_high[p].compare(high[0][p], high[1][p], high[2][p]);
      }
   }

   HLS_INLINE void finish() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         out.disparity[p] = of_all[p].median();
         out.passed[p] = waiting_passed[2][p];
         waiting_passed[2][p] = waiting_passed[1][p];
         waiting_passed[1][p] = waiting_passed[0][p];
         waiting_passed[0][p] = passed[1][p];
      }
      out.valid = waiting[2].complete;
      out.start_of_frame = waiting[2].complete && waiting[2].first;
      out.end_of_line = waiting[2].complete && waiting[2].last;
      waiting[2] = waiting[1];
      waiting[1] = waiting[0];
      waiting[0] = window;
   }
};

}  // namespace stereo
