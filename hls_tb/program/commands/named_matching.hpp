// SPDX-License-Identifier: Apache-2.0
// What commands with --config and --set share: a named configuration, its options, and the engines that run it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engines/configurations.hpp"

namespace stereo::app {

/// Throws InputError with the list of the known ones.
const Configuration& require_configuration(const std::string& name);

/// The algorithm of a named configuration with some options set ("window_px=9"). Throws InputError.
std::shared_ptr<const Algorithm> named_algorithm(const std::string& config, const std::vector<std::string>& settings);

enum class Engine { fast, clocked };
/// {word of the command line: engine}
const std::map<std::string, Engine>& engine_words();
const char* word_of(Engine engine);

/// Throws InputError where the engine has its options built in.
void require_settable(Engine engine, const std::vector<std::string>& settings);

/// The fast model on images of any size, or the clocked core on images of its own. What does not fit together becomes
/// an InputError that names the configuration.
DisparityMap match_named(const std::string& config, const ImagePair& pair, const Algorithm& algorithm, int threads,
                         Engine engine = Engine::fast);
DisparityMap match_named(const std::string& config, const DeepPair& pair, const Algorithm& algorithm, int threads,
                         Engine engine = Engine::fast);

}  // namespace stereo::app
