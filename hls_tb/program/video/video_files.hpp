// SPDX-License-Identifier: Apache-2.0
// Video files in and out. They stand in a module of their own, stereo_hls_video.so beside the program, which is loaded
// when the first one is opened: the libraries behind OpenCV's videoio would more than double the time of every start.
#pragma once

#include "program/video/frame_sink.hpp"
#include "program/video/frame_source.hpp"

namespace stereo::app {

/// Throws InputError, which names the option, when the file is no video that can be read.
std::unique_ptr<FrameSource> open_video(const std::string& option, const std::string& path);
/// A Motion JPEG video. Throws InputError, which names --out, when it cannot be written.
std::unique_ptr<FrameSink> make_avi(const std::string& path, double frames_per_second, cv::Size size);

/// What the module exports under the name kVideoModuleEntry. The callers own what they get.
struct VideoModule {
   FrameSource* (*open_video)(const std::string& option, const std::string& path);
   FrameSink* (*make_avi)(const std::string& path, double frames_per_second, cv::Size size);
};
inline constexpr const char* kVideoModuleEntry = "stereo_video_module";

}  // namespace stereo::app
