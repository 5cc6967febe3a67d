// SPDX-License-Identifier: Apache-2.0
// The settings of semi-global matching that come from ports, where a configuration has run_time_settings.
#pragma once

#include "semi_global/config.hpp"
#include "support/settings.hpp"

namespace stereo::semi_global {

/// The largest penalties are the configuration's, so that no path needs more bits.
#define STEREO_SETTINGS_semi_global(SETTING)                                                           \
   SETTING(uint16_t, p1, Clamped, true, C.least_p1(), C.p1, C.p1)                                      \
   SETTING(uint16_t, p2, Clamped, true, 0, C.p2, C.p2)                                                 \
   SETTING(uint16_t, uniqueness_distance, Masked, C.has_uniqueness_check(), 0, C.largest_uniqueness(), \
           C.uniqueness_distance)                                                                      \
   STEREO_CHECKED_AND_SEARCHED(SETTING)

STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_semi_global);

template <const Config& C>
using FirstPenalty = NumberHere<C.run_time_settings, C.p1>;
template <const Config& C>
using SecondPenalty = NumberHere<C.run_time_settings, C.p2>;

}  // namespace stereo::semi_global
