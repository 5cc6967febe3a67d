// SPDX-License-Identifier: Apache-2.0
// The settings of the trellis that come from ports, where a configuration has run_time_settings.
#pragma once

#include "support/settings.hpp"
#include "trellis/config.hpp"

namespace stereo::trellis {

/// What a drop and an occluded pixel cost.
#define STEREO_SETTINGS_trellis(PORT) \
   PORT(uint8_t, drop_cost)           \
   PORT(uint8_t, occlusion_cost)

/// What the ports bring. A frame is matched with those of its start of frame.
STEREO_SETTINGS_STRUCT(Settings, STEREO_SETTINGS_trellis);

/// Keeps the settings of the frame that comes in. The forward pass takes them over when the frame's first column
/// reaches it. Config::problem() says which images are too low for that.
template <const Config& C>
struct FrameSettings {
   uint8_t drop_cost;
   uint8_t occlusion_cost;

   HLS_INLINE FrameSettings() { start(*this); }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("drop_cost", drop_cost, C.drop_cost);
      visit("occlusion_cost", occlusion_cost, C.occlusion_cost);
   }

   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      const bool starts = in.valid & in.start_of_frame;
      drop_cost = select<uint8_t>(starts, uint8_t(limited<0, C.drop_cost>(now.drop_cost)), drop_cost);
      occlusion_cost =
          select<uint8_t>(starts, uint8_t(limited<1, C.occlusion_cost>(now.occlusion_cost)), occlusion_cost);
   }
};

}  // namespace stereo::trellis
