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
   SETTING(uint16_t, p2_least, Clamped, C.has_relief(), C.p2_least, C.p2, C.p2_least)                  \
   SETTING(uint16_t, above_p1, Clamped, C.has_penalties_above(), 0, C.p1_above(), C.p1_above())        \
   SETTING(uint16_t, above_p2, Clamped, C.has_penalties_above(), 0, C.p2_above(), C.p2_above())        \
   SETTING(uint16_t, uniqueness_distance, Masked, C.has_uniqueness_check(), 0, C.largest_uniqueness(), \
           C.uniqueness_distance)                                                                      \
   STEREO_CHECKED_AND_SEARCHED(SETTING)                                                                \
   STEREO_SUPPORT_THRESHOLD(SETTING)

STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_semi_global);

template <const Config& C>
using FirstPenalty = NumberHere<C.run_time_settings, C.p1>;
template <const Config& C>
using SecondPenalty = NumberHere<C.run_time_settings, C.p2>;
// Of the path from above.
template <const Config& C>
using FirstPenaltyAbove = NumberHere<C.run_time_settings, C.p1_above()>;
template <const Config& C>
using SecondPenaltyAbove = NumberHere<C.run_time_settings, C.p2_above()>;

}  // namespace stereo::semi_global
