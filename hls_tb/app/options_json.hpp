// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "models/matching.hpp"

namespace stereo::app {

/// The options of the algorithm under the names of StereoConfig; choices as words.
nlohmann::json options_json(const MatchingParameters& options);

}  // namespace stereo::app
