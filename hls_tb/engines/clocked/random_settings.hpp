// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scene/random.hpp"
#include "support/settings.hpp"

namespace stereo {

/// Random settings within their limits; what is held, as the size is, stays what the configuration says.
std::vector<uint32_t> random_settings(const SettingList& ports, Random& random);

/// Whether the core takes a value beyond the limits of a setting as the limit: of penalties and costs
/// (docs/integration.md).
bool counts_as_the_limit(const Setting& port);

enum class Limits { kept, exceeded };

/// Replaces half of the values that are limits by values beyond them, where they count as the limit.
void go_beyond_limits(std::vector<uint32_t>& values, const SettingList& ports, Random& random);

}  // namespace stereo
