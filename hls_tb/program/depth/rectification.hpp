// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "program/depth/rectified_geometry.hpp"

namespace stereo::app {

/// A pair as cameras see it made a pair whose rows agree (cv::stereoRectify with alpha = 0: no pixel from outside the
/// cameras' images, and with CALIB_ZERO_DISPARITY: both principal points in the same column; of fisheye lenses
/// cv::fisheye::stereoRectify with balance = 0, which may leave corners from outside).
struct Rectification {
   cv::Mat left_x, left_y, right_x, right_y;  ///< maps of cv::remap
   RectifiedGeometry geometry;
   std::string warnings;  ///< sentences that end with a line feed, or nothing

   /// Any number of channels.
   cv::Mat left(const cv::Mat& image) const;
   cv::Mat right(const cv::Mat& image) const;
};

/// Needs M1, M2, R and T, and D1, D2 where the lenses distort. Throws InputError with one sentence when they are
/// missing, belong to images of another size or to cameras one above the other. The maps go on for `behind_px` columns
/// and rows behind the images.
Rectification make_rectification(const Calibration& calibration, int width_px, int height_px, int behind_px = 0);

}  // namespace stereo::app
