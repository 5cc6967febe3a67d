// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

namespace stereo::app {

/// {name: what is known of the configuration}, as `stereo_hls configurations --json` prints it.
nlohmann::json configurations_json();

/// {family: {option: default, limits or words, meaning}}.
nlohmann::json families_json();

}  // namespace stereo::app
