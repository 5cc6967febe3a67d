// SPDX-License-Identifier: Apache-2.0
// All that needs OpenCV's imgcodecs: the module stereo_hls_images.so, and a library for programs that link it.
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "program/io/image_codecs.hpp"
#include "program/io/silent_stderr.hpp"

namespace stereo::app {
namespace {

cv::Mat read(const std::string& path, std::string& complaint) {
   const SilentStderr silent;
   try {
      cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
      complaint = silent.said();
      return image;
   } catch (const std::exception&) {  // cv::Exception, and others that OpenCV lets through
      return {};
   }
}

std::string encode(const cv::Mat& image, const char* ending) {
   std::vector<uint8_t> bytes;
   if (!cv::imencode(ending, image, bytes)) throw std::runtime_error("OpenCV cannot encode such an image");
   return {bytes.begin(), bytes.end()};
}

}  // namespace
}  // namespace stereo::app

extern "C" const stereo::app::ImageCodecs stereo_image_module{stereo::app::read, stereo::app::encode};
