// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/pixel_tag.hpp"
#include "support/registers.hpp"

namespace stereo::semi_global {

/// Where a memory of `Width` words holds the columns of a row, so that the row before comes out of it from its last
/// column to its first while a row goes in: each column takes the place of the one that comes out. One row is written
/// upward, the next one downward, and so on. 1 clock. Last: the number Width-1, or one that follows from the width of
/// the images and is Width-1 at most.
template <int Width, class Last = FixedNumber<Width - 1>>
struct RowOrder {
   static constexpr int kClocks = 1;
   static constexpr bool kIsFixed = std::is_same_v<Last, FixedNumber<Width - 1>>;

   [[no_unique_address]] Last last;  ///< address of the last column of a row that is written upward
   uint16_t address;                 ///< 0 ... last: of the column that comes in
   bool falls;                       ///< addresses fall in this row
   bool inside;                      ///< the last column was one of the map
   // Of the row that comes in.
   bool complete;       ///< with its last column
   bool output, first;  ///< the row is one of the map, its first one
   // Of the row that comes out.
   bool held_output;  ///< it is one of the map
   PixelTag turned;   ///< the tag of its column

   HLS_INLINE RowOrder() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (!kIsFixed) visit("last", last);
      visit("address", address);
      visit("falls", falls);
      visit("inside", inside);
      visit("complete", complete);
      visit("output", output);
      visit("first", first);
      visit("held_output", held_output);
      visit("turned", turned);
   }

   /// A row that breaks off leaves words of two rows: it counts as none. Bits meet with &, which is a gate; of && the
   /// compiler makes branches that take all that follows along, and the loop of a large core then has two states.
   template <class Size>
   HLS_INLINE void clock(const PixelTag& in, const Size& size) {
      const bool comes = in.valid & in.map_column;
      const bool starts = comes & !inside;
      const bool turns_output = complete & output;
      const bool now_output = select<bool>(starts, turns_output, held_output);
      turned.valid = in.valid;
      turned.map_column = in.map_column;
      turned.output_column = in.map_column & now_output;
      turned.first_column = starts;
      turned.start_of_frame = starts & turns_output & first;
      turned.end_of_line = in.end_of_line;

      const uint16_t beside = select<uint16_t>(falls, uint16_t(address - 1), uint16_t(address + 1));
      const uint16_t end = select<uint16_t>(falls, 0, uint16_t(last.get()));
      const uint16_t next = select<uint16_t>(starts, end, beside);
      address = at_most<Width - 1>(select<uint16_t>(comes, next, address));
      falls = falls != starts;
      held_output = now_output;
      output = select<bool>(starts, in.output_column, output);
      first = select<bool>(starts, in.start_of_frame, first);
      complete = select<bool>(comes, in.end_of_line, complete);
      inside = select<bool>(in.valid, in.map_column, inside);
      last.clock(size);
   }
};

}  // namespace stereo::semi_global
