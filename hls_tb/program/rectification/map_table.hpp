// SPDX-License-Identifier: Apache-2.0
// Float maps of cv::remap made the table of the integer rectification, and how far the two are apart.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "definition/rectification/reference_model.hpp"

namespace stereo::app {

/// One camera's maps of cv::remap. They go on behind the image for grid_px columns and rows: there are nodes.
struct RemapMaps {
   const cv::Mat& x;
   const cv::Mat& y;
   cv::Size image;

   /// Of the image alone.
   cv::Mat image_x() const { return x(cv::Rect(cv::Point(), image)); }
   cv::Mat image_y() const { return y(cv::Rect(cv::Point(), image)); }
};

/// Throws InputError where an offset has more bits than the table's; `camera` is its subject, such as "left camera".
rectification::Table table_of(const RemapMaps& maps, const rectification::Warp& warp, const std::string& camera);

struct Difference {
   double largest = 0;
   double mean = 0;
};

/// Between the places of the table and those of the maps, in pixels, where the maps stay inside the camera's image.
Difference place_difference(const rectification::Table& table, const rectification::Warp& warp, const RemapMaps& maps);

/// Between a rectified image and the one that cv::remap makes of the same (INTER_LINEAR, 0 outside), in grey levels: of
/// as many bits as the images have. Pixel: uint8_t or uint16_t.
template <class Pixel>
Difference grey_difference(const RasterImage<Pixel>& rectified, const RasterImage<Pixel>& source,
                           const RemapMaps& maps);

}  // namespace stereo::app
