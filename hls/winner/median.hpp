// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/raster_counter.hpp"
#include "support/row_buffer.hpp"
#include "winner/map_group.hpp"

namespace stereo {

/// Median of the 3x3 disparities around each pixel of the map, whose border repeats beyond it. 7 clocks; pixels come
/// out a row of groups and a column later. Memory: map width x (P+1) x (kValueBits + 1).
template <const auto& C>
struct Median {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = 7;
   /// Groups by which the medians come out later.
   static constexpr int kLagGroups = C.width_px + 1;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kRowGroups = C.row_groups();
   static constexpr int kValueBits = C.subpixel ? 12 : 8;
   static constexpr int kRows = kPixels + 2;
   using Counter = RasterCounter<kWidth, kRowGroups, 1, true>;
   using Rows = RowBuffer<kValueBits + 1, kPixels, kPixels + 1, kWidth>;
   using Lane = typename Rows::Lane;
   static constexpr int kMemories = Rows::kMemories;

   /// What travels beside a column. The column behind a line's last one only brings out the last median.
   struct Place {
      uint16_t column;
      bool arrives;      ///< a column of the map
      bool behind;       ///< the column behind a line
      bool top, bottom;  ///< the row above, below the group is outside the map
      bool output;       ///< the group above this one is in the map

      HLS_INLINE Place() { start(*this); }

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

   // clock 1
   Counter counter;
   Lane newest[kPixels];
   bool arrives, behind, line_ended;
   // clocks 2 and 3
   Rows rows;
   Place read, ready;
   uint16_t write_column;
   // clock 4: the three values above each other, for each row of the group, sorted when they become `sorted`
   Lane column[kRows];
   Place at;
   // clock 5
   uint16_t low[3][kPixels], middle[3][kPixels], high[3][kPixels];  ///< [age][p]
   bool passed[2][kPixels];
   bool complete, first, last;
   // clock 6
   uint16_t largest_low[kPixels], median_middle[kPixels], smallest_high[kPixels];
   MapGroup<C> waiting;
   // clock 7
   MapGroup<C> out;

   template <class Source, int First>
   HLS_INLINE Median(Source& memories, MemoryId<First> number) : rows(memories, number) {
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
      visit("low", low);
      visit("middle", middle);
      visit("high", high);
      visit("passed", passed);
      visit("complete", complete);
      visit("first", first);
      visit("last", last);
      visit("largest_low", largest_low);
      visit("median_middle", median_middle);
      visit("smallest_high", smallest_high);
      visit("waiting", waiting);
      visit("out", out);
   }

   HLS_INLINE void clock(const Winners<C>& in) {
      finish();
      combine();
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
      read.bottom = counter.group == kRowGroups;
      read.output = counter.group >= 1 && counter.group <= kRowGroups;
      take(in);
   }

  private:
   HLS_INLINE void take(const Winners<C>& in) {
      const MapGroup<C> group = map_group<C>(in);
      const bool comes = in.tag.valid && in.tag.map_column;
      counter.clock(comes, in.tag.start_of_frame);
      arrives = comes;
      behind = in.tag.valid && line_ended;
      line_ended = select<bool>(in.tag.valid, in.tag.map_column && in.tag.end_of_line, line_ended);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) newest[p] = Lane(Lane(group.disparity[p]) << 1 | Lane(group.passed[p]));
   }

   /// A new column goes in, or the one behind the line, which repeats the last; column 0 also is its own left
   /// neighbour.
   HLS_INLINE void sort_column() {
      const bool move = at.arrives || at.behind;
      const bool starts = at.column == 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const uint16_t centre = uint16_t(column[p + 1] >> 1);
         const uint16_t above =
             p == 0 ? select<uint16_t>(at.top, centre, uint16_t(column[p] >> 1)) : uint16_t(column[p] >> 1);
         const uint16_t below = p == kPixels - 1 ? select<uint16_t>(at.bottom, centre, uint16_t(column[p + 2] >> 1))
                                                 : uint16_t(column[p + 2] >> 1);
         const uint16_t a = smaller(above, centre), b = larger(above, centre);
         push(low, p, smaller(a, below), move, starts);
         push(middle, p, larger(a, smaller(b, below)), move, starts);
         push(high, p, larger(b, below), move, starts);
         passed[1][p] = select<bool>(move, passed[0][p], passed[1][p]);
         passed[0][p] = select<bool>(at.arrives, (column[p + 1] & 1) != 0, passed[0][p]);
      }
      complete = at.output && ((at.arrives && !starts) || at.behind);
      first = at.top && (kWidth > 1 ? at.arrives && at.column == 1 : at.behind);
      last = at.behind;
   }

   HLS_INLINE void push(uint16_t (&values)[3][kPixels], int p, uint16_t value, bool move, bool starts) {
      const uint16_t next = select<uint16_t>(at.behind, values[0][p], value);
      values[2][p] = select<uint16_t>(move, values[1][p], values[2][p]);
      values[1][p] = select<uint16_t>(move, select<uint16_t>(starts && at.arrives, next, values[0][p]), values[1][p]);
      values[0][p] = select<uint16_t>(move, next, values[0][p]);
   }

   HLS_INLINE void combine() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         largest_low[p] = larger(larger(low[0][p], low[1][p]), low[2][p]);
         median_middle[p] = median(middle[0][p], middle[1][p], middle[2][p]);
         smallest_high[p] = smaller(smaller(high[0][p], high[1][p]), high[2][p]);
         waiting.passed[p] = passed[1][p];
      }
      waiting.valid = complete;
      waiting.start_of_frame = complete && first;
      waiting.end_of_line = complete && last;
   }

   HLS_INLINE void finish() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         out.disparity[p] = median(largest_low[p], median_middle[p], smallest_high[p]);
         out.passed[p] = waiting.passed[p];
      }
      out.valid = waiting.valid;
      out.start_of_frame = waiting.start_of_frame;
      out.end_of_line = waiting.end_of_line;
   }

   static HLS_INLINE uint16_t smaller(uint16_t a, uint16_t b) { return select<uint16_t>(b < a, b, a); }
   static HLS_INLINE uint16_t larger(uint16_t a, uint16_t b) { return select<uint16_t>(b < a, a, b); }
   static HLS_INLINE uint16_t median(uint16_t a, uint16_t b, uint16_t c) {
      return larger(smaller(a, b), smaller(larger(a, b), c));
   }
};

}  // namespace stereo
