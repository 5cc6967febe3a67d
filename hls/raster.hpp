// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hls_support.hpp"
#include "stereo_config.hpp"
#include "stream.hpp"

namespace stereo {

/// Counts columns and groups of rows of the incoming stream. 1 clock.
///
/// The windows around a group of rows need rows below it, so the last groups of a frame leave while further ones come
/// in. Those are either anything without start of frame ("flush groups"), or simply the first rows of the next frame.
/// In the second case a frame costs W*H/P clocks and not one more. `group` counts what the windows see: 0 ... H/P-1 are
/// groups of image rows, then come the groups after them, whoever sends them, and the last value is idle.
template <const StereoConfig& C>
struct Raster {
   static constexpr int kPixels = C.pixels_per_clock;
   static constexpr int kGroups = C.row_groups();
   static constexpr int kIdle = kGroups + C.delay_groups();

   uint8_t left[kPixels];
   uint_of_bits<8 * kPixels> right = 0;  ///< bits 8p+7 ... 8p hold row p of the group
   bool valid = false;
   uint16_t column = 0;      ///< 0 ... W-1
   uint16_t group = kIdle;   ///< 0 ... kIdle
   bool next_frame = false;  ///< the groups after the image's are the first ones of the next frame

   HLS_INLINE Raster() { fill<uint8_t>(left, 0); }

   HLS_INLINE void clock(const StereoInput& in) {
      const bool last_column = column == C.width_px - 1;
      const uint16_t column_after = select<uint16_t>(last_column, 0, column + 1);
      const bool group_ends = last_column && group != kIdle;
      const bool frame_joins = next_frame && group == kIdle - 1;
      const uint16_t group_below = select<uint16_t>(frame_joins, C.delay_groups(), group + 1);
      const uint16_t group_after = select<uint16_t>(group_ends, group_below, group);
      const bool next_frame_after = next_frame && !(group_ends && frame_joins);

      const bool starts = in.valid && in.start_of_frame;
      const bool back_to_back = last_column && group == kGroups - 1;
      const uint16_t first_group = select<uint16_t>(back_to_back, kGroups, 0);
      column = at_most<C.width_px - 1>(select<uint16_t>(starts, 0, select<uint16_t>(in.valid, column_after, column)));
      group = at_most<kIdle>(select<uint16_t>(starts, first_group, select<uint16_t>(in.valid, group_after, group)));
      next_frame = select<bool>(starts, back_to_back, select<bool>(in.valid, next_frame_after, next_frame));
      uint_of_bits<8 * kPixels> word = 0;
      HLS_UNROLL
      for (int p = 0; p < kPixels; ++p) {
         left[p] = in.left[p];
         word |= uint_of_bits<8 * kPixels>(uint_of_bits<8 * kPixels>(in.right[p]) << (8 * p));
      }
      right = word;
      valid = in.valid;
   }
};

}  // namespace stereo
