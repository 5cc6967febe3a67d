// SPDX-License-Identifier: Apache-2.0
#include "program/rectification/map_table.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "program/errors.hpp"
#include "program/io/opencv_images.hpp"

namespace stereo::app {

using rectification::Table;
using rectification::Warp;

Table table_of(const RemapMaps& maps, const Warp& warp, const std::string& camera) {
   Table table(warp, maps.image.width, maps.image.height);
   const double unit = 1 << warp.offset_fraction_bits;
   const auto offset = [&](float to, int from) {
      const double steps = std::floor((double(to) - from) * unit + 0.5);
      if (!(steps >= -warp.largest_offset() - 1 && steps <= warp.largest_offset()))
         throw InputError("--calibration: its " + camera + " has pixels that move farther than the table's " +
                          std::to_string(warp.offset_bits) + " bits with " + std::to_string(warp.offset_fraction_bits) +
                          " fraction bits say; set more offset_bits or fewer offset_fraction_bits");
      return int(steps);
   };
   for (int j = 0; j < table.rows; ++j)
      for (int i = 0; i < table.columns; ++i) {
         const cv::Point pixel(i * warp.grid_px, j * warp.grid_px);
         table.at(i, j) = {offset(maps.x.at<float>(pixel), pixel.x), offset(maps.y.at<float>(pixel), pixel.y)};
      }
   return table;
}

namespace {

/// The largest and the mean of what is added.
class Differences {
  public:
   void add(double difference) {
      largest_ = std::max(largest_, difference);
      sum_ += difference;
      ++count_;
   }
   Difference result() const { return {largest_, count_ == 0 ? 0 : sum_ / double(count_)}; }

  private:
   double largest_ = 0, sum_ = 0;
   int64_t count_ = 0;
};

}  // namespace

Difference place_difference(const Table& table, const Warp& warp, const RemapMaps& maps) {
   const double unit = 1 << warp.weight_bits;
   const cv::Mat map_x = maps.image_x(), map_y = maps.image_y();
   Differences differences;
   for (int y = 0; y < maps.image.height; ++y)
      for (int x = 0; x < maps.image.width; ++x) {
         const double to_x = map_x.at<float>(y, x), to_y = map_y.at<float>(y, x);
         if (!(to_x >= 0 && to_x <= maps.image.width - 1 && to_y >= 0 && to_y <= maps.image.height - 1)) continue;
         const rectification::SourcePlace place = source_place(table, warp, x, y);
         differences.add(std::hypot(place.x / unit - to_x, place.y / unit - to_y));
      }
   return differences.result();
}

template <class Pixel>
Difference grey_difference(const RasterImage<Pixel>& rectified, const RasterImage<Pixel>& source,
                           const RemapMaps& maps) {
   RasterImage<Pixel> copy = source;
   cv::Mat remapped;
   cv::remap(as_mat(copy), remapped, maps.image_x(), maps.image_y(), cv::INTER_LINEAR);
   Differences differences;
   for (int y = 0; y < rectified.height; ++y)
      for (int x = 0; x < rectified.width; ++x)
         differences.add(std::abs(rectified.at(x, y) - remapped.at<Pixel>(y, x)));
   return differences.result();
}

template Difference grey_difference(const GrayImage&, const GrayImage&, const RemapMaps&);
template Difference grey_difference(const DeepImage&, const DeepImage&, const RemapMaps&);

}  // namespace stereo::app
