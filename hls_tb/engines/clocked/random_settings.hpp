// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scene/random.hpp"
#include "support/settings.hpp"

namespace stereo {

enum class Limits { kept, exceeded };

/// Random settings; what is held, as the size is, stays what the configuration says. Limits::exceeded: values beyond
/// the limits, too, of settings that the core takes as the nearest limit then.
std::vector<uint32_t> random_settings(const SettingList& ports, Random& random, Limits limits = Limits::kept);

}  // namespace stereo
