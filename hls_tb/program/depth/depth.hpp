// SPDX-License-Identifier: Apache-2.0
// Disparities in metres.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "program/depth/rectified_geometry.hpp"
#include "program/io/disparity_image.hpp"

namespace stereo::app {

/// A place in space in metres, seen from the rectified left camera: x to the right, y down, z forward, unless the
/// geometry has other axes.
struct Point {
   float x_m, y_m, z_m;
};

/// The points of a disparity image, one for each pixel in raster order; z_m = 0 where there is none or where it would
/// be at infinity or behind the camera. Others are those of cv::reprojectImageTo3D. `reference`: which image's pixels
/// the disparities belong to.
std::vector<Point> points_of(const DisparityImage& disparity, Reference reference, const RectifiedGeometry& geometry,
                             double metres_per_unit);

/// Points that are nearer or farther become unknown. How many.
int keep_depths(std::vector<Point>& points, double least_m, double largest_m);

inline constexpr int kLargestDepthMm = 65535;

/// Depth, the size of z, in whole millimetres, 0: unknown or farther than kLargestDepthMm. CV_16U.
cv::Mat depth_image(const std::vector<Point>& points, int width_px, int height_px);

/// The same as floats, CV_32F, without a farthest one.
cv::Mat float_depth_image(const std::vector<Point>& points, int width_px, int height_px);

enum class PlyFormat { binary, ascii };
/// A point cloud as PLY, binary little endian or text: x, y, z in metres and red, green, blue of each point that is
/// known. `colors`: the reference image, 8 bits, 1, 3 or 4 channels (blue first; the fourth is ignored). `axes`: for
/// its comment.
std::string encode_ply(const std::vector<Point>& points, const cv::Mat& colors, const std::string& axes,
                       PlyFormat format = PlyFormat::binary);
/// Where a geometry's points stand, as words.
std::string axes_of(const RectifiedGeometry& geometry);

}  // namespace stereo::app
