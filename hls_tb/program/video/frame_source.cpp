// SPDX-License-Identifier: Apache-2.0
#include "program/video/frame_source.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "program/errors.hpp"
#include "program/io/file_ending.hpp"
#include "program/io/frame_size.hpp"
#include "program/io/opencv_images.hpp"
#include "program/video/video_files.hpp"

namespace stereo::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array kImageEndings{".png", ".pgm", ".ppm", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};

class FolderSource : public FrameSource {
  public:
   FolderSource(const std::string& option, const std::string& path, int bits) : bits_(bits) {
      for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
         const std::string ending = lower_ending(entry.path());
         const bool is_image = std::find(kImageEndings.begin(), kImageEndings.end(), ending) != kImageEndings.end();
         if (is_image && entry.is_regular_file()) paths_.push_back(entry.path().string());
      }
      if (paths_.empty()) throw InputError(option + " " + path + ": the folder holds no images");
      std::sort(paths_.begin(), paths_.end());
   }

   cv::Mat next() override {
      if (position_ == paths_.size()) return {};
      const std::string& path = paths_[position_++];
      cv::Mat frame = read_camera_image(path, bits_);
      if (first_.empty()) first_ = frame;
      require_size_of(frame, first_, path);
      return frame;
   }

  private:
   int bits_;
   std::vector<std::string> paths_;
   std::size_t position_ = 0;
   cv::Mat first_;
};

}  // namespace

std::unique_ptr<FrameSource> open_frames(const std::string& option, const std::string& path, int bits) {
   std::error_code error;
   if (fs::is_directory(path, error)) return std::make_unique<FolderSource>(option, path, bits);
   if (!fs::is_regular_file(path, error)) throw InputError(option + " " + path + ": there is no such file or folder");
   return open_video(option, path);
}

PairSource::PairSource(std::unique_ptr<FrameSource> left, std::unique_ptr<FrameSource> right)
    : left_(std::move(left)), right_(std::move(right)) {}

PairSource::PairSource(std::unique_ptr<FrameSource> side_by_side) : left_(std::move(side_by_side)) {}

FramePair PairSource::split(const cv::Mat& frame) const {
   if (frame.cols % 2 != 0)
      throw InputError("--side-by-side: its frames are " + std::to_string(frame.cols) +
                       " pixels wide, which two images of one size cannot be");
   const int width = frame.cols / 2;
   return {frame.colRange(0, width), frame.colRange(width, frame.cols)};
}

FramePair PairSource::next() {
   if (!right_) {
      const cv::Mat frame = left_->next();
      return frame.empty() ? FramePair{} : split(frame);
   }
   FramePair pair{left_->next(), right_->next()};
   if (pair.left.empty() != pair.right.empty())
      throw InputError("--" + std::string(pair.left.empty() ? "left" : "right") + ": ends after " +
                       std::to_string(taken_) + " frames but the other camera has more; give as many of each");
   require_same_size<InputError>("--left", pair.left.size(), "--right", pair.right.size());
   ++taken_;
   return pair;
}

}  // namespace stereo::app
