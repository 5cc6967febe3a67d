// SPDX-License-Identifier: Apache-2.0
#include "program/depth/benchmark_calibration.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <sstream>
#include <vector>

#include "program/errors.hpp"

namespace stereo::app {
namespace {

using Numbers = std::vector<double>;
/// {key: its numbers}; empty where what stands behind the key is anything else.
using Lines = std::map<std::string, Numbers, std::less<>>;

bool is_between(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '[' || c == ']' || c == ';' || c == ','; }

/// Nothing where a word is no finite number.
Numbers numbers_of(std::string_view text) {
   Numbers numbers;
   while (true) {
      while (!text.empty() && is_between(text.front())) text.remove_prefix(1);
      if (text.empty()) return numbers;
      double number = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (error != std::errc() || !std::isfinite(number)) return {};
      text.remove_prefix(std::size_t(end - text.data()));
      if (!text.empty() && !is_between(text.front())) return {};
      numbers.push_back(number);
   }
}

Lines lines_of(std::string_view text, char separator) {
   Lines lines;
   while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), line.size() + 1));
      if (const std::size_t key = line.find(separator); key != std::string_view::npos)
         lines.emplace(line.substr(0, key), numbers_of(line.substr(key + 1)));
   }
   return lines;
}

/// Throws InputError where there is no such key or another number of numbers.
const Numbers& required(const Lines& lines, const std::string& key, std::size_t count) {
   const auto found = lines.find(key);
   if (found == lines.end()) throw InputError("it has no " + key);
   if (found->second.size() != count)
      throw InputError("its " + key + " is not " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
   return found->second;
}

cv::Mat matrix(const Lines& lines, const std::string& key, int rows, int columns) {
   return cv::Mat(required(lines, key, std::size_t(rows) * std::size_t(columns)), true).reshape(1, rows);
}

cv::Size size_of(double width, double height) {
   constexpr double kLargest = 65536;
   const auto is_side = [](double side) { return side >= 1 && side <= kLargest && side == std::floor(side); };
   if (!is_side(width) || !is_side(height)) throw InputError("its image size is not a number of pixels");
   return {int(width), int(height)};
}

Calibration of_middlebury(const Lines& lines) {
   Calibration calibration;
   calibration.lens = Lens::radial;
   calibration.m1 = matrix(lines, "cam0", 3, 3);
   calibration.m2 = matrix(lines, "cam1", 3, 3);
   calibration.t = (cv::Mat_<double>(3, 1) << -required(lines, "baseline", 1)[0], 0, 0);
   calibration.unit_mm = 1;
   calibration.image_size = calibration.rectified_size =
       size_of(required(lines, "width", 1)[0], required(lines, "height", 1)[0]);
   const double difference = calibration.m2.at<double>(0, 2) - calibration.m1.at<double>(0, 2);
   if (const double doffs = required(lines, "doffs", 1)[0]; std::abs(doffs - difference) > 0.01) {
      std::ostringstream text;
      text << "its doffs is " << doffs << " but the principal points of cam0 and cam1 are " << difference
           << " columns apart";
      throw InputError(text.str());
   }
   return calibration;
}

/// `left`, `right`: a camera's number as two digits.
Calibration of_cam_to_cam(const Lines& lines, const std::string& left, const std::string& right) {
   Calibration calibration;
   calibration.p1 = matrix(lines, "P_rect_" + left, 3, 4);
   calibration.p2 = matrix(lines, "P_rect_" + right, 3, 4);
   const Numbers& rectified = required(lines, "S_rect_" + left, 2);
   calibration.rectified_size = size_of(rectified[0], rectified[1]);
   if (!lines.contains("K_" + left)) return calibration;
   const Numbers& seen = required(lines, "S_" + left, 2);
   calibration.image_size = size_of(seen[0], seen[1]);
   calibration.m1 = matrix(lines, "K_" + left, 3, 3);
   calibration.m2 = matrix(lines, "K_" + right, 3, 3);
   calibration.d1 = matrix(lines, "D_" + left, 1, 5);
   calibration.d2 = matrix(lines, "D_" + right, 1, 5);
   // Both are given from camera 0: X_left = R_left X_0 + T_left.
   const cv::Mat turn = matrix(lines, "R_" + right, 3, 3) * matrix(lines, "R_" + left, 3, 3).t();
   calibration.r = turn;
   calibration.t = cv::Mat(matrix(lines, "T_" + right, 3, 1) - turn * matrix(lines, "T_" + left, 3, 1));
   return calibration;
}

}  // namespace

std::optional<Calibration> parse_benchmark_calibration(std::string_view text) {
   if (const Lines lines = lines_of(text, '='); lines.contains("cam0") || lines.contains("cam1"))
      return of_middlebury(lines);
   const Lines lines = lines_of(text, ':');
   const auto has = [&lines](const char* key) { return lines.contains(key); };
   Calibration calibration;
   if (has("P_rect_00") || has("P_rect_02")) {
      calibration = has("P_rect_02") ? of_cam_to_cam(lines, "02", "03") : of_cam_to_cam(lines, "00", "01");
   } else if (has("P0") && (has("P1") || has("P3"))) {
      const bool colour = has("P2") || has("P3");
      calibration.p1 = matrix(lines, colour ? "P2" : "P0", 3, 4);
      calibration.p2 = matrix(lines, colour ? "P3" : "P1", 3, 4);
   } else {
      return std::nullopt;
   }
   calibration.unit_mm = 1000;
   calibration.lens = Lens::radial;
   return calibration;
}

}  // namespace stereo::app
