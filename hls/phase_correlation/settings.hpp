// SPDX-License-Identifier: Apache-2.0
// The settings of phase correlation that come from ports, where a configuration has run_time_settings.
#pragma once

#include "phase_correlation/config.hpp"
#include "support/settings.hpp"

namespace stereo::phase_correlation {

#define STEREO_SETTINGS_phase_correlation(SETTING) \
   STEREO_UNIQUENESS_PERCENT(SETTING)              \
   STEREO_CHECKED_AND_SEARCHED(SETTING)            \
   STEREO_SUPPORT_THRESHOLD(SETTING)

STEREO_DEFINE_SETTINGS(STEREO_SETTINGS_phase_correlation);

}  // namespace stereo::phase_correlation
