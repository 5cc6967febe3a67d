// SPDX-License-Identifier: Apache-2.0
#include "program/depth/depth.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>

namespace stereo::app {
namespace {

void append(std::string& bytes, float value) {
   const auto word = std::bit_cast<uint32_t>(value);
   for (int i = 0; i < 4; ++i) bytes += char(uint8_t(word >> (8 * i)));
}

/// With digits that give the same floats again.
std::string text_of(const Point& point) {
   std::array<char, 64> text{};
   std::snprintf(text.data(), text.size(), "%.9g %.9g %.9g", double(point.x_m), double(point.y_m), double(point.z_m));
   return text.data();
}

bool is_known(const Point& point) { return point.z_m != 0; }

}  // namespace

std::vector<Point> points_of(const DisparityImage& disparity, Reference reference, const RectifiedGeometry& geometry,
                             double metres_per_unit) {
   std::vector<Point> points(disparity.px.size(), Point{0, 0, 0});
   auto point = points.begin();
   for (int y = 0; y < disparity.height; ++y)
      for (int x = 0; x < disparity.width; ++x, ++point) {
         const double found = double(disparity.at(x, y));
         if (!has_disparity(disparity.at(x, y))) continue;
         const cv::Vec4d place = geometry.q * cv::Vec4d(reference == Reference::left ? x : x + found, y, found, 1);
         if (!(place[3] > 0)) continue;
         const auto metres = [&](int axis) { return float(place[axis] / place[3] * metres_per_unit); };
         const Point there{metres(0), metres(1), metres(2)};
         if (std::isfinite(there.x_m) && std::isfinite(there.y_m) && std::isfinite(there.z_m)) *point = there;
      }
   return points;
}

int keep_depths(std::vector<Point>& points, double least_m, double largest_m) {
   int left_out = 0;
   for (Point& point : points) {
      const double depth_m = std::abs(double(point.z_m));
      if (!is_known(point) || (depth_m >= least_m && depth_m <= largest_m)) continue;
      point = {0, 0, 0};
      ++left_out;
   }
   return left_out;
}

cv::Mat depth_image(const std::vector<Point>& points, int width_px, int height_px) {
   cv::Mat_<uint16_t> image(height_px, width_px);
   std::transform(points.begin(), points.end(), image.begin(), [](const Point& point) {
      const double mm = std::round(1000 * std::abs(double(point.z_m)));
      return mm <= kLargestDepthMm ? uint16_t(mm) : uint16_t(0);
   });
   return image;
}

cv::Mat float_depth_image(const std::vector<Point>& points, int width_px, int height_px) {
   cv::Mat_<float> image(height_px, width_px);
   std::transform(points.begin(), points.end(), image.begin(),
                  [](const Point& point) { return float(1000 * std::abs(double(point.z_m))); });
   return image;
}

std::string axes_of(const RectifiedGeometry& geometry) {
   return geometry.usual_axes() ? "x to the right, y down, z forward" : "the axes are those of the calibration's Q";
}

std::string encode_ply(const std::vector<Point>& points, const cv::Mat& colors, const std::string& axes,
                       PlyFormat format) {
   const bool binary = format == PlyFormat::binary;
   std::string bytes = "ply\nformat " + std::string(binary ? "binary_little_endian" : "ascii") +
                       " 1.0\ncomment metres, seen from the rectified left camera: " + axes + "\nelement vertex " +
                       std::to_string(std::count_if(points.begin(), points.end(), is_known)) +
                       "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar "
                       "green\nproperty uchar blue\nend_header\n";
   const int channels = colors.channels();
   auto point = points.begin();
   for (int y = 0; y < colors.rows; ++y)
      for (int x = 0; x < colors.cols; ++x, ++point) {
         if (!is_known(*point)) continue;
         if (binary)
            for (const float value : {point->x_m, point->y_m, point->z_m}) append(bytes, value);
         else bytes += text_of(*point);
         const uint8_t* const pixel = colors.ptr<uint8_t>(y) + std::ptrdiff_t(x) * channels;
         for (const int channel : {2, 1, 0}) {
            const uint8_t value = pixel[channels == 1 ? 0 : channel];
            if (binary) bytes += char(value);
            else bytes.append(" ").append(std::to_string(value));
         }
         if (!binary) bytes += '\n';
      }
   return bytes;
}

}  // namespace stereo::app
