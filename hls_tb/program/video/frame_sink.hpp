// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace stereo::app {

/// Takes the frames of a result: all of them appear with `commit`, or none.
class FrameSink {
  public:
   virtual ~FrameSink() = default;
   /// 8 bits, 3 channels, all of one size. Throws InputError when there is no room for it.
   virtual void add(const cv::Mat& frame) = 0;
   virtual void commit() = 0;
};

/// A Motion JPEG video where the path ends with .avi, else a folder of frame_000000.png, frame_000001.png ...
/// `inputs`: what the frames come from. Throws InputError, which names --out, when it cannot be made, is an input or
/// ends as another kind of video does.
std::unique_ptr<FrameSink> make_frame_sink(const std::string& path, double frames_per_second, cv::Size size,
                                           const std::vector<std::string>& inputs);

}  // namespace stereo::app
