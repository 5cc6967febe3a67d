// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "support/registers.hpp"

namespace stereo {

/// What a RasterCounter is compared with where all frames have one size.
template <int Width, int Groups, int Delay>
struct FixedRaster {
   static constexpr bool kFixed = true;
   static constexpr int last_column = Width - 1;
   static constexpr int last_group = Groups - 1;
   static constexpr int groups = Groups;
   static constexpr int last_counted = Groups + Delay - 1;
   static constexpr int idle = Groups + Delay;
};

/// The same in registers, for frames of up to `Width` columns and `Groups` groups of rows. After a reset they are those
/// of the largest frame.
template <int Width, int Groups, int Delay>
struct RunTimeRaster {
   static constexpr bool kFixed = false;
   uint16_t last_column;   ///< of a row
   uint16_t last_group;    ///< of the image's rows
   uint16_t groups;        ///< of the image's rows
   uint16_t last_counted;  ///< the last group that the windows see
   uint16_t idle;          ///< behind it

   HLS_INLINE RunTimeRaster() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("last_column", last_column, Width - 1);
      visit("last_group", last_group, Groups - 1);
      visit("groups", groups, Groups);
      visit("last_counted", last_counted, Groups + Delay - 1);
      visit("idle", idle, Groups + Delay);
   }

   HLS_INLINE void clock(uint16_t width, uint16_t row_groups) {
      last_column = at_most<Width - 1>(width - 1u);
      last_group = at_most<Groups - 1>(row_groups - 1u);
      groups = at_most<Groups>(row_groups);
      last_counted = at_most<Groups + Delay - 1>(row_groups + (Delay - 1u));
      idle = at_most<Groups + Delay>(row_groups + unsigned(Delay));
   }
};

/// Counts columns and groups of rows of a stream of `Width` columns and `Groups` groups of rows a frame, or of fewer:
/// then the limits are a RunTimeRaster, which may change only while no frame is being counted.
///
/// Windows around a group of rows need rows below it, so the last groups of a frame leave while `Delay` further ones
/// come in. Those are either anything without start of frame ("flush groups"), or simply the first rows of the next
/// frame. In the second case a frame costs Width*Groups clocks and not one more. `group` counts what the windows see: 0
/// ... Groups-1 are groups of image rows, then come the groups after them, whoever sends them, and the last value is
/// idle. Without `Joins` a frame that starts among those groups takes them away from the one before.
template <int Width, int Groups, int Delay, bool Joins>
struct RasterCounter {
   static constexpr int kIdle = Groups + Delay;
   using Fixed = FixedRaster<Width, Groups, Delay>;

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

   template <class Limits = Fixed>
   HLS_INLINE void clock(bool valid, bool start_of_frame, const Limits& limits = Limits()) {
      const bool last_column = column == limits.last_column;
      const uint16_t column_after = select<uint16_t>(last_column, 0, column + 1);
      bool group_ends = last_column && group != limits.idle;
      if constexpr (!Limits::kFixed) group_ends = last_column & (group < limits.idle);  // idle after a reset is kIdle
      const bool frame_joins = next_frame && group == limits.last_counted;
      const uint16_t group_below = select<uint16_t>(frame_joins, Delay, group + 1);
      const uint16_t group_after = select<uint16_t>(group_ends, group_below, group);
      const bool next_frame_after = next_frame && !(group_ends && frame_joins);

      const bool starts = valid && start_of_frame;
      const bool back_to_back = Joins && Delay > 0 && last_column && group == limits.last_group;
      const uint16_t first_group = select<uint16_t>(back_to_back, limits.groups, 0);
      column = at_most<Width - 1>(select<uint16_t>(starts, 0, select<uint16_t>(valid, column_after, column)));
      group = at_most<kIdle>(select<uint16_t>(starts, first_group, select<uint16_t>(valid, group_after, group)));
      next_frame = select<bool>(starts, back_to_back, select<bool>(valid, next_frame_after, next_frame));
   }
};

/// The same for groups that come three clocks apart or more, of frames that all have one size: it compares before the
/// next group is there, which then only chooses.
template <int Width, int Groups, int Delay, bool Joins>
struct EarlyRasterCounter {
   static_assert(Width > 1);
   static constexpr int kIdle = Groups + Delay;
   using Fixed = FixedRaster<Width, Groups, Delay>;

   uint16_t column, group;  ///< as in RasterCounter, and as soon
   bool next_frame;
   // Of this place, a clock later.
   bool last_column;
   bool counts;        ///< the group is not idle
   bool frame_joins;   ///< behind it come groups that the next frame's windows see too
   bool back_to_back;  ///< a frame that starts behind it joins the one that ends
   // The place of a group behind it that starts no frame, two clocks later.
   uint16_t column_after, group_after;
   bool next_frame_after;

   HLS_INLINE EarlyRasterCounter() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("column", column);
      visit("group", group, kIdle);
      visit("next_frame", next_frame);
      visit("last_column", last_column);
      visit("counts", counts);
      visit("frame_joins", frame_joins);
      visit("back_to_back", back_to_back);
      visit("column_after", column_after, 1);
      visit("group_after", group_after, kIdle);
      visit("next_frame_after", next_frame_after);
   }

   template <class Limits = Fixed>
   HLS_INLINE void clock(bool valid, bool start_of_frame, const Limits& limits = Limits()) {
      static_assert(Limits::kFixed);
      const uint16_t column_now = column, group_now = group;
      const bool next_frame_now = next_frame;
      const bool starts = valid & start_of_frame;
      const uint16_t first_group = select<uint16_t>(back_to_back, limits.groups, 0);
      column = at_most<Width - 1>(select<uint16_t>(starts, 0, select<uint16_t>(valid, column_after, column_now)));
      group = at_most<kIdle>(select<uint16_t>(starts, first_group, select<uint16_t>(valid, group_after, group_now)));
      next_frame = select<bool>(starts, back_to_back, select<bool>(valid, next_frame_after, next_frame_now));

      const bool group_ends = last_column & counts;
      const uint16_t group_below = select<uint16_t>(frame_joins, Delay, group_now + 1);
      column_after = at_most<Width - 1>(select<uint16_t>(last_column, 0, column_now + 1));
      group_after = at_most<kIdle>(select<uint16_t>(group_ends, group_below, group_now));
      next_frame_after = next_frame_now & !(group_ends & frame_joins);

      last_column = column_now == limits.last_column;
      counts = group_now != limits.idle;
      frame_joins = next_frame_now & (group_now == limits.last_counted);
      back_to_back = Joins & (Delay > 0) & (column_now == limits.last_column) & (group_now == limits.last_group);
   }
};

/// The one of a core with so many front clocks.
template <int FrontClocks, int Width, int Groups, int Delay, bool Joins>
using FrontCounter = std::conditional_t<(FrontClocks > 1), EarlyRasterCounter<Width, Groups, Delay, Joins>,
                                        RasterCounter<Width, Groups, Delay, Joins>>;

}  // namespace stereo
