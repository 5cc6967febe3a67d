// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "definition/gray_image.hpp"

namespace stereo::fast {

/// The phase codes of docs/algorithm.md, of each pixel in raster order. Where there are several scales, the bits of the
/// finest one stand twice, so that the number of bits in which two differ is the cost.
std::vector<uint64_t> weighted_phase_codes(const GrayImage& image, int scales);
std::vector<uint64_t> weighted_phase_codes(const DeepImage& image, int scales);

}  // namespace stereo::fast
