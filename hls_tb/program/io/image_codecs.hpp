// SPDX-License-Identifier: Apache-2.0
// What reads and writes image files. The program has it in a module of its own, stereo_hls_images.so beside it, which
// is loaded with the first image: the hundred libraries behind OpenCV's imgcodecs take ten times as long to load as all
// others together. Tests and fuzz targets link it.
#pragma once

#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace stereo::app {

struct ImageCodecs {
   /// As it is stored; empty where the file is no image. Prints and throws nothing. `complaint`: what the decoder says
   /// of an image that it has read nevertheless.
   cv::Mat (*read)(const std::string& path, std::string& complaint);
   /// Throws std::runtime_error where it cannot be done.
   std::string (*encode)(const cv::Mat& image, const char* ending);  ///< ".png" or ".tiff"
};

const ImageCodecs& image_codecs();

/// The name under which the module exports them.
inline constexpr const char* kImageModuleEntry = "stereo_image_module";

}  // namespace stereo::app
