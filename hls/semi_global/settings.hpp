// SPDX-License-Identifier: Apache-2.0
// The settings of semi-global matching that come from ports, where a configuration has run_time_settings.
#pragma once

#include "semi_global/config.hpp"
#include "support/settings.hpp"

namespace stereo::semi_global {

/// What the ports bring. A frame is matched with those of its start of frame.
struct Settings {
   uint16_t p1 = 0;
   uint16_t p2 = 0;
   uint16_t uniqueness_distance = 0;
   uint8_t left_right_threshold = 0;  ///< D-1 lets every disparity pass
   uint8_t first_disparity = 0;       ///< with full_width: those below it are not searched
   uint8_t last_disparity = 0;        ///< nor those above it

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("p1", p1);
      visit("p2", p2);
      visit("uniqueness_distance", uniqueness_distance);
      visit("left_right_threshold", left_right_threshold);
      visit("first_disparity", first_disparity);
      visit("last_disparity", last_disparity);
   }
};

/// Keeps the settings of the frame that comes in. Each path and each check takes them over when the frame's first
/// column reaches it. Config::problem() says which images are too low for that.
template <const Config& C>
struct FrameSettings {
   uint16_t p1;
   uint16_t p2;
   uint16_t uniqueness_distance;
   uint8_t left_right_threshold;
   uint8_t first_disparity, last_disparity;

   HLS_INLINE FrameSettings() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("p1", p1, C.p1);
      visit("p2", p2, C.p2);
      if constexpr (C.has_uniqueness_check()) visit("uniqueness_distance", uniqueness_distance, C.uniqueness_distance);
      if constexpr (C.has_left_right_check())
         visit("left_right_threshold", left_right_threshold, C.left_right_threshold);
      if constexpr (C.full_width) {
         visit("first_disparity", first_disparity, C.first_disparity);
         visit("last_disparity", last_disparity, C.windows().last_searched());
      }
   }

   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      const bool starts = in.valid & in.start_of_frame;
      p1 = select<uint16_t>(starts, at_most<C.largest_p1()>(now.p1), p1);
      p2 = select<uint16_t>(starts, at_most<C.largest_p2()>(now.p2), p2);
      if constexpr (C.has_uniqueness_check())
         uniqueness_distance =
             select<uint16_t>(starts, at_most<C.largest_uniqueness()>(now.uniqueness_distance), uniqueness_distance);
      if constexpr (C.has_left_right_check())
         left_right_threshold = select<uint8_t>(starts, now.left_right_threshold, left_right_threshold);
      if constexpr (C.full_width) {
         first_disparity = select<uint8_t>(starts, now.first_disparity, first_disparity);
         last_disparity = select<uint8_t>(starts, now.last_disparity, last_disparity);
      }
   }
};

/// A penalty where a path needs it: the configuration's number, or a register that takes over the frame's.
template <bool IsSet, int Start>
struct PenaltyHere {
   HLS_INLINE int get() const { return Start; }
   HLS_INLINE void take(bool, int) {}
};
template <int Start>
struct PenaltyHere<true, Start> {
   uint16_t value;

   HLS_INLINE int get() const { return value; }
   HLS_INLINE void take(bool now, uint16_t taken) { value = select<uint16_t>(now, taken, value); }
};
template <const Config& C>
using FirstPenalty = PenaltyHere<C.run_time_settings, C.p1>;
template <const Config& C>
using SecondPenalty = PenaltyHere<C.run_time_settings, C.p2>;

}  // namespace stereo::semi_global
