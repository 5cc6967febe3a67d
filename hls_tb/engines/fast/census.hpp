// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "definition/gray_image.hpp"
#include "support/matching_groups.hpp"

namespace stereo::fast {

/// The census transform of docs/algorithm.md, of each pixel in raster order.
std::vector<uint64_t> census(const GrayImage& image, const CensusWindow& window, int threads);
std::vector<uint64_t> census(const DeepImage& image, const CensusWindow& window, int threads);

/// The same transforms in planes of eight bits, [plane][y][x], for those who only count the bits in which two differ:
/// bits stand in another order.
std::vector<uint8_t> census_planes(const GrayImage& image, const CensusWindow& window, int threads);
std::vector<uint8_t> census_planes(const DeepImage& image, const CensusWindow& window, int threads);

}  // namespace stereo::fast
