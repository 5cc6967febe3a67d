// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "program/io/disparity_image.hpp"

namespace stereo::app {

/// Disparities from a file, ground truth or results:
/// - Middlebury's PFM (pfm.hpp); infinity: none,
/// - a grey image of 8 bits: value / scale pixels; 0: none, unless zero_is_known; in colour if all channels are the
/// same,
/// - a grey image of 16 bits as the KITTI benchmark has it: value / 256 pixels, whatever `scale` is; 0 as with 8 bits.
/// Throws InputError with one sentence that names `option` and the file.
DisparityImage load_disparities(const std::string& option, const std::string& path, double scale,
                                bool zero_is_known = false);

}  // namespace stereo::app
