// SPDX-License-Identifier: Apache-2.0
// Options of the commands that take a calibration.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

#include "program/depth/calibration.hpp"

namespace stereo::app {

/// Of "640x480"; empty where the word is not two numbers of 1 ... 65536 with an x between them.
inline cv::Size size_of_word(const std::string& word) {
   constexpr int kLargest = 65536;
   const char* const end = word.data() + word.size();
   cv::Size size;
   const auto width = std::from_chars(word.data(), end, size.width);
   if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return {};
   const auto height = std::from_chars(width.ptr + 1, end, size.height);
   const bool whole = height.ec == std::errc() && height.ptr == end;
   const bool possible = size.width >= 1 && size.height >= 1 && size.width <= kLargest && size.height <= kLargest;
   return whole && possible ? size : cv::Size();
}

struct CalibrationOptions {
   CalibrationFiles files;
   std::string calibrated_size;

   /// Empty: not given.
   cv::Size size() const { return size_of_word(calibrated_size); }
   /// All files that a command with these reads, besides `others`.
   std::vector<std::string> with(std::vector<std::string> others) const {
      others.insert(others.end(), {files.path, files.right, files.extrinsics});
      return others;
   }
};

inline void add_calibration_options(CLI::App& command, CalibrationOptions& options) {
   CLI::Option* const first =
       command.add_option("--calibration", options.files.path,
                          "OpenCV's YAML: M1 D1 M2 D2 R T, or what ROS, Kalibr, MATLAB or a benchmark writes: "
                          "docs/depth.md");
   first->required();
   CLI::Option* const right = command.add_option("--right-calibration", options.files.right,
                                                 "the right camera's file, where each camera has one: camera_info of "
                                                 "ROS");
   command.add_option("--extrinsics", options.files.extrinsics, "a second YAML file, where R and T stand apart")
       ->excludes(right);
   command.add_flag("--fisheye", options.files.fisheye,
                    "D1 and D2 of the file are the four coefficients of cv::fisheye");
   command
       .add_option("--calibrated-size", options.calibrated_size,
                   "WIDTHxHEIGHT of the images that the cameras were calibrated with: for images scaled since then")
       ->check([](const std::string& given) {
          return size_of_word(given).empty() ? given + " is no WIDTHxHEIGHT" : std::string();
       });
}

}  // namespace stereo::app
