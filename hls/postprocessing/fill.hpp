// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "postprocessing/hole_ends.hpp"
#include "postprocessing/map_column.hpp"
#include "support/matching_options.hpp"
#include "support/row_buffer.hpp"

namespace stereo {

/// Fills holes with what stands beside them. 10 clocks; pixels come out a row of groups later. Memory: map width x P x
/// (bits of a disparity + 1 + bits of a confidence), that of HoleEnds, and map width x bits of a disparity for rows
/// without any valid pixel, which show the row above.
template <const auto& C>
struct Fill {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kClocks = 10;
   static constexpr int kLagGroups = C.width_px;
   static constexpr int kWidth = C.output_width_px();
   static constexpr int kLaneBits = kMapBits<C> + 1 + kSureBits<C>;
   static constexpr bool kFromLeft = C.reference == Reference::left;
   using Counter = RasterCounter<kWidth, C.row_groups(), 1, true>;
   using Rows = RowBuffer<kLaneBits, kPixels, kPixels, kWidth>;
   using Lane = typename Rows::Lane;
   using Ends = HoleEnds<C>;
   using Value = uint_of_bits<kMapBits<C>>;
   using Above = MemoryBank<Value, kWidth, 1>;
   static constexpr int kMemories = Rows::kMemories + Ends::kMemories + Above::kMemories;

   /// What travels beside a column of the row that goes out.
   struct Place {
      uint16_t column;
      bool moves;    ///< with a column that comes in
      bool arrives;  ///< with one of the map
      bool output;   ///< its rows are of the map
      bool top;      ///< its rows are the map's first ones
      bool last;     ///< the last column

      /// Member by member, as for Pixel: a record that is copied as one would become one number.
      HLS_INLINE void take(const Place& from) {
         column = from.column;
         moves = from.moves;
         arrives = from.arrives;
         output = from.output;
         top = from.top;
         last = from.last;
      }
      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("moves", moves);
         visit("arrives", arrives);
         visit("output", output);
         visit("top", top);
         visit("last", last);
      }
   };
   /// A pixel of it and what is known of its hole.
   struct Pixel {
      Value disparity;
      bool passed;
      uint8_t sure;

      HLS_INLINE void take(const Pixel& from) {
         disparity = from.disparity;
         passed = from.passed;
         if constexpr (C.has_confidence()) sure = from.sure;
      }
      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("disparity", disparity);
         visit("passed", passed);
         if constexpr (C.has_confidence()) visit("sure", sure);
      }
   };
   struct Beside {
      Value left, right;         ///< what stands there
      bool has_left, has_right;  ///< whether something does
      uint16_t left_column, right_column;

      HLS_INLINE void take(const Beside& from) {
         left = from.left;
         right = from.right;
         has_left = from.has_left;
         has_right = from.has_right;
         left_column = from.left_column;
         right_column = from.right_column;
      }
      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("left", left);
         visit("right", right);
         visit("has_left", has_left);
         visit("has_right", has_right);
         visit("left_column", left_column);
         visit("right_column", right_column);
      }
   };

   // clock 1
   Counter counter;
   uint16_t newest_disparity[kPixels];
   bool newest_passed[kPixels];
   uint8_t newest_sure[kPixels];
   bool moves, arrives, last;
   // clocks 2 and 3
   Rows rows;
   Place read, ready;
   uint16_t write_column;
   // clock 4
   Ends ends;
   Pixel pixel[kPixels];
   Place at;
   bool in_hole[kPixels];  ///< the pixel before was
   // clocks 5 and 6: the word of a hole is read
   Pixel asking[2][kPixels];
   Place asking_at[2];
   bool hole_starts[2][kPixels];
   // clock 7
   Pixel known[kPixels];
   Place known_at;
   Beside beside[kPixels];
   // clock 8
   Pixel measured[kPixels];
   Place measured_at;
   Beside measured_beside[kPixels];
   uint16_t width[kPixels];  ///< of the hole
   uint16_t step[kPixels];   ///< of the disparity, toward the side that hides; in whole pixels
   bool rises[kPixels];      ///< it is no step down
   // clock 9
   Pixel chosen[kPixels];
   Place chosen_at;
   Beside chosen_beside[kPixels];
   bool takes_left[kPixels];
   Value above_read[1], above[1];  // beside clocks 8 and 9
   Above above_memory;
   // clock 10
   MapColumn<C> out;
   bool has_values;       ///< some row so far has a valid pixel
   bool had_values;       ///< when the rows that go out began
   Value write_above[1];  ///< of the last row of a group
   uint16_t write_above_column;

   template <class Source, int First>
   HLS_INLINE Fill(Source& memories, MemoryId<First> number)
       : rows(memories, number),
         ends(memories, MemoryId<First + Rows::kMemories>()),
         above_memory(memories, MemoryId<First + Rows::kMemories + Ends::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("counter", counter);
      visit("newest_disparity", newest_disparity);
      visit("newest_passed", newest_passed);
      if constexpr (C.has_confidence()) visit("newest_sure", newest_sure);
      visit("moves", moves);
      visit("arrives", arrives);
      visit("last", last);
      visit("rows", rows);
      visit("read", read);
      visit("ready", ready);
      visit("write_column", write_column);
      visit("ends", ends);
      visit("pixel", pixel);
      visit("at", at);
      visit("in_hole", in_hole);
      visit("asking", asking);
      visit("asking_at", asking_at);
      visit("hole_starts", hole_starts);
      visit("known", known);
      visit("known_at", known_at);
      visit("beside", beside);
      visit("measured", measured);
      visit("measured_at", measured_at);
      visit("measured_beside", measured_beside);
      visit("width", width);
      visit("step", step);
      visit("rises", rises);
      visit("chosen", chosen);
      visit("chosen_at", chosen_at);
      visit("chosen_beside", chosen_beside);
      visit("takes_left", takes_left);
      visit("above_read", above_read);
      visit("above", above);
      visit("out", out);
      visit("has_values", has_values);
      visit("had_values", had_values);
      visit("write_above", write_above);
      visit("write_above_column", write_above_column);
   }

   /// map: the limits of the map's rows and columns.
   template <class Map>
   HLS_INLINE void clock(const MapColumn<C>& in, const Map& map) {
      Value stored[1];
      above_memory.read(known_at.column, stored);
      above_memory.write(write_above_column, write_above);
      show();
      above[0] = above_read[0];
      above_read[0] = stored[0];
      choose();
      measure();
      know();
      ask();
      take_rows();
      Lane newest[kPixels];
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) newest[p] = packed(p);
      rows.clock(newest, counter.column, ready.arrives, write_column);
      write_column = select<uint16_t>(ready.arrives, ready.column, write_column);
      ends.add(arrives, counter.column, last, newest_disparity, newest_passed);
      ready.take(read);
      find_place(map);
      take(in, map);
   }

  private:
   static constexpr Value kMask = Value((1u << kMapBits<C>)-1);
   static constexpr int kStepShift = C.subpixel ? 4 : 0;
   static constexpr uint16_t kColumnMask = uint16_t((1u << bits_for(kWidth)) - 1);

   HLS_INLINE Lane packed(int p) const {
      Lane lane = Lane(Lane(newest_disparity[p] & kMask) << 1 | Lane(newest_passed[p]));
      if constexpr (C.has_confidence()) lane = Lane(lane | Lane(Lane(newest_sure[p]) << (kMapBits<C> + 1)));
      return lane;
   }

   template <class Map>
   HLS_INLINE void take(const MapColumn<C>& in, const Map& map) {
      const bool comes = in.tag.valid & in.tag.map_column;
      counter.clock(comes, in.tag.start_of_frame, map);
      moves = in.tag.valid;
      arrives = comes;
      last = comes & in.tag.end_of_line;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         newest_disparity[p] = in.disparity[p];
         newest_passed[p] = in.passed[p];
         if constexpr (C.has_confidence()) newest_sure[p] = in.sure[p];
      }
   }

   template <class Map>
   HLS_INLINE void find_place(const Map& map) {
      read.column = counter.column;
      read.moves = moves;
      read.arrives = arrives;
      read.output = (counter.group >= 1) & (counter.group <= map.groups);
      read.top = counter.group == 1;
      read.last = last;
   }

   /// The column of the row before, and the search for the words of its holes.
   HLS_INLINE void take_rows() {
      bool reads_next[kPixels];
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         reads_next[p] = starts_hole(p);
         in_hole[p] = select<bool>(at.arrives, !pixel[p].passed, in_hole[p]);
         const Lane lane = rows.row(p);
         pixel[p].disparity = Value(Value(lane >> 1) & kMask);
         pixel[p].passed = (lane & 1) != 0;
         pixel[p].sure = 0;
         if constexpr (C.has_confidence()) pixel[p].sure = uint8_t(lane >> (kMapBits<C> + 1));
      }
      ends.clock(reads_next, ready.arrives & (ready.column == 0));
      at.take(ready);
   }
   HLS_INLINE bool starts_hole(int p) const { return at.arrives & !pixel[p].passed & ((at.column == 0) | !in_hole[p]); }

   HLS_INLINE void ask() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         asking[1][p].take(asking[0][p]);
         asking[0][p].take(pixel[p]);
         hole_starts[1][p] = hole_starts[0][p];
         hole_starts[0][p] = starts_hole(p);
      }
      asking_at[1].take(asking_at[0]);
      asking_at[0].take(at);
   }

   /// What stands on both sides of the hole.
   HLS_INLINE void know() {
      const Place& place = asking_at[1];
      const bool begins = place.arrives & (place.column == 0);
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Pixel& now = asking[1][p];
         const bool comes = place.arrives & now.passed;
         Beside& sides = beside[p];
         sides.left = select<Value>(comes, now.disparity, sides.left);
         sides.left_column = select<uint16_t>(comes, place.column, sides.left_column);
         sides.has_left = comes | (sides.has_left & !begins);
         const bool starts = hole_starts[1][p];
         const typename Ends::Word word = ends.ready_words[p];
         sides.right = select<Value>(starts, Value(Ends::disparity(word)), sides.right);
         sides.right_column = select<uint16_t>(starts, Ends::column(word), sides.right_column);
         sides.has_right = select<bool>(starts, Ends::exists(word), sides.has_right);
         known[p].take(now);
      }
      known_at.take(place);
   }

   HLS_INLINE void measure() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Beside& sides = beside[p];
         const unsigned near = kFromLeft ? sides.right : sides.left, far = kFromLeft ? sides.left : sides.right;
         const unsigned difference = (near - far) & unsigned(2 * kMask + 1);
         rises[p] = near >= far;
         step[p] = uint16_t(difference >> kStepShift);
         width[p] = uint16_t(unsigned(sides.right_column) - unsigned(sides.left_column) - 1u) & kColumnMask;
         measured_beside[p].take(sides);
         measured[p].take(known[p]);
      }
      measured_at.take(known_at);
   }

   HLS_INLINE void choose() {
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Beside& sides = measured_beside[p];
         const bool is_hidden = step[p] >= width[p];
         const uint16_t left_over = uint16_t(width[p] - step[p]) & kColumnMask;
         const uint16_t rest = select<uint16_t>(rises[p], select<uint16_t>(is_hidden, 0, left_over), width[p]);
         const uint16_t half = uint16_t(rest >> 1);
         const uint16_t x = measured_at.column;
         const bool is_before = kFromLeft ? unsigned(x) + half < sides.right_column : x <= sides.left_column + half;
         takes_left[p] = sides.has_left & (!sides.has_right | is_before);
         chosen_beside[p].take(sides);
         chosen[p].take(measured[p]);
      }
      chosen_at.take(measured_at);
   }

   HLS_INLINE void show() {
      const bool begins = chosen_at.arrives & (chosen_at.column == 0);
      const bool had = select<bool>(begins, has_values & !chosen_at.top, had_values);
      Value row_above = above[0];
      bool exists = had;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         const Pixel& now = chosen[p];
         const Beside& sides = chosen_beside[p];
         const bool has_side = sides.has_left | sides.has_right;
         const bool is_own = now.passed | (!has_side & chosen_at.top & (p == 0));
         const Value beside_it = select<Value>(takes_left[p], sides.left, sides.right);
         const Value filled = select<Value>(has_side, beside_it, row_above);
         row_above = select<Value>(is_own, now.disparity, filled);
         exists = exists | now.passed | has_side;
         out.disparity[p] = row_above;
         out.passed[p] = now.passed;
         out.filled[p] = exists & !now.passed;
         if constexpr (C.has_confidence()) out.sure[p] = now.sure;
      }
      had_values = select<bool>(chosen_at.arrives, had, had_values);
      has_values = select<bool>(chosen_at.arrives, exists, has_values);
      write_above[0] = select<Value>(chosen_at.arrives, row_above, write_above[0]);
      write_above_column = select<uint16_t>(chosen_at.arrives, chosen_at.column, write_above_column);
      out.tag.valid = chosen_at.moves;
      out.tag.map_column = chosen_at.arrives;
      out.tag.output_column = chosen_at.arrives & chosen_at.output;
      out.tag.start_of_frame = chosen_at.arrives & chosen_at.top & (chosen_at.column == 0);
      out.tag.end_of_line = chosen_at.last;
   }
};

}  // namespace stereo
