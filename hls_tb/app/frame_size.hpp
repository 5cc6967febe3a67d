// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "app/errors.hpp"

namespace stereo::app {

inline std::string size_text(const cv::Mat& image) {
   return std::to_string(image.cols) + "x" + std::to_string(image.rows);
}

/// `name`: the file, as the sentence begins.
inline void require_size_of(const cv::Mat& frame, const cv::Mat& first, const std::string& name) {
   if (frame.size() != first.size())
      throw InputError(name + ": is " + size_text(frame) + " but the frames before it are " + size_text(first));
}

}  // namespace stereo::app
