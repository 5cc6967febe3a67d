// SPDX-License-Identifier: Apache-2.0
#include "program/video/frame_sink.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

#include "program/errors.hpp"
#include "program/io/file_ending.hpp"
#include "program/io/opencv_images.hpp"
#include "program/io/output_folder.hpp"
#include "program/io/png_mark.hpp"
#include "program/video/video_files.hpp"

namespace stereo::app {
namespace {

/// Of videos that are not written here: a folder of such a name would surprise.
constexpr std::array kOtherVideoEndings{".flv", ".m4v", ".mkv", ".mov",  ".mp4", ".mpeg",
                                        ".mpg", ".ogv", ".ts",  ".webm", ".wmv"};

std::string frame_name(std::size_t number) {
   const std::string digits = std::to_string(number);
   return "frame_" + std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits + ".png";
}

class FolderSink : public FrameSink {
  public:
   explicit FolderSink(const std::string& path) : path_(path), folder_(path) {}

   void add(const cv::Mat& frame) override { folder_.add(frame_name(frames_++), marked_png(encode(frame))); }

   void commit() override {
      // The last frames of a longer result would stand behind these. Others are the user's own.
      std::vector<std::string> own;
      for (std::size_t more = frames_; std::filesystem::exists(path_ / frame_name(more)); ++more) {
         if (is_marked_png(path_ / frame_name(more))) folder_.remove(frame_name(more));
         else own.push_back(frame_name(more));
      }
      if (!own.empty())
         std::cout << "warning: " << path_.string() << " also holds " << own.size()
                   << (own.size() == 1 ? " frame" : " frames") << " that no run has written, from " << own.front()
                   << " on; they stay\n";
      std::cout << path_.string() << '\n';
      folder_.commit(OutputFolder::Says::nothing);
   }

  private:
   std::filesystem::path path_;
   OutputFolder folder_;
   std::size_t frames_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> make_frame_sink(const std::string& path, double frames_per_second, cv::Size size,
                                           const std::vector<std::string>& inputs) {
   if (is_one_of(path, inputs)) throw InputError("--out " + path + ": is an input; give another name");
   const std::string ending = lower_ending(path);
   if (ending == ".avi") return make_avi(path, frames_per_second, size);
   if (std::find(kOtherVideoEndings.begin(), kOtherVideoEndings.end(), ending) != kOtherVideoEndings.end())
      throw InputError("--out " + path + ": " + ending +
                       " videos cannot be written; give a name that ends with .avi, or a folder for images");
   return std::make_unique<FolderSink>(path);
}

}  // namespace stereo::app
