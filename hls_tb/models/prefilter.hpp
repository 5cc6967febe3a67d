// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/matching.hpp"

namespace stereo::fast {

/// The prefilter of docs/algorithm.md; values 0 ... 2*cap.
GrayImage prefilter_xsobel(const GrayImage& image, int cap);

/// Takes the validity of the pixels of `map` whose windows have too little texture. `filtered` is the prefiltered right
/// image, the reference.
void check_texture(const GrayImage& filtered, const MatchingParameters& parameters, DisparityMap& map);

}  // namespace stereo::fast
