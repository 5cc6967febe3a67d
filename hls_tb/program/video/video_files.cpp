// SPDX-License-Identifier: Apache-2.0
#include "program/video/video_files.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

namespace stereo::app {
namespace {

const VideoModule& video_module() {
   static const VideoModule* const module = [] {
      const auto path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "stereo_hls_video.so";
      void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
      const void* const entry = library != nullptr ? dlsym(library, kVideoModuleEntry) : nullptr;
      if (entry == nullptr) throw std::runtime_error(path.string() + " cannot be loaded: " + dlerror());
      return static_cast<const VideoModule*>(entry);
   }();
   return *module;
}

}  // namespace

std::unique_ptr<FrameSource> open_video(const std::string& option, const std::string& path) {
   return std::unique_ptr<FrameSource>(video_module().open_video(option, path));
}

std::unique_ptr<FrameSink> make_avi(const std::string& path, double frames_per_second, cv::Size size) {
   return std::unique_ptr<FrameSink>(video_module().make_avi(path, frames_per_second, size));
}

}  // namespace stereo::app
