// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <opencv2/core/mat.hpp>
#include <string>

namespace stereo::app {

/// What OpenCV's stereo_calib sample writes into intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R T R1 R2 P1 P2 Q),
/// in double precision; what a file lacks is empty. Lengths are in the unit of T, whatever that was at the calibration.
struct Calibration {
   cv::Mat m1, d1, m2, d2;   ///< 3x3 camera matrices in pixels; 4, 5, 8, 12 or 14 distortion coefficients, or none
   cv::Mat r, t;             ///< 3x3 and 3x1: a point X of the left camera is R X + T to the right one
   cv::Mat p1, p2, q;        ///< 3x4, 3x4, 4x4: of the rectified pair
   cv::Size image_size;      ///< of the images that the cameras were calibrated with; empty: the file does not say it
   cv::Size rectified_size;  ///< of the rectified ones, where the file tells them apart
   double unit_mm = 0;       ///< millimetres of one unit of T, where the format says it; else 0
};

/// Reads a YAML, XML or JSON file of OpenCV's, or a benchmark's text (benchmark_calibration.hpp), and, where the name
/// is not empty, a second one, whose matrices replace those of the first. Throws InputError with one sentence on files
/// that cannot be read and matrices of a wrong shape or with values that are not finite, and on files that take longer
/// than `limit`; a good one takes some milliseconds.
Calibration load_calibration(const std::string& path, const std::string& extrinsics_path,
                             std::chrono::milliseconds limit = std::chrono::seconds(5));

/// The calibration for images of another size: `calibrated` is the size that the user gives, empty for none; else the
/// file's counts. Without a size, or where it is that of the images, the calibration itself. Throws InputError where
/// the file says another size than the user, where only the file says one and the images have another, and where the
/// images are no scaled ones.
Calibration fitted_calibration(const Calibration& calibration, cv::Size images, cv::Size calibrated);

}  // namespace stereo::app
