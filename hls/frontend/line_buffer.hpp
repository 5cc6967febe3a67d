// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/pair_delay.hpp"
#include "support/row_buffer.hpp"

namespace stereo {

/// Turns the stream into columns of all rows whose pixels are compared, of both images. 3 clocks. Memory: two times
/// W x stored_rows x feature bits.
template <const auto& C>
struct LineBuffer {
   static constexpr int kClocks = 3;
   /// Groups by which the windows lag behind the newest rows.
   static constexpr int kLagGroups = C.delay_groups() * C.width_px;
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   using Rows = RowBuffer<C.feature_bits(), kPixels, C.stored_rows(), C.width_px>;
   static constexpr int kMemories = 2 * Rows::kMemories;

   Rows search_rows;
   Rows reference_rows;

   static constexpr bool kSplitsRows = PairDelay<C>::kSplitsRows;

   struct Place {
      uint16_t column;
      bool inside[kTaps];
      PixelTag tag;
      [[no_unique_address]] std::conditional_t<kSplitsRows, SearchInside<kTaps>, NoSplitRows> search;

      HLS_INLINE Place() { start(*this); }

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("inside", inside);
         visit("tag", tag);
         if constexpr (kSplitsRows) visit("search", search);
      }
   };
   Place read;   // clock 1
   Place ready;  // clock 2
   uint16_t write_column;
   // clock 3
   /// [t]: top row first; 0 in both images where the row is outside the frame, so that their cost is 0. Where signs are
   /// remembered, the newest rows come as they are: they may be the first ones of the next frame, whose signs count.
   Feature<C> search[kTaps], reference[kTaps];
   bool inside[kTaps];
   PixelTag tag;

   template <class Source, int First>
   HLS_INLINE LineBuffer(Source& memories, MemoryId<First> first)
       : search_rows(memories, first), reference_rows(memories, MemoryId<First + Rows::kMemories>()) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("search_rows", search_rows);
      visit("reference_rows", reference_rows);
      visit("read", read);
      visit("ready", ready);
      visit("write_column", write_column);
      visit("search", search);
      visit("reference", reference);
      visit("inside", inside);
      visit("tag", tag);
   }

   HLS_INLINE void clock(const PairDelay<C>& in) {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         const bool shown = ready.inside[t] || (C.remembers_signs() && t >= kTaps - kPixels);
         bool search_shown = shown;
         if constexpr (kSplitsRows)
            search_shown = ready.search.inside[t] || (C.remembers_signs() && t >= kTaps - kPixels);
         search[t] = select<Feature<C>>(search_shown, search_rows.row(C.tap_row(t)), 0);
         reference[t] = select<Feature<C>>(shown, reference_rows.row(C.tap_row(t)), 0);
         inside[t] = ready.inside[t];
      }
      tag = ready.tag;
      Feature<C> newest_search[kPixels], newest_reference[kPixels];
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         newest_search[p] = in.search(p);
         newest_reference[p] = in.reference(p);
      }
      search_rows.clock(newest_search, in.column, ready.tag.valid, write_column);
      reference_rows.clock(newest_reference, in.column, ready.tag.valid, write_column);
      write_column = select<uint16_t>(ready.tag.valid, ready.column, write_column);

      ready.column = read.column;
      ready.tag = read.tag;
      read.column = in.column;
      read.tag = in.tag;
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         ready.inside[t] = read.inside[t];
         read.inside[t] = in.row_inside[t];
         if constexpr (kSplitsRows) {
            ready.search.inside[t] = read.search.inside[t];
            read.search.inside[t] = in.split.search_inside[t];
         }
      }
   }
};

}  // namespace stereo
