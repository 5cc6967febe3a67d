// SPDX-License-Identifier: Apache-2.0
#include "program/video/frame_source.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <vector>

#include "program/errors.hpp"
#include "program/io/file_ending.hpp"
#include "program/io/frame_size.hpp"
#include "program/io/opencv_images.hpp"
#include "program/video/frame_names.hpp"
#include "program/video/video_files.hpp"

namespace stereo::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array kImageEndings{".png", ".pgm", ".ppm", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};

/// Names of a folder's images, in the order of their numbers. Files whose names begin with a dot are hidden.
std::vector<std::string> image_names(const std::string& option, const fs::path& folder) {
   std::vector<std::string> names;
   for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string(), ending = lower_ending(entry.path());
      const bool is_image = std::find(kImageEndings.begin(), kImageEndings.end(), ending) != kImageEndings.end();
      if (is_image && !name.starts_with('.') && entry.is_regular_file()) names.push_back(name);
   }
   if (names.empty()) throw InputError(option + " " + folder.string() + ": the folder holds no images");
   sort_by_number(names);
   return names;
}

class FolderSource : public FrameSource {
  public:
   FolderSource(const fs::path& folder, const std::vector<std::string>& names, int bits) : bits_(bits) {
      for (const std::string& name : names) paths_.push_back((folder / name).string());
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
   if (fs::is_directory(path, error)) return std::make_unique<FolderSource>(path, image_names(option, path), bits);
   if (!fs::is_regular_file(path, error)) throw InputError(option + " " + path + ": there is no such file or folder");
   return open_video(option, path);
}

namespace {

void say_what_is_alone(const std::string& option, const std::vector<std::string>& names, const std::string& other) {
   constexpr std::size_t kMost = 8;
   if (names.empty()) return;
   std::cout << "warning: " << names.size() << (names.size() == 1 ? " frame of " : " frames of ") << option
             << " without a partner in " << other << ", left out: ";
   for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) std::cout << (i == 0 ? "" : ", ") << names[i];
   std::cout << (names.size() > kMost ? " ...\n" : "\n");
}

}  // namespace

PairSource open_cameras(const std::string& left, const std::string& right, int bits) {
   std::error_code error;
   if (!fs::is_directory(left, error) || !fs::is_directory(right, error))
      return {open_frames("--left", left, bits), open_frames("--right", right, bits)};
   const auto [pairs, left_alone, right_alone] = pair_names(image_names("--left", left), image_names("--right", right));
   if (pairs.empty())
      throw InputError("--left " + left + " and --right " + right +
                       ": no frame of one has the number or name of one of the other, as " + left_alone.front() +
                       " and " + right_alone.front());
   say_what_is_alone("--left", left_alone, "--right");
   say_what_is_alone("--right", right_alone, "--left");
   std::vector<std::string> left_names, right_names;
   for (const auto& [left_name, right_name] : pairs) {
      left_names.push_back(left_name);
      right_names.push_back(right_name);
   }
   return {std::make_unique<FolderSource>(left, left_names, bits),
           std::make_unique<FolderSource>(right, right_names, bits)};
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
