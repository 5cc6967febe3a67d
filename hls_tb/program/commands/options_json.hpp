// SPDX-License-Identifier: Apache-2.0
// The options of an algorithm as JSON and from the command line.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engines/algorithm.hpp"

namespace stereo::app {

nlohmann::json options_json(const std::vector<OptionValue>& options);

/// Reads texts such as "window_px=9". Throws InputError with one sentence that begins with `--set` and the text, also
/// where `set` throws std::invalid_argument.
void for_each_setting(const std::vector<std::string>& settings,
                      const std::function<void(const std::string& name, const std::string& value)>& set);

/// An algorithm with some of its options set by texts such as "window_px=9", "cost=census" or "median=true". What
/// values fit together it says when it matches. Throws InputError with one sentence that begins with `--set` and the
/// text.
std::shared_ptr<const Algorithm> with_options(std::shared_ptr<const Algorithm> algorithm,
                                              const std::vector<std::string>& settings);

const char* word_of(Reference reference);
const std::map<std::string, Reference>& reference_words();

}  // namespace stereo::app
