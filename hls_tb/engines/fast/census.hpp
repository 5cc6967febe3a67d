// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "definition/gray_image.hpp"

namespace stereo::fast {

/// The census transform of docs/algorithm.md, of each pixel in raster order. The window has odd sides, at most 9x7.
std::vector<uint64_t> census(const GrayImage& image, int census_width_px, int census_height_px, int threads);
std::vector<uint64_t> census(const DeepImage& image, int census_width_px, int census_height_px, int threads);

/// The same transforms in planes of eight bits, [plane][y][x], for those who only count the bits in which two differ:
/// bits stand in another order.
std::vector<uint8_t> census_planes(const GrayImage& image, int census_width_px, int census_height_px, int threads);
std::vector<uint8_t> census_planes(const DeepImage& image, int census_width_px, int census_height_px, int threads);

}  // namespace stereo::fast
