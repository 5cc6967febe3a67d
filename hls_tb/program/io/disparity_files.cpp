// SPDX-License-Identifier: Apache-2.0
#include "program/io/disparity_files.hpp"

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <sstream>

#include "program/errors.hpp"
#include "program/io/opencv_images.hpp"
#include "program/io/pfm.hpp"

namespace stereo::app {
namespace {

constexpr double kKittiScale = 256;

std::string first_bytes(const std::string& path, std::size_t count) {
   std::ifstream file(path, std::ios::binary);
   std::string bytes(count, '\0');
   file.read(bytes.data(), std::streamsize(count));
   bytes.resize(std::size_t(file.gcount()));
   return bytes;
}

/// Throws std::invalid_argument.
std::string all_bytes(const std::string& path) {
   const std::ifstream file(path, std::ios::binary);
   if (!file) throw std::invalid_argument("it cannot be read; check its rights");
   std::ostringstream text;
   text << file.rdbuf();
   return text.str();
}

bool is_pfm(const std::string& path) {
   const std::string magic = first_bytes(path, 2);
   return std::filesystem::path(path).extension() == ".pfm" || magic == "Pf" || magic == "PF";
}

/// Throws InputError, without a file name, where a pixel would be no disparity.
template <class Pixel>
DisparityImage divided(const cv::Mat& mat, double scale, bool zero_is_known) {
   double largest = 0;
   cv::minMaxLoc(mat, nullptr, &largest);
   if (largest / scale > double(kLargestDisparity))
      throw InputError("a pixel of " + std::to_string(int(largest)) + " is no disparity with so small a scale");
   DisparityImage image(mat.cols, mat.rows);
   for (int y = 0; y < mat.rows; ++y)
      for (int x = 0; x < mat.cols; ++x)
         if (const Pixel value = mat.at<Pixel>(y, x); value != 0 || zero_is_known)
            image.at(x, y) = float(value / scale);
   return image;
}

/// One channel of a grey image that some tool has stored in colour. Throws InputError where the colours differ.
cv::Mat one_channel(const cv::Mat& mat) {
   if (mat.channels() == 1) return mat;
   std::vector<cv::Mat> channels;
   cv::split(mat, channels);
   for (const cv::Mat& channel : {channels.at(1), channels.at(std::min<std::size_t>(2, channels.size() - 1))})
      if (mat.channels() == 2 || cv::norm(channels[0], channel, cv::NORM_INF) != 0)
         throw InputError("is a colour image; give disparities as a PFM or a grey image");
   return channels[0];
}

/// Of an image. Throws InputError, without a file name.
DisparityImage disparities_of(const cv::Mat& image, double scale, bool zero_is_known) {
   const cv::Mat mat = one_channel(image);
   if (mat.depth() == CV_8U) return divided<uint8_t>(mat, scale, zero_is_known);
   if (mat.depth() == CV_16U) return divided<uint16_t>(mat, kKittiScale, zero_is_known);
   throw InputError("give disparities as a PFM or a grey image of 8 or 16 bits");
}

}  // namespace

DisparityImage load_disparities(const std::string& option, const std::string& path, double scale, bool zero_is_known) {
   const std::string name = option + " " + path;
   if (std::filesystem::is_regular_file(path) && is_pfm(path)) try {
         return parse_pfm(all_bytes(path));
      } catch (const std::invalid_argument& problem) {
         throw InputError(name + ": " + problem.what());
      }
   const cv::Mat mat = read_image(path, name);
   try {
      return disparities_of(mat, scale, zero_is_known);
   } catch (const InputError& problem) {
      throw InputError(name + ": " + problem.what());
   }
}

}  // namespace stereo::app
