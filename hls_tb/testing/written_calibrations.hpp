// SPDX-License-Identifier: Apache-2.0
// Calibrations as OpenCV, ROS, Kalibr and MATLAB write them, of two cameras.
#pragma once

#include <functional>
#include <iomanip>
#include <opencv2/calib3d.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/memory_file.hpp"
#include "program/depth/calibration.hpp"
#include "scene/random.hpp"

namespace stereo::test {

inline const cv::Size kCameraSize(320, 240);

/// Two cameras, 5 or 4 coefficients each, and what cv::stereoRectify makes of them.
struct Pair {
   cv::Mat m1, d1, m2, d2, r, t;
   cv::Mat r1, r2, p1, p2, q;
   bool fisheye = false;
};

inline cv::Mat turn(double x, double y, double z) {
   cv::Mat r;
   cv::Rodrigues(cv::Vec3d(x, y, z), r);
   return r;
}

inline void add_rectification(Pair& pair) {
   pair.r1 = pair.r2 = pair.p1 = pair.p2 = pair.q = cv::Mat();  // copies of a pair share their matrices
   if (pair.fisheye)
      cv::fisheye::stereoRectify(pair.m1, pair.d1, pair.m2, pair.d2, kCameraSize, pair.r, pair.t, pair.r1, pair.r2,
                                 pair.p1, pair.p2, pair.q, cv::CALIB_ZERO_DISPARITY, kCameraSize, 0);
   else
      cv::stereoRectify(pair.m1, pair.d1, pair.m2, pair.d2, kCameraSize, pair.r, pair.t, pair.r1, pair.r2, pair.p1,
                        pair.p2, pair.q, cv::CALIB_ZERO_DISPARITY, 0, kCameraSize);
}

/// Whole numbers, so that they can be found in a text.
inline Pair simple_pair(bool fisheye = false) {
   Pair pair;
   pair.m1 = pair.m2 = (cv::Mat_<double>(3, 3) << 200, 0, 160, 0, 201, 120, 0, 0, 1);
   pair.d1 =
       fisheye ? (cv::Mat_<double>(1, 4) << 0.01, 0.02, 0.03, 0.04) : (cv::Mat_<double>(1, 5) << -0.25, 0.5, 0, 0, 0);
   pair.d2 = pair.d1.clone();
   pair.r = cv::Mat::eye(3, 3, CV_64F);
   pair.t = (cv::Mat_<double>(3, 1) << -0.125, 0, 0);
   pair.r1 = pair.r2 = pair.r;
   pair.p1 = (cv::Mat_<double>(3, 4) << 190, 0, 160, 0, 0, 190, 120, 0, 0, 0, 1, 0);
   pair.p2 = (cv::Mat_<double>(3, 4) << 190, 0, 160, -19, 0, 190, 120, 0, 0, 0, 1, 0);
   pair.fisheye = fisheye;
   return pair;
}

inline std::string list(const cv::Mat& matrix) {
   std::ostringstream text;
   text << std::setprecision(17) << '[';
   for (int i = 0; i < int(matrix.total()); ++i) text << (i > 0 ? ", " : "") << matrix.at<double>(i);
   text << ']';
   return text.str();
}

/// Of any matrix, a row a line behind `start`.
inline std::string rows(const cv::Mat& matrix, const std::string& start, const std::string& end) {
   std::string text;
   for (int i = 0; i < matrix.rows; ++i)
      text.append(start).append(list(matrix.row(i))).append(i + 1 < matrix.rows ? end : "");
   return text;
}

inline std::string nested(const cv::Mat& matrix) { return "[" + rows(matrix, "", ",") + "]"; }

inline std::string ros_matrix(const std::string& name, const cv::Mat& matrix) {
   return name + ":\n  rows: " + std::to_string(matrix.rows) + "\n  cols: " + std::to_string(matrix.cols) +
          "\n  data: " + list(matrix) + "\n";
}

/// A file of camera_calibration.
inline std::string ros_file(const Pair& pair, bool left) {
   return "image_width: 320\nimage_height: 240\ncamera_name: narrow_stereo/" + std::string(left ? "left" : "right") +
          "\n" + ros_matrix("camera_matrix", left ? pair.m1 : pair.m2) +
          (pair.fisheye ? "distortion_model: equidistant\n" : "distortion_model: plumb_bob\n") +
          ros_matrix("distortion_coefficients", left ? pair.d1 : pair.d2) +
          ros_matrix("rectification_matrix", left ? pair.r1 : pair.r2) +
          ros_matrix("projection_matrix", left ? pair.p1 : pair.p2);
}

/// A message, as `ros2 topic echo` prints it.
inline std::string ros_message(const Pair& pair, bool left) {
   const auto items = [](const std::string& name, const cv::Mat& matrix) {
      return name + ":\n" + rows(matrix.reshape(1, int(matrix.total())), "- ", "\n") + "\n";
   };
   std::string text =
       "header:\n  stamp:\n    sec: 1\n    nanosec: 2\n  frame_id: 'camera: left # 1'\nheight: 240\nwidth: 320\n";
   text += pair.fisheye ? "distortion_model: equidistant\n" : "distortion_model: plumb_bob\n";
   for (const auto& [name, matrix] : {std::pair{"d", left ? pair.d1 : pair.d2},
                                      {"k", left ? pair.m1 : pair.m2},
                                      {"r", left ? pair.r1 : pair.r2},
                                      {"p", left ? pair.p1 : pair.p2}})
      text += items(name, matrix);
   text +=
       "binning_x: 0\nbinning_y: 0\nroi:\n  x_offset: 0\n  y_offset: 0\n  height: 0\n  width: 0\n  do_rectify: "
       "false\n---\n";
   // A message has plain numbers behind its dashes.
   for (std::size_t at = 0; (at = text.find("- [", at)) != std::string::npos;) text.erase(at + 2, 1);
   for (std::size_t at = 0; (at = text.find("]\n", at)) != std::string::npos;) text.erase(at, 1);
   return text;
}

/// Both cameras in one file, further to the right.
inline std::string ros_both(const Pair& pair) {
   std::string text = "# both cameras\n";
   for (const bool left : {true, false}) {
      text += left ? "left:\n" : "right:\n";
      std::istringstream lines(ros_file(pair, left));
      for (std::string line; std::getline(lines, line);) text += "   " + line + "\n";
   }
   return text;
}

inline cv::Mat motion_of(const cv::Mat& r, const cv::Mat& t) {
   cv::Mat motion = cv::Mat::eye(4, 4, CV_64F);
   r.copyTo(motion(cv::Rect(0, 0, 3, 3)));
   t.copyTo(motion(cv::Rect(3, 0, 1, 3)));
   return motion;
}

enum class Chain { direct, imu, both };

/// Kalibr has four coefficients.
inline std::string kalibr(const Pair& pair, Chain chain = Chain::direct) {
   const cv::Mat imu = motion_of(turn(1, -2, 0.5), (cv::Mat_<double>(3, 1) << 0.3, -0.2, 0.1));
   const cv::Mat motion = motion_of(pair.r, pair.t);
   std::string text;
   for (const bool left : {true, false}) {
      const cv::Mat &m = left ? pair.m1 : pair.m2, &d = left ? pair.d1 : pair.d2;
      text += left ? "cam0:\n  cam_overlaps: [1]\n" : "cam1:\n";
      if (!left && chain != Chain::imu) text += "  T_cn_cnm1:\n" + rows(motion, "  - ", "\n") + "\n";
      if (chain != Chain::direct)
         text += "  T_cam_imu:\n" + rows(left ? imu : cv::Mat(motion * imu), "  - ", "\n") + "\n";
      if (!left) text += "  cam_overlaps: [0]\n";
      text += "  camera_model: pinhole\n  distortion_coeffs: " + list(d.colRange(0, 4)) +
              "\n  distortion_model: " + (pair.fisheye ? "equidistant" : "radtan") + "\n  intrinsics: " +
              list((cv::Mat_<double>(1, 4) << m.at<double>(0, 0), m.at<double>(1, 1), m.at<double>(0, 2),
                    m.at<double>(1, 2))) +
              "\n  resolution: [320, 240]\n  rostopic: /cam" + (left ? "0" : "1") + "/image_raw\n";
   }
   return text;
}

enum class Release { rows, columns, both };

/// Lengths in millimetres, the first pixel is 1.
inline std::string matlab(const Pair& pair, Release release = Release::both) {
   const cv::Mat t = 1000 * pair.t;
   const auto camera = [&](const cv::Mat& zero_based, const cv::Mat& d) {
      cv::Mat m = zero_based.clone();
      m.at<double>(0, 2) += 1;
      m.at<double>(1, 2) += 1;
      const cv::Mat radial = (cv::Mat_<double>(1, 3) << d.at<double>(0), d.at<double>(1), d.at<double>(4));
      std::string text = "{\"ImageSize\":[240,320],\"RadialDistortion\":" + list(radial) +
                         ",\"TangentialDistortion\":" + list(d.colRange(2, 4)) + ",\"WorldUnits\":\"millimeters\"";
      if (release != Release::columns) text += ",\"IntrinsicMatrix\":" + nested(m.t());
      if (release != Release::rows) text += ",\"K\":" + nested(m);
      return text + ",\"ReprojectionErrors\":[[[0.1]],null]}";
   };
   std::string text =
       R"({"CameraParameters1":)" + camera(pair.m1, pair.d1) + R"(,"CameraParameters2":)" + camera(pair.m2, pair.d2);
   if (release != Release::columns)
      text += ",\"RotationOfCamera2\":" + nested(pair.r.t()) + ",\"TranslationOfCamera2\":" + list(t);
   if (release != Release::rows)
      text += ",\"PoseCamera2\":{\"Dimensionality\":3,\"R\":" + nested(pair.r) + ",\"Translation\":" + list(t) + "}";
   return text + ",\"WorldUnits\":\"millimeters\"}";
}

inline std::string opencv_matrix(const std::string& name, const cv::Mat& matrix) {
   return name + ": !!opencv-matrix\n   rows: " + std::to_string(matrix.rows) +
          "\n   cols: " + std::to_string(matrix.cols) + "\n   dt: d\n   data: " + list(matrix) + "\n";
}

/// As programs around cv::fisheye write it, or others.
inline std::string opencv(const Pair& pair, const std::string& m, const std::string& more = "") {
   return "%YAML:1.0\n---\n" + opencv_matrix(m + "1", pair.m1) + opencv_matrix(m + "2", pair.m2) +
          "D1: " + list(pair.d1) + "\nD2: " + list(pair.d2) + "\n" + opencv_matrix("R", pair.r) + "T: " + list(pair.t) +
          "\n" + more;
}

struct Written {
   std::string left, right;  ///< empty: one file
   bool fisheye = false;     ///< said by the user
};

inline app::Calibration load_written(const Written& written) {
   const fuzz::MemoryFile left(written.left), right(written.right);
   return app::load_calibration({left.path(), written.right.empty() ? "" : right.path(), "", written.fisheye});
}

inline cv::Mat drawn_camera(Random& random) {
   const double focal = random.between(180, 260);
   return (cv::Mat_<double>(3, 3) << focal, 0, random.between(150, 170), 0, focal * random.between(0.98, 1.02),
           random.between(110, 130), 0, 0, 1);
}

inline cv::Mat drawn_coefficients(Random& random, bool fisheye) {
   if (fisheye)
      return (cv::Mat_<double>(1, 4) << random.between(-0.05, 0.05), random.between(-0.02, 0.02),
              random.between(-0.01, 0.01), random.between(-0.005, 0.005));
   return (cv::Mat_<double>(1, 5) << random.between(-0.3, 0.1), random.between(-0.05, 0.05),
           random.between(-0.002, 0.002), random.between(-0.002, 0.002), random.between(-0.01, 0.01));
}

inline Pair random_pair(Random& random, bool fisheye) {
   const auto angle = [&random] { return random.between(-0.04, 0.04); };
   Pair pair;
   pair.m1 = drawn_camera(random);
   pair.m2 = drawn_camera(random);
   pair.d1 = drawn_coefficients(random, fisheye);
   pair.d2 = drawn_coefficients(random, fisheye);
   const double x = angle(), y = angle(), z = angle();
   pair.r = turn(x, y, z);
   pair.t = (cv::Mat_<double>(3, 1) << random.between(-0.2, -0.05), random.between(-0.004, 0.004),
             random.between(-0.004, 0.004));
   pair.fisheye = fisheye;
   add_rectification(pair);
   return pair;
}

}  // namespace stereo::test
