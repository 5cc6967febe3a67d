// SPDX-License-Identifier: Apache-2.0
// The maps that `stereo_hls match` writes, and how they are read back: match.json beside them says what they are.
#pragma once

#include <optional>
#include <string>

#include "definition/map_geometry.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

inline constexpr const char *kMapName = "disparity.png", *kPfmName = "disparity.pfm",
                            *kKittiName = "disparity_kitti.png", *kFactsName = "match.json", *kValidName = "valid.png",
                            *kFilledName = "filled.png", *kFactsFormat = "stereo-hls match 1";

struct OwnMap {
   Reference reference;
   DisparityImage image;  ///< at the size of the images
   double scale;          ///< that was used
};

/// A file of one of these names with match.json beside it; nothing for others. `scale`: another one than match.json
/// says. Throws InputError, which names `option`, where the two do not fit together.
std::optional<OwnMap> load_own_map(const std::string& option, const std::string& path, std::optional<double> scale);

/// KITTI's 16 bits: 256 a pixel, 0 for none and 1 for the disparity 0.
std::string encode_kitti_png(const DisparityImage& image);
/// Pixels with a disparity that KITTI's 16 bits cannot hold: below 0, or 256 and more. They have none there.
int beyond_kitti(const DisparityImage& image);
/// Infinite where there is none.
std::string encode_pfm(const DisparityImage& image);

}  // namespace stereo::app
