// SPDX-License-Identifier: Apache-2.0
#include "program/io/disparity_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <sstream>

#include "program/errors.hpp"
#include "program/io/npy.hpp"
#include "program/io/opencv_images.hpp"
#include "program/io/pfm.hpp"

namespace stereo::app {
namespace {

constexpr double kKittiScale = 256;
constexpr std::size_t kNpyMagic = 6;  ///< bytes

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
   if (!file) throw std::invalid_argument("it cannot be read; check its permissions");
   std::ostringstream text;
   text << file.rdbuf();
   return text.str();
}

bool is_pfm(const std::string& path) {
   const std::string magic = first_bytes(path, 2);
   return std::filesystem::path(path).extension() == ".pfm" || magic == "Pf" || magic == "PF";
}

/// Values as they are stored; NaN: none.
template <class Value>
DisparityImage values_of(const cv::Mat& mat, bool zero_is_known) {
   DisparityImage image(mat.cols, mat.rows);
   for (int y = 0; y < mat.rows; ++y)
      for (int x = 0; x < mat.cols; ++x)
         if (const Value value = mat.at<Value>(y, x); value != 0 || zero_is_known) image.at(x, y) = float(value);
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

struct Values {
   DisparityImage image;
   double scale;  ///< of the kind of file
};

/// Of an image. Throws InputError, without a file name.
Values values_of_image(const cv::Mat& image, bool zero_is_known) {
   const cv::Mat mat = one_channel(image);
   switch (mat.depth()) {
      case CV_8U:
         return {values_of<uint8_t>(mat, zero_is_known), 1};
      case CV_16U:
         return {values_of<uint16_t>(mat, zero_is_known), kKittiScale};
      case CV_32F:
         return {values_of<float>(mat, true), 1};
      case CV_64F:
         return {values_of<double>(mat, true), 1};
      default:
         throw InputError("give disparities as a PFM, a grey image of 8 or 16 bits, or floats");
   }
}

/// Throws std::invalid_argument and InputError, without a file name.
Values stored_values(const std::string& path, const std::string& name, bool zero_is_known) {
   if (std::filesystem::is_regular_file(path)) {
      if (is_pfm(path)) return {parse_pfm(all_bytes(path)), 1};
      if (is_npy(first_bytes(path, kNpyMagic))) return {parse_npy(all_bytes(path)), 1};
   }
   const cv::Mat mat = read_image(path, name);
   try {
      return values_of_image(mat, zero_is_known);
   } catch (const InputError& problem) {
      throw std::invalid_argument(problem.what());
   }
}

/// Throws std::invalid_argument where a pixel would be no disparity.
void divide(DisparityImage& image, double scale, std::optional<double> unknown) {
   for (std::size_t i = 0; i < image.px.size(); ++i) {
      float& px = image.px[i];
      const double disparity = double(px) / scale;
      if (!std::isfinite(px) || (unknown && px == float(*unknown))) px = kNoDisparity;
      else if (std::abs(disparity) <= double(kLargestDisparity)) px = float(disparity);
      else {
         const auto width = std::size_t(image.width);
         std::ostringstream text;
         text << "its pixel " << i % width << "," << i / width << ", " << px << ", is not a disparity"
              << (scale < 1 ? " with so small a scale" : "; if it marks unknown ones, give --unknown");
         throw std::invalid_argument(text.str());
      }
   }
}

/// A sentence where all negative disparities are -1, as some mark what is unknown.
std::string remark_on_marks(const std::string& name, const DisparityImage& image) {
   const auto marks = std::count(image.px.begin(), image.px.end(), -1.0F);
   const auto negative = std::count_if(image.px.begin(), image.px.end(), [](float px) { return px < 0; });
   if (marks == 0 || marks != negative) return "";
   return name + ": " + std::to_string(marks) + " pixels are -1: are they unknown? Then give --unknown -1";
}

}  // namespace

LoadedDisparities load_disparities(const std::string& option, const std::string& path, const DisparityCoding& coding) {
   const std::string name = option + " " + path;
   try {
      Values values = stored_values(path, name, coding.zero_is_known);
      const double scale = coding.scale.value_or(values.scale);
      divide(values.image, scale, coding.unknown);
      const std::string remark = scale == 1 ? remark_on_marks(name, values.image) : "";
      return {std::move(values.image), scale, remark};
   } catch (const std::invalid_argument& problem) {
      throw InputError(name + ": " + problem.what());
   }
}

}  // namespace stereo::app
