// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

namespace stereo::app {

/// The frames of one camera, one after the other.
class FrameSource {
  public:
   virtual ~FrameSource() = default;
   /// The next frame, as `read_camera_image` gives it, of the size of the first one; empty after the last one. Throws
   /// InputError with one sentence that names the file.
   virtual cv::Mat next() = 0;
   /// 0: not known.
   virtual double frames_per_second() const { return 0; }
};

/// A folder of images, in the order of the numbers in their names and with grey values of up to `bits` bits, or a video
/// file, which has 8. Throws InputError, which names the option, when there is nothing to read.
std::unique_ptr<FrameSource> open_frames(const std::string& option, const std::string& path, int bits);

struct FramePair {
   cv::Mat left, right;  ///< both empty after the last pair
   bool empty() const { return left.empty(); }
};

/// Two cameras' frames, of one size and as many from each.
class PairSource {
  public:
   PairSource(std::unique_ptr<FrameSource> left, std::unique_ptr<FrameSource> right);
   /// Both cameras side by side in each frame of one source, the left one on the left.
   explicit PairSource(std::unique_ptr<FrameSource> side_by_side);

   /// Throws InputError when one of the cameras ends before the other or sizes differ.
   FramePair next();
   double frames_per_second() const { return left_->frames_per_second(); }

  private:
   FramePair split(const cv::Mat& frame) const;

   std::unique_ptr<FrameSource> left_, right_;  ///< right_ is null for side by side
   int taken_ = 0;
};

/// Of --left and --right. Two folders are paired by the numbers and names of their images (frame_names.hpp), and stdout
/// says which have no partner; others frame by frame. Throws InputError.
PairSource open_cameras(const std::string& left, const std::string& right, int bits);

}  // namespace stereo::app
