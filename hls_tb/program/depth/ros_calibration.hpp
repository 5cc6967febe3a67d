// SPDX-License-Identifier: Apache-2.0
// camera_info of ROS: a YAML file a camera, as camera_calibration writes it or a message is printed.
#pragma once

#include <optional>

#include "program/depth/calibration_tree.hpp"

namespace stereo::app {

/// One camera of a pair.
struct CameraInfo {
   cv::Mat m, d, r, p;  ///< camera matrix, coefficients or none, the turn that rectifies, 3x4 of the rectified camera
   cv::Size size;
   Lens lens;
};

bool is_camera_info(const Tree& tree);
/// Throws InputError, as all below: one sentence without a file name.
CameraInfo parse_camera_info(const Tree& tree);
/// The pair that both belong to, lengths in metres: where the right camera stands follows from both turns and the
/// fourth column of its P.
Calibration pair_of(const CameraInfo& left, const CameraInfo& right);
/// Of a tree with both cameras, as `left` and `right`; nothing where it is another one.
std::optional<Calibration> parse_ros_pair(const Tree& tree);

}  // namespace stereo::app
