// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/census.hpp"
#include "frontend/features.hpp"
#include "frontend/image_size.hpp"
#include "frontend/xsobel.hpp"
#include "support/raster_counter.hpp"
#include "support/row_buffer.hpp"
#include "support/structure_groups.hpp"

namespace stereo {

/// Replaces the pixels of both images by what is compared: filtered pixels (7 clocks) or census transforms (6 clocks, 7
/// with two front clocks).
/// The groups come out transform_groups() rows and transform_columns() columns later. Memory: two times W x pixel bits
/// x kStored.
template <const auto& C>
struct Transform {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kAround = C.transform_rows();
   static constexpr int kColumns = C.transform_columns();
   static constexpr int kRows = kPixels + 2 * kAround;
   static constexpr int kStored = C.transform_groups() * kPixels + kAround;
   using Rows = RowBuffer<kPixelBits<C>, kPixels, kStored, C.width_px>;
   using Filter = std::conditional_t<C.cost == Cost::census, Census<C>, XSobel<C>>;
   using Counter = FrontCounter<kFrontClocks<C>, C.width_px, C.row_groups(), C.transform_groups(), true>;
   /// Input 1, row buffers 2, whole columns 1, filter.
   static constexpr int kClocks = 1 + Rows::kClocks + 1 + Filter::kClocks;
   /// Groups by which the transforms lag behind the newest pixels.
   static constexpr int kLagGroups = C.transform_groups() * C.width_px + C.transform_columns();
   static constexpr int kMemories = 2 * Rows::kMemories;

   /// What travels beside the pixels.
   struct Place {
      uint16_t column;
      bool row_inside[kRows];                ///< [r]: the row is one of the image
      bool column_inside[2 * kColumns + 1];  ///< [age]: the column is of the same row as the centre's, kColumns old
      bool start_of_frame;                   ///< the centre is the first of a frame
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("row_inside", row_inside);
         visit("column_inside", column_inside);
         visit("start_of_frame", start_of_frame);
         visit("valid", valid);
      }
   };

   /// With two front clocks the counter's group is compared in clock 2, and clock 3 knows which rows are inside.
   static constexpr bool kComparesFirst = kFrontClocks<C> > 1;
   struct Reached {
      bool first[kRows], beyond_last[kRows];  ///< [r]: the row has reached them

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("first", first);
         visit("beyond_last", beyond_last);
      }
   };
   struct NothingReached {};

   Pixel<C> left[kPixels], right[kPixels];  // clock 1
   bool valid;
   Counter counter;
   Rows left_rows, right_rows;  // clocks 2 and 3
   Place read, ready;
   [[no_unique_address]] std::conditional_t<kComparesFirst, Reached, NothingReached> reached;
   uint16_t write_column;
   Pixel<C> left_column[kRows], right_column[kRows];  // clock 4
   Place columns;
   Filter left_filter, right_filter;  // from clock 5 on
   Place filtering[Filter::kClocks];  ///< [j]: beside what the filters make in their clock j

   template <class Source, int First>
   HLS_INLINE Transform(Source& memories, MemoryId<First> first)
       : left_rows(memories, first), right_rows(memories, MemoryId<First + Rows::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("left", left);
      visit("right", right);
      visit("valid", valid);
      visit("counter", counter);
      visit("left_rows", left_rows);
      visit("right_rows", right_rows);
      visit("read", read);
      visit("ready", ready);
      if constexpr (kComparesFirst) visit("reached", reached);
      visit("write_column", write_column);
      visit("left_column", left_column);
      visit("right_column", right_column);
      visit("columns", columns);
      visit("left_filter", left_filter);
      visit("right_filter", right_filter);
      visit("filtering", filtering);
   }

   HLS_INLINE FeatureGroup<C> output() const {
      FeatureGroup<C> out;
      const Filter& search = C.reference == Reference::right ? left_filter : right_filter;
      const Filter& reference = C.reference == Reference::right ? right_filter : left_filter;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         out.search[p] = search.feature[p];
         out.reference[p] = reference.feature[p];
      }
      out.start_of_frame = filtering[Filter::kClocks - 1].start_of_frame;
      out.valid = filtering[Filter::kClocks - 1].valid;
      return out;
   }

   template <class Size = FixedSize<C>>
   HLS_INLINE void clock(const CoreInput<C>& in, const Size& size = Size()) {
      HLS_UNROLL
      for (int j = Filter::kClocks - 1; j > 0; --j) copy(filtering[j], filtering[j - 1]);
      left_filter.clock(columns.valid, left_column, columns.row_inside, filtering[0].column_inside);
      right_filter.clock(columns.valid, right_column, columns.row_inside, filtering[0].column_inside);
      copy(filtering[0], columns);
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         left_column[row] = left_rows.row(row);
         right_column[row] = right_rows.row(row);
      }
      copy(columns, ready);
      left_rows.clock(left, counter.column, ready.valid, write_column);
      right_rows.clock(right, counter.column, ready.valid, write_column);
      write_column = select<uint16_t>(ready.valid, ready.column, write_column);
      copy(ready, read);
      find_place(size);
      counter.clock(in.valid, in.start_of_frame, size.transform);
      valid = in.valid;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         left[p] = in.left[p];
         right[p] = in.right[p];
      }
   }

  private:
   /// Row r of the column shows row (group - transform_groups) * P - transform_rows + r of the image.
   static constexpr int first_group(int r) { return (kStored - r + kPixels - 1) / kPixels; }
   static constexpr int last_group(int r) { return (C.height_px - 1 + kStored - r) / kPixels; }

   template <class Size>
   HLS_INLINE void find_place(const Size& size) {
      read.valid = valid;
      read.column = counter.column;
      HLS_UNROLL
      for (int r = 0; r < kRows; ++r) find_row(r, size);
      HLS_UNROLL
      for (int age = 0; age <= 2 * kColumns; ++age)
         read.column_inside[age] = (counter.column >= age) == (counter.column >= kColumns);
      read.start_of_frame = counter.group == C.transform_groups() && counter.column == kColumns;
   }

   template <class Size>
   HLS_INLINE void find_row(int r, const Size& size) {
      if constexpr (kComparesFirst) {
         static_assert(Size::kFixed);
         ready.row_inside[r] = reached.first[r] & !reached.beyond_last[r];
         reached.first[r] = counter.group >= first_group(r);
         reached.beyond_last[r] = counter.group > last_group(r);
      } else if constexpr (Size::kFixed) {
         read.row_inside[r] = counter.group >= first_group(r) && counter.group <= last_group(r);
      } else {
         read.row_inside[r] =
             (counter.group >= first_group(r)) & is_until<C>(counter.group, last_group(r), size.transform);
      }
   }

   static HLS_INLINE void copy(Place& to, const Place& from) {
      to.column = from.column;
      HLS_UNROLL
      for (int r = 0; r < kRows; ++r) to.row_inside[r] = from.row_inside[r];
      HLS_UNROLL
      for (int age = 0; age <= 2 * kColumns; ++age) to.column_inside[age] = from.column_inside[age];
      to.start_of_frame = from.start_of_frame;
      to.valid = from.valid;
   }
};

}  // namespace stereo
