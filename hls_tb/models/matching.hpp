// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/gray_image.hpp"

namespace stereo {

/// What a block matcher must know beside the images.
struct MatchingParameters {
   int disparities;    ///< disparity range D, 1 ... 256 and below the image width
   int window_px = 3;  ///< side B of the square window: odd
};

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these parameters.
void check_matching_input(const GrayImage& left, const GrayImage& right, MatchingParameters parameters);

}  // namespace stereo
