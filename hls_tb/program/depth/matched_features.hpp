// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "definition/gray_image.hpp"

namespace stereo::app {

/// A feature that both images show.
struct FeatureOffset {
   double right_px;  ///< how much further right it lies in the left image: its disparity in a rectified pair
   double down_px;   ///< how much further down it lies in the left image
};

/// Matches ORB features of both images, those of the three finest scales only, as the others are placed coarsely. Empty
/// where the images are too small or too few features match to say anything.
std::vector<FeatureOffset> matched_features(const ImagePair& pair);

}  // namespace stereo::app
