// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "postprocessing/limits.hpp"
#include "postprocessing/map_column.hpp"
#include "support/memory_bank.hpp"
#include "support/optional_block.hpp"
#include "support/row_buffer.hpp"
#include "support/settings.hpp"

namespace stereo {

/// Support filter and confidence: a pixel stays valid if enough of the 35 pixels around it are valid and have about its
/// disparity. 10 clocks; pixels come out some rows and 6 columns later. Memory, for one pixel a clock: map width x (4 x
/// (bits of a whole disparity + 1) + 2 x (bits of a fraction and of a margin)).
///
/// The window is 13 columns of a stream of rows, whatever stands between two of them: a column counts with those of its
/// own row only, which a tag says that differs from row to row.
template <const auto& C>
struct Support {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kDelay = support_groups(kPixels);  ///< groups of rows
   static constexpr int kClocks = 10;
   static constexpr int kLagGroups = kDelay * C.width_px + kSupportColumns;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kGroups = C.row_groups();
   static constexpr int kRows = kPixels + 2 * kSupportRows;  ///< of the windows of a group
   static constexpr int kColumns = 2 * kSupportColumns + 1;
   static constexpr int kCompared = kSupportColumns + 1;  ///< columns of a window that are compared
   static constexpr int kWholeBits = bits_for(C.disparities - 1);
   static constexpr int kFractionBits = C.subpixel ? 4 : 0;
   static constexpr bool kTakesMargin = C.has_confidence() && kHasRunnerUp<C>;
   static constexpr int kRestBits = kFractionBits + (kTakesMargin ? kMarginBits : 0);
   static constexpr bool kHasRest = kRestBits > 0;
   using Counter = RasterCounter<kWidth, kGroups, kDelay, true>;
   using Rows = RowBuffer<kWholeBits + 1, kPixels, kDelay * kPixels + kSupportRows, kWidth>;
   using RestRows = RowBuffer<(kHasRest ? kRestBits : 1), kPixels, kDelay * kPixels, kWidth>;
   using Rest = Optional<kHasRest, RestRows>;
   using Cell = typename Rows::Lane;  ///< whole disparity, and above it whether it is valid
   using RestLane = typename RestRows::Lane;
   static constexpr int kMemories = Rows::kMemories + Rest::kMemories;

   /// What travels beside a column.
   struct Place {
      uint16_t column;
      bool moves;           ///< the windows move on
      bool arrives;         ///< with a column of the map
      bool above2, above1;  ///< the rows two groups and one group above the centre's are inside the map
      bool below1, below2;
      bool output, first;  ///< of the centre's rows: of the map, its first ones
      bool last;           ///< the last column of a row

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("moves", moves);
         visit("arrives", arrives);
         visit("above2", above2);
         visit("above1", above1);
         visit("below1", below1);
         visit("below2", below2);
         visit("output", output);
         visit("first", first);
         visit("last", last);
      }
   };
   /// The same of a centre.
   struct Moment {
      bool map_column, output, start_of_frame, last;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("map_column", map_column);
         visit("output", output);
         visit("start_of_frame", start_of_frame);
         visit("last", last);
      }
   };

   // clock 1
   Counter counter;
   Cell newest[kPixels];
   RestLane newest_rest[kPixels];
   bool moves, arrives, last;
   // clocks 2 and 3
   Rows rows;
   Rest rest_rows;
   Place read, ready;
   uint16_t write_column;
   // clock 4
   Cell column[kRows];
   RestLane column_rest[kPixels];
   Place at;
   // clock 5: [age]
   Cell cells[kColumns][kRows];
   bool row_tag[kColumns];
   RestLane rest[kCompared][kPixels];
   Moment moment[kCompared];
   bool inside, next_tag;  ///< the last column was one of the map; the tag of its row
   bool moved;
   // clock 6: [p][age / 2][row]
   bool like[kPixels][kCompared][2 * kSupportRows + 1];
   // clock 7
   uint8_t partial[kPixels][kCompared];
   // clock 8
   uint8_t count[kPixels];
   [[no_unique_address]] TakenOver<C, uint8_t> threshold;
   // clock 9
   bool enough[kPixels];
   uint16_t sum[kPixels];
   // beside clocks 6 to 9
   Cell centre[4][kPixels];
   RestLane centre_rest[4][kPixels];
   Moment centre_moment[4];
   bool centre_moved[4];
   // clock 10
   MapColumn<C> out;

   template <class Source, int First>
   HLS_INLINE Support(Source& memories, MemoryId<First> number)
       : rows(memories, number), rest_rows(memories, MemoryId<First + Rows::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("counter", counter);
      visit("newest", newest);
      if constexpr (kHasRest) visit("newest_rest", newest_rest);
      visit("moves", moves);
      visit("arrives", arrives);
      visit("last", last);
      visit("rows", rows);
      if constexpr (kHasRest) visit("rest_rows", rest_rows);
      visit("read", read);
      visit("ready", ready);
      visit("write_column", write_column);
      visit("column", column);
      if constexpr (kHasRest) visit("column_rest", column_rest);
      visit("at", at);
      visit("cells", cells);
      visit("row_tag", row_tag);
      if constexpr (kHasRest) visit("rest", rest);
      visit("moment", moment);
      visit("inside", inside);
      visit("next_tag", next_tag);
      visit("moved", moved);
      visit("like", like);
      visit("partial", partial);
      visit("count", count);
      if constexpr (kSetAtRunTime<C>)
         visit("least", threshold.value, C.support_threshold);  // `support_threshold` is the port
      visit("enough", enough);
      if constexpr (C.has_confidence()) visit("sum", sum);
      visit("centre", centre);
      if constexpr (kHasRest) visit("centre_rest", centre_rest);
      visit("centre_moment", centre_moment);
      visit("centre_moved", centre_moved);
      visit("out", out);
   }

   /// map: the limits of the map's rows and columns.
   template <class Map, class Settings = NoSettings>
   HLS_INLINE void clock(const MapColumn<C>& in, const Map& map, const Settings& settings = Settings()) {
      finish(settings);
      count_like();
      move_window();
      take_column();
      rows.clock(newest, counter.column, ready.arrives, write_column);
      if constexpr (kHasRest) rest_rows.clock(newest_rest, counter.column, ready.arrives, write_column);
      write_column = select<uint16_t>(ready.arrives, ready.column, write_column);
      ready = read;
      find_place(map);
      take(in, map);
   }

  private:
   static constexpr Cell kValid = Cell(1u << kWholeBits);
   static constexpr int kSteps = C.subpixel ? 16 : 1;

   template <class Map>
   HLS_INLINE void take(const MapColumn<C>& in, const Map& map) {
      const bool comes = in.tag.valid & in.tag.map_column;
      counter.clock(comes, in.tag.start_of_frame, delayed(map));
      moves = in.tag.valid;
      arrives = comes;
      last = comes & in.tag.end_of_line;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const unsigned rounded = unsigned(in.disparity[p]) + unsigned(kSteps / 2);
         const Cell whole = Cell(Cell(rounded / unsigned(kSteps)) & Cell(kValid - 1));
         newest[p] = Cell(whole | select<Cell>(in.passed[p], kValid, 0));
         if constexpr (kHasRest) {
            RestLane lane = RestLane(rounded % unsigned(kSteps));
            if constexpr (kTakesMargin) lane = RestLane(lane | RestLane(in.sure[p]) << kFractionBits);
            newest_rest[p] = lane;
         }
      }
   }

   /// The limits of a counter that waits for so many groups.
   template <class Map>
   static HLS_INLINE auto delayed(const Map& map) {
      if constexpr (Map::kFixed) {
         return FixedRaster<kWidth, kGroups, kDelay>();
      } else {
         RunTimeRaster<kWidth, kGroups, kDelay> raster;
         raster.last_column = map.last_column;
         raster.last_group = map.last_group;
         raster.groups = map.groups;
         raster.last_counted = at_most<kGroups + kDelay - 1>(unsigned(map.groups) + unsigned(kDelay - 1));
         raster.idle = at_most<kGroups + kDelay>(unsigned(map.groups) + unsigned(kDelay));
         return raster;
      }
   }

   /// Of the column that has just been counted.
   template <class Map>
   HLS_INLINE void find_place(const Map& map) {
      const int centre_group = int(counter.group) - kDelay;
      read.column = counter.column;
      read.moves = moves;
      read.arrives = arrives;
      read.above2 = centre_group >= 2;
      read.above1 = centre_group >= 1;
      read.below1 = centre_group + 1 < int(map.groups);
      read.below2 = centre_group + 2 < int(map.groups);
      read.output = (centre_group >= 0) & (centre_group < int(map.groups));
      read.first = (centre_group == 0) & (counter.column == 0);
      read.last = last;
   }

   /// Whether a row of the windows is inside the map.
   static HLS_INLINE bool is_inside(const Place& place, int row) {
      // Groups above or below the centre's.
      const int below =
          row < kSupportRows ? -((kSupportRows - row + kPixels - 1) / kPixels) : (row - kSupportRows) / kPixels;
      return below == -2   ? place.above2
             : below == -1 ? place.above1
             : below == 1  ? place.below1
             : below == 2  ? place.below2
                           : true;
   }

   HLS_INLINE void take_column() {
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         const bool counts = ready.arrives & is_inside(ready, row);
         column[row] = Cell(rows.row(row) & select<Cell>(counts, Cell(kValid | (kValid - 1)), Cell(kValid - 1)));
      }
      if constexpr (kHasRest) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) column_rest[p] = rest_rows.row(p);
      }
      at = ready;
   }

   HLS_INLINE void move_window() {
      const bool move = at.moves;
      const bool starts = at.arrives & !inside;
      const bool tag = next_tag != starts;
      HLS_UNROLL
      for (int age = kColumns - 1; age > 0; --age) {
         HLS_UNROLL
         for (int row = 0; row < kRows; ++row)
            cells[age][row] = select<Cell>(move, cells[age - 1][row], cells[age][row]);
         row_tag[age] = select<bool>(move, row_tag[age - 1], row_tag[age]);
      }
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) cells[0][row] = select<Cell>(move, column[row], cells[0][row]);
      row_tag[0] = select<bool>(move, tag, row_tag[0]);
      HLS_UNROLL
      for (int age = kCompared - 1; age > 0; --age) {
         take_moment(moment[age], moment[age - 1], move);
         if constexpr (kHasRest) {
            HLS_UNROLL
            for (int p = 0; p < kPixels; ++p) rest[age][p] = select<RestLane>(move, rest[age - 1][p], rest[age][p]);
         }
      }
      take_moment(moment[0], {at.arrives, bool(at.arrives & at.output), bool(at.arrives & at.first), at.last}, move);
      if constexpr (kHasRest) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) rest[0][p] = select<RestLane>(move, column_rest[p], rest[0][p]);
      }
      next_tag = select<bool>(move, tag, next_tag);
      inside = select<bool>(move, at.arrives, inside);
      moved = move;
   }
   /// Member by member: a record of four bytes that is copied as one would become one number.
   static HLS_INLINE void take_moment(Moment& to, const Moment& from, bool move) {
      to.map_column = select<bool>(move, from.map_column, to.map_column);
      to.output = select<bool>(move, from.output, to.output);
      to.start_of_frame = select<bool>(move, from.start_of_frame, to.start_of_frame);
      to.last = select<bool>(move, from.last, to.last);
   }

   HLS_INLINE void count_like() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         uint8_t all = 0;
         HLS_UNROLL
         for (int i = 0; i < kCompared; ++i) all = uint8_t(all + partial[p][i]);
         count[p] = all & 63;
         const Cell middle = cells[kSupportColumns][p + kSupportRows];
         HLS_UNROLL
         for (int i = 0; i < kCompared; ++i) {
            uint8_t few = 0;
            HLS_UNROLL
            for (int row = 0; row <= 2 * kSupportRows; ++row) few = uint8_t(few + uint8_t(like[p][i][row]));
            partial[p][i] = few & 7;
            HLS_UNROLL
            for (int row = 0; row <= 2 * kSupportRows; ++row)
               like[p][i][row] = is_like(cells[2 * i][p + row], middle) & (row_tag[2 * i] == row_tag[kSupportColumns]);
         }
      }
   }
   /// With one bit more than a disparity has, so that the ends of the range stay apart.
   static HLS_INLINE bool is_like(Cell cell, Cell middle) {
      const unsigned difference = unsigned(cell & Cell(kValid - 1)) + 1u - unsigned(middle & Cell(kValid - 1));
      return ((cell & kValid) != 0) & ((difference & unsigned(2 * kValid - 1)) <= 2u);
   }

   template <class Settings>
   HLS_INLINE void finish(const Settings& settings) {
      unsigned least = unsigned(C.support_threshold);
      if constexpr (kSetAtRunTime<C>) {
         least = threshold.value;
         const bool starts = centre_moved[1] & centre_moment[1].start_of_frame;  // compared in the next clock
         threshold.value = select<uint8_t>(starts, settings.support_threshold, threshold.value);
      }
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const unsigned whole = unsigned(centre[3][p] & Cell(kValid - 1));
         if constexpr (C.subpixel)
            out.disparity[p] = uint16_t(16 * whole + unsigned(centre_rest[3][p] & 15) - 8u) & kMapMask;
         else out.disparity[p] = uint16_t(whole);
         out.passed[p] = enough[p];
         if constexpr (C.has_confidence()) {
            const uint8_t bounded =
                select<uint8_t>(sum[p] > C.kLargestConfidence, C.kLargestConfidence, uint8_t(sum[p]));
            out.sure[p] = select<uint8_t>(enough[p], bounded, 0);
            unsigned margin = 0;
            if constexpr (kTakesMargin) margin = unsigned(centre_rest[2][p] >> kFractionBits);
            sum[p] =
                uint16_t(unsigned(C.margin_weight) * margin + unsigned(C.support_weight) * unsigned(count[p])) & 1023;
         }
         enough[p] = ((centre[2][p] & kValid) != 0) & (count[p] >= least);
      }
      out.tag.valid = centre_moved[3];
      out.tag.map_column = centre_moment[3].map_column;
      out.tag.output_column = centre_moment[3].output;
      out.tag.start_of_frame = centre_moment[3].start_of_frame;
      out.tag.end_of_line = centre_moment[3].last;
      HLS_UNROLL
      for (int i = 3; i > 0; --i) {
         HLS_UNROLL
         for (int p = 0; p < kPixels; ++p) {
            centre[i][p] = centre[i - 1][p];
            if constexpr (kHasRest) centre_rest[i][p] = centre_rest[i - 1][p];
         }
         take_moment(centre_moment[i], centre_moment[i - 1], true);
         centre_moved[i] = centre_moved[i - 1];
      }
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         centre[0][p] = cells[kSupportColumns][p + kSupportRows];
         if constexpr (kHasRest) centre_rest[0][p] = rest[kSupportColumns][p];
      }
      take_moment(centre_moment[0], moment[kSupportColumns], true);
      centre_moved[0] = moved;
   }

   static constexpr uint16_t kMapMask = uint16_t((1u << kMapBits<C>)-1);
};

}  // namespace stereo
