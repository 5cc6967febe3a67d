// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::app {

/// A PNG for people: left image, right image and disparity map side by side, with captions and a colour bar in pixels.
/// The map stands at the columns of the reference image that it belongs to; small images are enlarged by a whole
/// factor.
std::string encode_overview_png(const ImagePair& pair, const DisparityMap& map, const MapGeometry& geometry);

}  // namespace stereo::app
