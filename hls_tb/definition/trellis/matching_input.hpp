// SPDX-License-Identifier: Apache-2.0
// What follows from the options of the trellis and the size of the images, by definition (docs/algorithm.md).
#pragma once

#include <stdexcept>
#include <string>

#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"
#include "trellis/matching.hpp"

namespace stereo::trellis {

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these options.
void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching);
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// The map has all cost columns, as that of semi-global matching.
MapGeometry map_geometry(const Matching& matching, int image_width);

/// Such as "64 disparities, window 3x3, drop 4 or by 6, occlusion 7".
std::string describe(const Matching& matching);

}  // namespace stereo::trellis
