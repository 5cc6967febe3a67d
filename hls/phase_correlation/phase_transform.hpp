// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "phase_correlation/phase_code.hpp"
#include "support/raster_counter.hpp"
#include "support/row_buffer.hpp"

namespace stereo::phase_correlation {

/// Replaces the pixels of both images by their phase codes. The codes come out transform_groups() rows and
/// transform_columns() columns later. Memory: two times W x pixel bits x kStored.
template <const auto& C>
struct PhaseTransform {
   static constexpr int kStored = C.largest_reach().above + C.largest_reach().below;
   static constexpr int kRows = kStored + 1;
   using Rows = RowBuffer<kPixelBits<C>, 1, kStored, C.width_px>;
   using Code = PhaseCode<C>;
   using Counter = RasterCounter<C.width_px, C.row_groups(), C.transform_groups(), true>;
   /// Input 1, row buffers, whole columns 1, filters.
   static constexpr int kClocks = 1 + Rows::kClocks + 1 + Code::kClocks;
   static constexpr int kLagGroups = C.transform_groups() * C.width_px + C.transform_columns();
   static constexpr int kMemories = 2 * Rows::kMemories;

   /// What travels beside the rows, while they become columns.
   struct Start {
      bool start_of_frame;  ///< the centre is the first of a frame
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("start_of_frame", start_of_frame);
         visit("valid", valid);
      }
   };
   /// What travels beside the whole columns.
   struct Tag {
      bool inside[C.scales];  ///< [scale]: its filters around the centre lie in the image
      bool start_of_frame;    ///< the centre is the first of a frame
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("inside", inside);
         visit("start_of_frame", start_of_frame);
         visit("valid", valid);
      }
   };

   Pixel<C> left[1], right[1];  // clock 1
   bool valid;
   Counter counter;
   Rows left_rows, right_rows;  // clocks 2 and 3
   Start read, ready;
   uint16_t read_column, ready_column, write_column;
   typename OfWidth<C, C.width_px - C.transform_columns()>::Type columns_up;  ///< from a column to the centre above it
   uint16_t centre_column, centre_group;                                      // clock 2: which pixel is the centre
   bool from_first[C.scales], up_to_last[C.scales];   // clock 3: [scale]: within two sides of the image each
   Pixel<C> left_column[kRows], right_column[kRows];  // clock 4
   Tag columns;
   Code left_code, right_code;    // from clock 5 on
   Tag filtering[Code::kClocks];  ///< [j]: beside what the filters make in their clock j

   template <class Source, int First>
   HLS_INLINE PhaseTransform(Source& memories, MemoryId<First> first)
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
      visit("read_column", read_column);
      visit("ready", ready);
      visit("ready_column", ready_column);
      visit("write_column", write_column);
      if constexpr (kRunTimeSize<C>) visit("columns_up", columns_up);
      visit("centre_column", centre_column);
      visit("centre_group", centre_group);
      visit("from_first", from_first);
      visit("up_to_last", up_to_last);
      visit("left_column", left_column);
      visit("right_column", right_column);
      visit("columns", columns);
      visit("left_code", left_code);
      visit("right_code", right_code);
      visit("filtering", filtering);
   }

   HLS_INLINE FeatureGroup<C> output() const {
      FeatureGroup<C> out;
      const Code& search = C.reference == Reference::right ? left_code : right_code;
      const Code& reference = C.reference == Reference::right ? right_code : left_code;
      out.search[0] = search.code();
      out.reference[0] = reference.code();
      out.start_of_frame = filtering[Code::kClocks - 1].start_of_frame;
      out.valid = filtering[Code::kClocks - 1].valid;
      return out;
   }

   template <class Size = FixedSize<C>>
   HLS_INLINE void clock(const CoreInput<C>& in, const Size& size = Size()) {
      left_code.clock(left_column, filtering);
      right_code.clock(right_column, filtering);
      HLS_UNROLL
      for (int j = Code::kClocks - 1; j > 0; --j) copy(filtering[j], filtering[j - 1]);
      copy(filtering[0], columns);
      HLS_UNROLL
      for (int row = 0; row < kRows; ++row) {
         left_column[row] = left_rows.row(row);
         right_column[row] = right_rows.row(row);
      }
      find_inside();
      left_rows.clock(left, counter.column, ready.valid, write_column);
      right_rows.clock(right, counter.column, ready.valid, write_column);
      write_column = select<uint16_t>(ready.valid, ready_column, write_column);
      find_sides<0>(size);
      ready = read;
      ready_column = read_column;
      find_centre();
      columns_up.clock(size);
      counter.clock(in.valid, in.start_of_frame, size.transform);
      valid = in.valid;
      left[0] = in.left[0];
      right[0] = in.right[0];
   }

  private:
   static constexpr int kLagRows = C.transform_groups();
   static constexpr int kLagColumns = C.transform_columns();

   // Three clocks find out which filters lie in the image. Of two bounds of one number in one clock the front end may
   // make a subtraction modulo 2^32, which the lowering refuses.

   /// The columns after the centre may be the first ones of the next row: then the centre stands in the row before.
   /// centre_group counts from 1, so that it is never below 0.
   HLS_INLINE void find_centre() {
      const bool same_row = counter.column >= kLagColumns;
      centre_column = at_most<C.width_px - 1>(
          select<uint16_t>(same_row, counter.column - kLagColumns, counter.column + columns_up.get()));
      centre_group = select<uint16_t>(same_row, counter.group + 1, counter.group);
      read.start_of_frame = (counter.group == kLagRows) & (counter.column == kLagColumns);
      read.valid = valid;
      read_column = counter.column;
   }

   /// Of scales K, K+1, ... Recursion: each scale has its own numbers. Without &&, which would be a branch.
   template <int K, class Size>
   HLS_INLINE void find_sides(const Size& size) {
      constexpr FilterReach kReach = C.reach(K);
      constexpr int kFirstGroup = kLagRows + 1;
      from_first[K] = (centre_column >= kReach.before) & (centre_group >= kFirstGroup + kReach.above);
      constexpr int kLastGroup = kFirstGroup + C.height_px - 1 - kReach.below;
      if constexpr (Size::kFixed)
         up_to_last[K] = (centre_column <= C.width_px - 1 - kReach.after) & (centre_group <= kLastGroup);
      else
         up_to_last[K] = (centre_column + kReach.after <= size.transform.last_column) &
                         is_until<C>(centre_group, kLastGroup, size.transform);
      if constexpr (K + 1 < C.scales) find_sides<K + 1>(size);
   }

   HLS_INLINE void find_inside() {
      HLS_UNROLL
      for (int k = 0; k < C.scales; ++k) columns.inside[k] = from_first[k] & up_to_last[k];
      columns.start_of_frame = ready.start_of_frame;
      columns.valid = ready.valid;
   }

   static HLS_INLINE void copy(Tag& to, const Tag& from) {
      HLS_UNROLL
      for (int k = 0; k < C.scales; ++k) to.inside[k] = from.inside[k];
      to.start_of_frame = from.start_of_frame;
      to.valid = from.valid;
   }
};

}  // namespace stereo::phase_correlation
