// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/pixel_tag.hpp"
#include "frontend/raster.hpp"
#include "frontend/split_rows.hpp"
#include "support/full_width.hpp"
#include "support/packed.hpp"
#include "support/ring.hpp"

namespace stereo {

/// Holds one of the images back, so that a pixel of the reference meets those that it is compared with, and derives
/// from the place what the later blocks must know. 1 clock. Memory: (delay + 1) x feature bits x P.
template <const auto& C>
struct PairDelay {
   static constexpr int kClocks = 1;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   static constexpr int kDelay = C.reference_delay() + C.search_delay();  ///< one of them is 0
   static constexpr bool kDelaysReference = C.reference_delay() > 0;
   static constexpr bool kSplitsRows = kFullWidth<C> && kDelay > 0;
   using Pack = Packed<C.feature_bits(), kPixels>;
   using Word = typename Pack::Word;

   using Delay = Ring<Word, kDelay + 1, (kDelay > 0 ? Pack::kWords : 0)>;
   static constexpr int kMemories = Delay::kMemories;

   Delay ring;
   Feature<C> ahead[kPixels];   ///< of the image that is not held back
   Word delayed[Pack::kWords];  ///< of the other one
   uint16_t column;             ///< of `ahead`
   bool row_inside[kTaps];      ///< [t]: tap t is a row of the frame whose windows are summed
   PixelTag tag;
   [[no_unique_address]] std::conditional_t<kSplitsRows, SplitRows<kTaps>, NoSplitRows> split;

   template <class Source, int First>
   HLS_INLINE PairDelay(Source& memories, MemoryId<First> first) : ring(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("ring", ring);
      visit("ahead", ahead);
      visit("delayed", delayed);
      visit("column", column);
      visit("row_inside", row_inside);
      visit("tag", tag);
      if constexpr (kSplitsRows) visit("split", split);
   }

   HLS_INLINE Feature<C> search(int p) const { return kDelaysReference ? ahead[p] : Pack::lane(delayed, p); }
   HLS_INLINE Feature<C> reference(int p) const { return kDelaysReference ? Pack::lane(delayed, p) : ahead[p]; }

   template <class Size = FixedSize<C>>
   HLS_INLINE void clock(const Raster<C>& raster, const Size& size = Size()) {
      const auto& in = raster.features;
      if constexpr (kDelay > 0) {
         Word newest[Pack::kWords];
         Pack::pack(kDelaysReference ? in.reference : in.search, newest);
         ring.clock(newest, in.valid, delayed);
      } else {
         Pack::pack(in.search, delayed);
      }
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) ahead[p] = kDelaysReference ? in.search[p] : in.reference[p];
      if constexpr (kFullWidth<C>) {
         tag_full_width(raster, size);
         column = raster.place.column;
      } else {
         column = raster.place.column;
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) row_inside[t] = is_inside(raster.place.group, t, size);
         tag_place(raster, size);
      }
   }

   /// First and last group of a frame in which tap t shows an image row: 0 ... H-1.
   static constexpr int first_group(int t) {
      const int missing = C.stored_rows() - C.tap_row(t);
      return missing <= 0 ? 0 : (missing + kPixels - 1) / kPixels;
   }
   static constexpr int last_group(int t) { return (C.height_px - 1 + C.stored_rows() - C.tap_row(t)) / kPixels; }

  private:
   template <class Size = FixedSize<C>>
   static HLS_INLINE bool is_inside(uint16_t group, int t, const Size& size = Size()) {
      if constexpr (Size::kFixed) return group >= first_group(t) && group <= last_group(t);
      else return (group >= first_group(t)) & is_until<C>(group, last_group(t), size.windows);
   }

   static constexpr int kFirstCost = C.first_cost_column();
   static constexpr int kFirstMap = C.first_map_column();

   template <class Size>
   HLS_INLINE void tag_place(const Raster<C>& raster, const Size& size) {
      const uint16_t column_now = raster.place.column, group = raster.place.group;
      const bool output_group = group >= C.delay_groups() && group < size.windows.idle;
      const int last_map = size.last_map_column;
      tag.valid = raster.features.valid;
      tag.row_start = column_now == 0;
      tag.first_group = group == 0;
      tag.newest_inside = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p)
         tag.newest_inside = uint8_t(tag.newest_inside | uint8_t(is_inside(group, kTaps - kPixels + p, size)) << p);
      tag.border_column = column_now < kFirstCost;
      tag.first_cost = column_now == kFirstCost;
      tag.leaves_window = column_now >= kFirstCost + C.window_px ||
                          (column_now < C.columns_after() && int(column_now) + C.width_px - C.window_px >= kFirstCost);
      tag.map_column = column_now >= kFirstMap && column_now <= last_map;
      tag.output_column = output_group && tag.map_column;
      tag.first_column = column_now == kFirstMap;
      tag.start_of_frame = group == C.delay_groups() && column_now == kFirstMap;
      tag.end_of_line = column_now == last_map;
   }

   /// All that a tag says is of the reference's pixel.
   template <class Size>
   HLS_INLINE void tag_full_width(const Raster<C>& raster, const Size& size) {
      const uint16_t column_now = raster.place.column, group = raster.place.group;
      bool output_group = (group >= C.delay_groups()) & (group < size.windows.idle);
      bool first_group = group == 0, start_group = group == C.delay_groups(), is_whole = true;
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) row_inside[t] = is_inside(group, t, size);
      if constexpr (kSplitsRows) {
         const bool move = raster.features.valid;
         const bool ends = move & (column_now == size.windows.last_column);
         // No row has been broken off.
         const bool goes_on = !move | (column_now != 0) | (column == size.windows.last_column);
         const bool is_before = column_now < kDelay;
         HLS_UNROLL
         for (int t = 0; t < kTaps; ++t) {
            const bool now = row_inside[t];
            const bool held_back = of_row(is_before, ends, goes_on, split.inside_before[t], now);
            row_inside[t] = kDelaysReference ? held_back : now;
            split.search_inside[t] = kDelaysReference ? now : held_back;
         }
         if constexpr (kDelaysReference) {
            output_group = of_row(is_before, ends, goes_on, split.output_before, output_group);
            first_group = of_row(is_before, ends, goes_on, split.first_before, first_group);
            start_group = of_row(is_before, ends, goes_on, split.start_before, start_group);
            is_whole = of_row(is_before, ends, goes_on, split.whole_before, true);
         }
      }
      tag.valid = raster.features.valid;
      tag.row_start = column_now == 0;
      tag.first_group = first_group;
      tag.newest_inside = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p)
         tag.newest_inside = uint8_t(tag.newest_inside | uint8_t(row_inside[kTaps - kPixels + p]) << p);
      tag.border_column = false;
      tag.first_cost = column_now == C.reference_delay();
      tag.leaves_window = size.leaving_columns.has(column_now);
      tag.map_column = size.map_columns.has(column_now) & is_whole;
      tag.output_column = tag.map_column & output_group;
      tag.first_column = (column_now == size.map_columns.from) & is_whole;
      tag.start_of_frame = tag.first_column & start_group;
      tag.end_of_line = (column_now == size.map_columns.to) & is_whole;
   }

   /// What holds for the image that is held back: in its first columns what held for the row before, or nothing. Keeps
   /// what holds now for the next row.
   static HLS_INLINE bool of_row(bool is_before, bool ends, bool goes_on, bool& before, bool now) {
      const bool kept = before & goes_on;
      before = select<bool>(ends, now, kept);
      return select<bool>(is_before, kept, now);
   }
};

}  // namespace stereo
