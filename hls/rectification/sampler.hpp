// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rectification/tap_place.hpp"
#include "support/pixel_bits.hpp"

namespace stereo::rectification {

/// Keeps the last rows of one camera and makes each pixel that leaves of four of theirs. 10 clocks.
/// Memory: buffered columns x rows x pixel_bits.
template <const Config& C>
struct Sampler {
   using Rows = QuadMemory<Pixel<C>, C.buffered_columns(), C.buffered_rows()>;
   using Between = Bilinear<C.pixel_bits, C.weight_bits, 2 * C.weight_bits>;
   static constexpr int kClocks = Rows::kClocks + Between::kClocks;
   static constexpr int kMemories = Rows::kMemories;

   Rows rows;
   // Beside the rows.
   ClockDelay<uint8_t, Rows::kClocks> weight_x, weight_y;
   ClockDelay<uint8_t, Rows::kClocks> shown;  ///< bit 2r + c: the tap in row r and column c of the four
   Between pixel;

   template <class Source, int First>
   HLS_INLINE Sampler(Source& memories, MemoryId<First> first) : rows(memories, first) {}

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("rows", rows);
      visit("weight_x", weight_x);
      visit("weight_y", weight_y);
      visit("shown", shown);
      visit("pixel", pixel);
   }

   /// newest: the pixel that is kept.
   HLS_INLINE void clock(const TapPlace<C>& place, const SamplePlace<C>& sample, Pixel<C> newest) {
      Pixel<C> ready[2][2];
      rows.taps(ready);
      int32_t taps[2][2];
      uint8_t shown_next = 0;
      HLS_UNROLL
      for (int r = 0; r < 2; ++r) {
         HLS_UNROLL
         for (int c = 0; c < 2; ++c) {
            const int bit = 2 * r + c;
            taps[r][c] = select<int32_t>((shown.oldest() >> bit & 1) != 0, ready[r][c], 0);
            shown_next |= uint8_t(uint8_t(place.row_shown[r] && place.column_shown[c]) << bit);
         }
      }
      shown.clock(shown_next);
      pixel.clock(taps, weight_x.oldest(), weight_y.oldest());
      weight_x.clock(place.weight_x);
      weight_y.clock(place.weight_y);
      rows.clock(place.taps, sample.kept_pixels.valid, sample.kept, newest);
   }
};

}  // namespace stereo::rectification
