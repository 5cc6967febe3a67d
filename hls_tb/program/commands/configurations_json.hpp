// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

namespace stereo::app {

/// {name: what is known of the configuration}, as `stereo_hls configurations --json` prints it.
nlohmann::json configurations_json();
/// The same of the stages: what they have in common with matching cores, and their own.
nlohmann::json stages_json();

/// {family: {option: default, limits or words, meaning}}: what is matched.
nlohmann::json families_json();
/// The same of all options of the cores, and of the stages.
nlohmann::json all_options_json();

}  // namespace stereo::app
