// SPDX-License-Identifier: Apache-2.0
// The named configurations of the rectification.
#pragma once

#include "rectification/config.hpp"
#include "support/configuration.hpp"

namespace stereo::rectification::configurations {

STEREO_ROW(rectify_tiny, option, Config(), width_px = 32, height_px = 12, grid_px = 4, rows_above = 3, rows_below = 3);
STEREO_ROW(rectify_tiny_12bit, option, rectify_tiny, pixel_bits = 12);
STEREO_ROW(rectify_tiny_40, option, rectify_tiny, width_px = 40);
STEREO_ROW(rectify_vga, system, Config(), width_px = 640, height_px = 480);

}  // namespace stereo::rectification::configurations
