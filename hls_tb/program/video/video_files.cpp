// SPDX-License-Identifier: Apache-2.0
#include "program/video/video_files.hpp"

#include "program/io/program_module.hpp"

namespace stereo::app {
namespace {

const VideoModule& video_module() {
   static const VideoModule& module = program_module<VideoModule>("stereo_hls_video.so", kVideoModuleEntry);
   return module;
}

}  // namespace

std::unique_ptr<FrameSource> open_video(const std::string& option, const std::string& path) {
   return std::unique_ptr<FrameSource>(video_module().open_video(option, path));
}

std::unique_ptr<FrameSink> make_avi(const std::string& path, double frames_per_second, cv::Size size) {
   return std::unique_ptr<FrameSink>(video_module().make_avi(path, frames_per_second, size));
}

}  // namespace stereo::app
