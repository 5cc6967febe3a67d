// SPDX-License-Identifier: Apache-2.0
// The options of the algorithm under the names of StereoConfig, choices as words: the one place that knows both.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "models/matching.hpp"

namespace stereo::app {

nlohmann::json options_json(const MatchingParameters& options);

/// A configuration's options with some of them set by texts such as "window_px=9", "cost=census" or "median=true". What
/// values fit together check_matching_input knows. Throws InputError with one sentence that begins with `--set` and the
/// text.
MatchingParameters with_options(MatchingParameters options, const std::vector<std::string>& settings);

const char* word_of(Reference reference);
const std::map<std::string, Reference>& reference_words();

}  // namespace stereo::app
