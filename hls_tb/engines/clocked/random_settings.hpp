// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scene/random.hpp"
#include "support/settings.hpp"

namespace stereo {

/// Whether the core takes a value beyond the limits of a setting as the nearest limit: of penalties, costs and the
/// threshold of the support filter (docs/integration.md).
bool counts_as_the_limit(const Setting& port);

enum class Limits { kept, exceeded };

/// Random settings; what is held, as the size is, stays what the configuration says. Limits::exceeded: values beyond
/// the limits, too, of settings that the core takes as the nearest limit then.
std::vector<uint32_t> random_settings(const SettingList& ports, Random& random, Limits limits = Limits::kept);

}  // namespace stereo
