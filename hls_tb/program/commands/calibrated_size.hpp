// SPDX-License-Identifier: Apache-2.0
// An option of the commands that take a calibration.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <opencv2/core/types.hpp>
#include <string>

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

inline void add_calibrated_size_option(CLI::App& command, std::string& word) {
   command
       .add_option("--calibrated-size", word,
                   "WIDTHxHEIGHT of the images that the cameras were calibrated with: for images scaled since then")
       ->check([](const std::string& given) {
          return size_of_word(given).empty() ? given + " is no WIDTHxHEIGHT" : std::string();
       });
}

}  // namespace stereo::app
