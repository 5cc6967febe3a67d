// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/reference_model.hpp"
#include "vectors/matching_parameters.hpp"

namespace stereo::test {

/// What the reference model finds with the options of a hardware configuration.
inline DisparityMap reference_map(const ImagePair& pair, const StereoConfig& config) {
   return match_reference(pair.left, pair.right, matching_parameters(config));
}

}  // namespace stereo::test
