// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string_view>

#include "program/io/disparity_image.hpp"

namespace stereo::app {

/// Reads an array of numpy.save: float16, float32 or float64 of two axes, rows and columns, in either byte and memory
/// order. Values as they are stored. Any bytes are safe. Throws std::invalid_argument with one sentence, without a file
/// name.
DisparityImage parse_npy(std::string_view bytes);
bool is_npy(std::string_view bytes);

}  // namespace stereo::app
