// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/registers.hpp"

namespace stereo {

/// Counts columns and groups of rows of a stream of `Width` columns and `Groups` groups of rows a frame.
///
/// Windows around a group of rows need rows below it, so the last groups of a frame leave while `Delay` further ones
/// come in. Those are either anything without start of frame ("flush groups"), or simply the first rows of the next
/// frame. In the second case a frame costs Width*Groups clocks and not one more. `group` counts what the windows see: 0
/// ... Groups-1 are groups of image rows, then come the groups after them, whoever sends them, and the last value is
/// idle. Without `Joins` a frame that starts among those groups takes them away from the one before.
template <int Width, int Groups, int Delay, bool Joins>
struct RasterCounter {
   static constexpr int kIdle = Groups + Delay;

   uint16_t column;  ///< 0 ... Width-1
   uint16_t group;   ///< 0 ... kIdle
   bool next_frame;  ///< the groups after the image's are the first ones of the next frame

   HLS_INLINE RasterCounter() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("group", group, kIdle);
      visit("next_frame", next_frame);
   }

   HLS_INLINE void clock(bool valid, bool start_of_frame) {
      const bool last_column = column == Width - 1;
      const uint16_t column_after = select<uint16_t>(last_column, 0, column + 1);
      const bool group_ends = last_column && group != kIdle;
      const bool frame_joins = next_frame && group == kIdle - 1;
      const uint16_t group_below = select<uint16_t>(frame_joins, Delay, group + 1);
      const uint16_t group_after = select<uint16_t>(group_ends, group_below, group);
      const bool next_frame_after = next_frame && !(group_ends && frame_joins);

      const bool starts = valid && start_of_frame;
      const bool back_to_back = Joins && Delay > 0 && last_column && group == Groups - 1;
      const uint16_t first_group = select<uint16_t>(back_to_back, Groups, 0);
      column = at_most<Width - 1>(select<uint16_t>(starts, 0, select<uint16_t>(valid, column_after, column)));
      group = at_most<kIdle>(select<uint16_t>(starts, first_group, select<uint16_t>(valid, group_after, group)));
      next_frame = select<bool>(starts, back_to_back, select<bool>(valid, next_frame_after, next_frame));
   }
};

}  // namespace stereo
