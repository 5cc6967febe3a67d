// SPDX-License-Identifier: Apache-2.0
// The module stereo_hls_video.so: all that needs OpenCV's videoio.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/videoio.hpp>

#include "program/commands/standard_output.hpp"
#include "program/errors.hpp"
#include "program/io/frame_size.hpp"
#include "program/io/made_folders.hpp"
#include "program/io/partial_files.hpp"
#include "program/io/silent_stderr.hpp"
#include "program/video/video_files.hpp"

namespace stereo::app {
namespace {

namespace fs = std::filesystem;

class VideoSource : public FrameSource {
  public:
   VideoSource(const std::string& option, const std::string& path) : name_(option + " " + path) {
      const SilentStderr silent;
      try {
         // Not whatever else OpenCV has: some of that looks for cameras first.
         for (const int reader : {cv::CAP_IMAGES, cv::CAP_FFMPEG})
            if (video_.open(path, reader)) break;
         if (video_.isOpened()) video_.read(waiting_);
      } catch (const cv::Exception&) {
         waiting_.release();
      }
      if (waiting_.empty() || waiting_.depth() != CV_8U)
         throw InputError(name_ + ": not a video that can be read; give a video file or a folder of images");
   }

   cv::Mat next() override {
      cv::Mat frame = waiting_;
      waiting_ = cv::Mat();
      ++taken_;
      const SilentStderr silent;
      try {
         video_.read(waiting_);
      } catch (const cv::Exception&) {
         throw InputError(name_ + ": frame " + std::to_string(taken_ + 1) + " cannot be read");
      }
      if (!waiting_.empty() && !frame.empty()) require_size_of(waiting_, frame, name_);
      if (waiting_.empty() && !frame.empty()) say_what_is_missing();
      return frame;
   }

   double frames_per_second() const override { return std::max(0.0, video_.get(cv::CAP_PROP_FPS)); }

  private:
   /// OpenCV takes a part of a file that it cannot read for the end. Of some formats it only estimates the number, so
   /// one frame is no reason.
   void say_what_is_missing() const {
      const double wanted = video_.get(cv::CAP_PROP_FRAME_COUNT);
      if (wanted > taken_ + 1 && wanted < kMostFrames)
         std::cout << "warning: " << name_ << ": only " << taken_ << " of " << std::lround(wanted)
                   << " frames can be read\n";
   }

   static constexpr double kMostFrames = 1e8;  ///< of files that know none the number is huge
   std::string name_;
   cv::VideoCapture video_;
   cv::Mat waiting_;  ///< the frame after the last one given; empty at the end
   int taken_ = 0;
};

class AviSink : public FrameSink {
  public:
   AviSink(const std::string& path, double frames_per_second, cv::Size size)
       : path_(path),
         made_(path_.parent_path()),
         partial_(path_.parent_path() /
                  std::string(".").append(path_.stem()).append(".partial-" + std::to_string(getpid()) + ".avi")) {
      std::error_code ignored;
      const SilentStderr silent;
      const int motion_jpeg = cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
      if (fs::is_directory(path_, ignored) ||
          !writer_.open(partial_.path().string(), cv::CAP_OPENCV_MJPEG, motion_jpeg, frames_per_second, size))
         throw InputError("--out " + path + ": the video cannot be written there");
   }
   ~AviSink() override {
      if (writer_.isOpened()) writer_.release();
   }
   AviSink(const AviSink&) = delete;
   AviSink& operator=(const AviSink&) = delete;

   void add(const cv::Mat& frame) override {
      writer_.write(frame);
      ++frames_;
   }

   void commit() override {
      writer_.release();
      if (!is_whole())
         throw InputError("--out " + path_.string() +
                          ": the video cannot be written there; check free space and permissions");
      std::cout << path_.string() << '\n';
      require_printed();
      fs::rename(partial_.path(), path_);
   }

  private:
   /// The writer does not say when the disk is full, but writes at the file's beginning how long it should be. A frame
   /// takes some hundred bytes at least.
   bool is_whole() const {
      std::error_code error;
      const uintmax_t size = fs::file_size(partial_.path(), error);
      std::ifstream file(partial_.path(), std::ios::binary);
      std::array<unsigned char, 8> head{};
      file.read(reinterpret_cast<char*>(head.data()), head.size());
      const uint32_t rest = head[4] | head[5] << 8U | head[6] << 16U | uint32_t(head[7]) << 24U;
      return !error && file && size >= 100 * frames_ && size == uintmax_t(rest) + head.size();
   }

   fs::path path_;
   MadeFolders made_;
   PartialFile partial_;
   cv::VideoWriter writer_;
   uintmax_t frames_ = 0;
};

FrameSource* new_source(const std::string& option, const std::string& path) { return new VideoSource(option, path); }

FrameSink* new_sink(const std::string& path, double frames_per_second, cv::Size size) {
   return new AviSink(path, frames_per_second, size);
}

}  // namespace
}  // namespace stereo::app

extern "C" const stereo::app::VideoModule stereo_video_module{stereo::app::new_source, stereo::app::new_sink};
