// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/matching.hpp"

namespace stereo {

/// The same map as match_reference, well below a millisecond a frame at 320x240 with 100 disparities and a 3x3
/// window (bench/stereo_bench.cpp measures it): for parameter studies.
DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters);

}  // namespace stereo
