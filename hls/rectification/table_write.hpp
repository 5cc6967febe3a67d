// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace stereo::rectification {

/// A node of a table on its way into the core: one a clock, at any time. A frame that is under way shows the nodes that
/// its pixels meet.
struct TableWrite {
   bool valid = false;   ///< false: the rest is ignored
   bool right = false;   ///< of the right camera's table
   uint16_t column = 0;  ///< of the node: its pixel's column / grid_px
   uint16_t row = 0;
   int16_t x = 0, y = 0;  ///< from the pixel to its place in the camera's image, in 2^-offset_fraction_bits pixels
};

}  // namespace stereo::rectification
