// SPDX-License-Identifier: Apache-2.0
// The settings of block matching that come from ports, where a configuration has run_time_settings.
#pragma once

#include "block_matching/config.hpp"
#include "support/settings.hpp"

namespace stereo::block_matching {

#define STEREO_SETTINGS_block_matching(SETTING)                                \
   SETTING(uint16_t, texture_threshold, AsShown, C.has_texture_check(), 0,     \
           (C.prefilter_cap * C.window_px * C.window_px), C.texture_threshold) \
   STEREO_UNIQUENESS_PERCENT(SETTING)                                          \
   STEREO_CHECKED_AND_SEARCHED(SETTING)                                        \
   STEREO_SUPPORT_THRESHOLD(SETTING)

STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_block_matching);

}  // namespace stereo::block_matching
