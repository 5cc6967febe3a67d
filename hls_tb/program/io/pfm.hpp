// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string_view>

#include "program/io/disparity_image.hpp"

namespace stereo::app {

inline constexpr int kLargestPfmSide = 65536;         ///< pixels; larger files are refused
inline constexpr float kLargestDisparity = 65536.0F;  ///< either side of 0; beyond it a value is no disparity

/// Reads a grey Portable Float Map as Middlebury's stereo benchmark writes them: "Pf", width, height, a scale whose
/// sign gives the byte order (negative: little endian) and whose size is ignored as the benchmark ignores it, one byte
/// of white space, then 32-bit floats from the bottom row up, as they are stored. Any bytes are safe. Throws
/// std::invalid_argument with one sentence, without a file name.
DisparityImage parse_pfm(std::string_view bytes);

}  // namespace stereo::app
