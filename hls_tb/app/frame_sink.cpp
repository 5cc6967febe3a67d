// SPDX-License-Identifier: Apache-2.0
#include "app/frame_sink.hpp"

#include <filesystem>
#include <iostream>

#include "app/opencv_images.hpp"
#include "app/output_folder.hpp"
#include "app/video_files.hpp"

namespace stereo::app {
namespace {

class FolderSink : public FrameSink {
  public:
   explicit FolderSink(const std::string& path) : path_(path), folder_(path) {}

   void add(const cv::Mat& frame) override {
      const std::string number = std::to_string(frames_++);
      folder_.add("frame_" + std::string(number.size() < 6 ? 6 - number.size() : 0, '0') + number + ".png",
                  encode(frame));
   }

   void commit() override {
      folder_.commit(OutputFolder::Says::nothing);
      std::cout << path_ << '\n';
   }

  private:
   std::string path_;
   OutputFolder folder_;
   std::size_t frames_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> make_frame_sink(const std::string& path, double frames_per_second, cv::Size size) {
   if (std::filesystem::path(path).extension() == ".avi") return make_avi(path, frames_per_second, size);
   return std::make_unique<FolderSink>(path);
}

}  // namespace stereo::app
