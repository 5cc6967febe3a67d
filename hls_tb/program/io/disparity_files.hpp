// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "program/io/disparity_image.hpp"

namespace stereo::app {

/// How the values of a file become disparities.
struct DisparityCoding {
   std::optional<double> scale = std::nullopt;    ///< value / scale pixels; nothing: as the kind of file has it
   std::optional<double> unknown = std::nullopt;  ///< a value that stands for no disparity, beside those of the kind
   bool zero_is_known = false;                    ///< 0 of whole numbers is a disparity
};

struct LoadedDisparities {
   DisparityImage image;
   double scale;        ///< that was used
   std::string remark;  ///< a sentence on values that look like marks, or nothing
};

/// Disparities from a file, ground truth or results, told by their content:
/// - grey images of 8 bits, in colour if all channels are the same: scale 1; 0: none,
/// - grey images of 16 bits: scale 256, as the KITTI benchmark has it; 0: none,
/// - Middlebury's PFM (pfm.hpp), float TIFF, float arrays of numpy.save: scale 1; what is not finite: none.
/// Throws InputError with one sentence that names `option` and the file.
LoadedDisparities load_disparities(const std::string& option, const std::string& path, const DisparityCoding& coding);

}  // namespace stereo::app
