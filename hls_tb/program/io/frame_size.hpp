// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "definition/gray_image.hpp"
#include "program/errors.hpp"

namespace stereo::app {

/// `name`: the file, as the sentence begins.
inline void require_size_of(const cv::Mat& frame, const cv::Mat& first, const std::string& name) {
   if (frame.size() != first.size())
      throw InputError(name + ": is " + size_text(frame.size()) + " but the frames before it are " +
                       size_text(first.size()));
}

}  // namespace stereo::app
