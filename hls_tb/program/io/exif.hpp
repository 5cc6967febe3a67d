// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace stereo::app {

/// The orientation that the EXIF data of a JPEG, PNG or WebP file or the first image of a TIFF file names, 1 ... 8; 1,
/// upright, where it names none. Any bytes are safe.
int exif_orientation(std::string_view file);

}  // namespace stereo::app
