// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <opencv2/core/mat.hpp>
#include <string>

namespace stereo::app {

/// What OpenCV's stereo_calib sample writes into intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R T R1 R2 P1 P2 Q),
/// in double precision; what a file lacks is empty. Lengths are in the unit of T, whatever that was at the calibration.
struct Calibration {
   cv::Mat m1, d1, m2, d2;  ///< 3x3 camera matrices in pixels; 1 to 14 distortion coefficients, none: no distortion
   cv::Mat r, t;            ///< 3x3 and 3x1: a point X of the left camera is R X + T to the right one
   cv::Mat p1, p2, q;       ///< 3x4, 3x4, 4x4: of the rectified pair
};

/// Reads a YAML, XML or JSON file of OpenCV's and, where the name is not empty, a second one, whose matrices replace
/// those of the first. Throws InputError with one sentence on files that cannot be read and matrices of a wrong shape
/// or with values that are not finite, and on files that take longer than `limit`; a good one takes some milliseconds.
Calibration load_calibration(const std::string& path, const std::string& extrinsics_path,
                             std::chrono::milliseconds limit = std::chrono::seconds(5));

/// A rectified pair in space, lengths in the calibration's unit.
struct RectifiedGeometry {
   double focal_px = 0;          ///< above 0
   double baseline = 0;          ///< above 0: the right camera stands to the right
   double cx_px = 0, cy_px = 0;  ///< principal point of the left image
   double cx_difference_px = 0;  ///< the left principal point's column minus the right one's: the disparity at infinity
};

/// Of images that are rectified already: from Q, else from P1 and P2, else from M1, M2 and T. Throws InputError.
RectifiedGeometry rectified_geometry(const Calibration& calibration);
/// Of a pair whose rows agree, which Q does not say. Throws InputError unless Q has a focal length and a baseline and
/// its right camera stands to the right.
RectifiedGeometry geometry_of_q(const cv::Mat& q);

}  // namespace stereo::app
