// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "engines/clocked/clocked_core.hpp"

namespace stereo {

/// The map of one frame by the clocked core. Throws std::invalid_argument with one sentence when the images do not fit
/// the configuration.
DisparityMap match_clocked(const CoreModule& core, const ImagePair& pair);
DisparityMap match_clocked(const CoreModule& core, const DeepPair& pair);

}  // namespace stereo
