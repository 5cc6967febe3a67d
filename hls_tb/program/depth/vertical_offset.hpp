// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "definition/gray_image.hpp"

namespace stereo::app {

/// Rows by which the images of a rectified pair may differ before block matching suffers.
inline constexpr double kLargestVerticalOffset = 1.0;

struct VerticalOffset {
   double median_px = 0;  ///< median of the rows' differences between matched features, 0 or more
   int features = 0;
};

/// Matches ORB features of both images, those of the three finest scales only, as the others are placed coarsely.
/// Nothing where the images are too small or too few features match to say anything.
std::optional<VerticalOffset> vertical_offset(const ImagePair& pair);

/// A sentence that ends with a line feed when the images do not look rectified; else nothing.
std::string rectification_warning(const ImagePair& pair);

}  // namespace stereo::app
