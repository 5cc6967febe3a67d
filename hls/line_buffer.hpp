// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pair_delay.hpp"
#include "row_buffer.hpp"

namespace stereo {

/// Turns the stream into columns of all rows whose pixels are compared, of both images. 3 clocks. Memory: two times
/// W x stored_rows x feature bits.
template <const StereoConfig& C>
struct LineBuffer {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kTaps = C.tap_rows();
   template <int Number>
   using Rows = RowBuffer<C.feature_bits(), kPixels, C.stored_rows(), C.width_px, Number>;

   Rows<memory_numbers::kSearchRows> search_rows;
   Rows<memory_numbers::kReferenceRows> reference_rows;

   struct Place {
      uint16_t column = 0;
      bool inside[kTaps];
      PixelTag tag;

      HLS_INLINE Place() { fill(inside, false); }
   };
   Place read;   // clock 1
   Place ready;  // clock 2
   uint16_t write_column = 0;
   // clock 3
   Feature<C> search[kTaps], reference[kTaps];  ///< [t]: top row first; 0 in both images where the row is outside the
                                                ///< frame, so that their cost is 0
   bool inside[kTaps];
   PixelTag tag;

   template <class Source>
   HLS_INLINE explicit LineBuffer(Source& memories) : search_rows(memories), reference_rows(memories) {
      fill<Feature<C>>(search, 0);
      fill<Feature<C>>(reference, 0);
      fill(inside, false);
   }

   HLS_INLINE void clock(const PairDelay<C>& in) {
      HLS_UNROLL
      for (int t = 0; t < kTaps; ++t) {
         search[t] = select<Feature<C>>(ready.inside[t], search_rows.row(C.tap_row(t)), 0);
         reference[t] = select<Feature<C>>(ready.inside[t], reference_rows.row(C.tap_row(t)), 0);
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
      }
   }
};

}  // namespace stereo
