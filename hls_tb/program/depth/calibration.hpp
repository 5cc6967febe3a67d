// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace stereo::app {

/// What the distortion coefficients are.
enum class Lens : uint8_t {
   unsaid,     ///< the file does not say it: radial, unless the user says fisheye
   ambiguous,  ///< the same, but its names are those that both are written under
   radial,     ///< k1 k2 p1 p2 ... of cv::undistort
   fisheye     ///< k1 k2 k3 k4 of cv::fisheye, which others call equidistant
};

/// What OpenCV's stereo_calib sample writes into intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R T R1 R2 P1 P2 Q),
/// in double precision; what a file lacks is empty. Lengths are in the unit of T, whatever that was at the calibration.
struct Calibration {
   cv::Mat m1, d1, m2, d2;  ///< 3x3 camera matrices in pixels; distortion coefficients of the lens's model, or none
   cv::Mat r, t;            ///< 3x3 and 3x1: a point X of the left camera is R X + T to the right one
   cv::Mat p1, p2, q;       ///< 3x4, 3x4, 4x4: of the rectified pair
   Lens lens = Lens::unsaid;
   cv::Size image_size;       ///< of the images that the cameras were calibrated with; empty: the file does not say it
   cv::Size rectified_size;   ///< of the rectified ones, where the file tells them apart
   double unit_mm = 0;        ///< millimetres of one unit of T, where the format says it; else 0
   std::string unknown_unit;  ///< why there is no unit_mm, as a part of a sentence, where the format has one
};

/// Where a calibration stands.
struct CalibrationFiles {
   std::string path;        ///< a file of both cameras, or of the left one
   std::string right;       ///< of the right one, else empty: camera_info of ROS
   std::string extrinsics;  ///< whose matrices replace those of `path`, else empty
   bool fisheye = false;    ///< the user says so
};

/// Reads a YAML, XML or JSON file of OpenCV's, or of another format (calibration_formats.hpp), told by the content.
/// Throws InputError with one sentence on files that cannot be read, matrices of a wrong shape or with values that are
/// not finite, lenses that do not fit, and on files that take longer than `limit`; a good one takes some milliseconds.
/// What is returned has a lens that is known.
Calibration load_calibration(const CalibrationFiles& files, std::chrono::milliseconds limit = std::chrono::seconds(5));

/// The calibration for images of another size: `calibrated` is the size that the user gives, empty for none; else the
/// file's counts. Without a size, or where it is that of the images, the calibration itself. Throws InputError where
/// the file says another size than the user, where only the file says one and the images have another, and where the
/// images are no scaled ones.
Calibration fitted_calibration(const Calibration& calibration, cv::Size images, cv::Size calibrated);

}  // namespace stereo::app
