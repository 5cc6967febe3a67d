// SPDX-License-Identifier: Apache-2.0
// The options of the algorithm under the names of StereoConfig, choices as words: the one place that knows both.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "models/matching.hpp"

namespace stereo::app {

nlohmann::json options_json(const MatchingParameters& options);

/// Sets one option from a text such as "window_px=9", "cost=census" or "median=true". What values fit together
/// check_matching_input knows. Throws InputError with one sentence that begins with `--set` and the text.
void set_option(MatchingParameters& options, const std::string& key_and_value);

/// A configuration's options with some of them set.
MatchingParameters with_options(MatchingParameters options, const std::vector<std::string>& settings);

const char* word_of(Reference reference);

}  // namespace stereo::app
