// SPDX-License-Identifier: Apache-2.0
// How far a disparity can be trusted, as the confidence map of OpenCV's DisparityWLSFilter has it, in whole numbers
// (docs/algorithm.md, "After the core").
#pragma once

#include <functional>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::app {

inline constexpr int kConfidenceRadius = 5;       ///< of the window whose variance counts, pixels
inline constexpr int kConfidenceTolerance = 24;   ///< the maps of both images differ by less, sixteenths of a pixel
inline constexpr int kConfidenceVariance = 1000;  ///< from which on there is no confidence, squared sixteenths
inline constexpr int kLargestConfidence = 255;

/// 255 where all disparities around the pixel are the same, less where they differ; validity does not count.
GrayImage smoothness(const DisparityMap& map);

/// The confidence of each pixel of `map`, which belongs to images of a width. `other`: the map of the other image,
/// whose pixels count from the same smallest disparity.
GrayImage confidence(const DisparityMap& map, const DisparityMap& other, const MapGeometry& geometry, int image_width);

/// The map of the other image by the same matcher: its reference becomes the other one when both images are mirrored
/// and exchanged.
DisparityMap other_map(const std::function<DisparityMap(const ImagePair&)>& match, const ImagePair& pair);
DisparityMap other_map(const std::function<DisparityMap(const DeepPair&)>& match, const DeepPair& pair);

}  // namespace stereo::app
