// SPDX-License-Identifier: Apache-2.0
// What follows from the options of phase correlation and the size of the images, by definition (docs/algorithm.md).
#pragma once

#include <stdexcept>
#include <string>

#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"
#include "phase_correlation/matching.hpp"

namespace stereo::phase_correlation {

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these options.
void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching);
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// The map is that of block matching.
MapGeometry map_geometry(const Matching& matching, int image_width);

/// Such as "24 disparities, window 9x9, phase of 2 scales".
std::string describe(const Matching& matching);

}  // namespace stereo::phase_correlation
