// SPDX-License-Identifier: Apache-2.0
// What follows from the options of semi-global matching and the size of the images, by definition (docs/algorithm.md).
#pragma once

#include <stdexcept>
#include <string>

#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"
#include "semi_global/matching.hpp"

namespace stereo::semi_global {

/// Throws std::invalid_argument with one sentence when the pair cannot be matched with these options.
void check_matching_input(const GrayImage& left, const GrayImage& right, const Matching& matching);
void check_matching_input(const DeepImage& left, const DeepImage& right, const Matching& matching);

/// The options that give the mirror image of the same map for the mirrored pair.
Matching mirrored(Matching matching);

/// Largest cost that a path can see.
int largest_path_cost(const Matching& matching);

/// By how much P2 falls between the map's columns x-1 and x along a row of the right image, with `matching` for a right
/// reference: [y][x], 0 in column 0. Image: of grey values, whatever the prefilter.
template <class Pixel>
DeepImage reliefs(const RasterImage<Pixel>& right, const Matching& matching);

/// Width of the disparity map: that of the cost columns.
int map_width(int width_px, const Matching& matching);
MapGeometry map_geometry(const Matching& matching, int image_width);

/// Such as "64 disparities, window 3x3, P1 5, P2 22".
std::string describe(const Matching& matching);

}  // namespace stereo::semi_global
