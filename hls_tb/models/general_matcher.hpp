// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/matching.hpp"

namespace stereo::fast {

/// Steps 2 to 6 of docs/algorithm.md but the texture check, for the right image as reference, images prefiltered.
DisparityMap match_general(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters);

}  // namespace stereo::fast
