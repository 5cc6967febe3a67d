// SPDX-License-Identifier: Apache-2.0
// The settings of semi-global matching that come from ports, where a configuration has run_time_settings.
#pragma once

#include "semi_global/config.hpp"
#include "support/settings.hpp"

namespace stereo::semi_global {

/// Penalties, thresholds and what is searched, as those of block matching.
#define STEREO_SETTINGS_semi_global(PORT) \
   PORT(uint16_t, p1)                     \
   PORT(uint16_t, p2)                     \
   PORT(uint16_t, uniqueness_distance)    \
   PORT(uint8_t, left_right_threshold)    \
   PORT(uint8_t, first_disparity)         \
   PORT(uint8_t, last_disparity)

/// What the ports bring. A frame is matched with those of its start of frame.
STEREO_SETTINGS_STRUCT(Settings, STEREO_SETTINGS_semi_global);

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
      p1 = select<uint16_t>(starts, limited<C.least_p1(), C.p1>(now.p1), p1);
      p2 = select<uint16_t>(starts, limited<0, C.p2>(now.p2), p2);
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

template <const Config& C>
using FirstPenalty = NumberHere<C.run_time_settings, C.p1>;
template <const Config& C>
using SecondPenalty = NumberHere<C.run_time_settings, C.p2>;

}  // namespace stereo::semi_global
