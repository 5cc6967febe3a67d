// SPDX-License-Identifier: Apache-2.0
// What commands with --config and --set share: a named configuration's options, and the fast model with them.
#pragma once

#include <string>
#include <vector>

#include "app/disparity_image.hpp"

namespace stereo::app {

/// The options of a named configuration with some of them set ("window_px=9"). Throws InputError.
MatchingParameters named_parameters(const std::string& config, const std::vector<std::string>& settings);

/// The fast model on images of any size. What does not fit together becomes an InputError that names the configuration.
DisparityMap match_named(const std::string& config, const ImagePair& pair, const MatchingParameters& parameters);

}  // namespace stereo::app
