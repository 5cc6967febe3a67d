// SPDX-License-Identifier: Apache-2.0
// The settings of the trellis that come from ports, where a configuration has run_time_settings.
#pragma once

#include "support/settings.hpp"
#include "trellis/config.hpp"

namespace stereo::trellis {

/// The largest costs are the configuration's, so that no path needs more bits.
#define STEREO_SETTINGS_trellis(SETTING)                                                  \
   SETTING(uint8_t, drop_cost, Clamped, true, 0, C.drop_cost, C.drop_cost)                \
   SETTING(uint8_t, occlusion_cost, Clamped, true, 1, C.occlusion_cost, C.occlusion_cost) \
   STEREO_SUPPORT_THRESHOLD(SETTING)

STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_trellis);

}  // namespace stereo::trellis
