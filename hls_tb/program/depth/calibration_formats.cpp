// SPDX-License-Identifier: Apache-2.0
#include "program/depth/calibration_formats.hpp"

#include <stdexcept>

#include "program/depth/benchmark_calibration.hpp"
#include "program/depth/calibration_tree.hpp"
#include "program/depth/kalibr_calibration.hpp"
#include "program/depth/matlab_calibration.hpp"
#include "program/depth/ros_calibration.hpp"
#include "program/errors.hpp"
#include "program/io/plain_yaml.hpp"

namespace stereo::app {
namespace {

/// JSON or plain YAML; an empty string where it is neither.
Tree tree_of(const std::string& text) {
   if (Tree tree = Tree::parse(text, nullptr, false); !tree.is_discarded()) return tree;
   try {
      return parse_plain_yaml(text);
   } catch (const std::invalid_argument&) {
      return "";
   }
}

CameraInfo camera_of(const NamedText& file) {
   const Tree tree = tree_of(file.text);
   if (!is_camera_info(tree))
      throw InputError(file.name + ": is no camera_info of ROS, of which the right camera has a file of its own");
   try {
      return parse_camera_info(tree);
   } catch (const InputError& problem) {
      throw InputError(file.name + ": " + problem.what());
   }
}

}  // namespace

std::optional<Calibration> parse_calibration(const std::string& text) {
   if (auto found = parse_benchmark_calibration(text)) return found;
   const Tree tree = tree_of(text);
   for (const auto& parse : {parse_ros_pair, parse_kalibr, parse_matlab})
      if (auto found = parse(tree)) return found;
   if (is_camera_info(tree))
      throw InputError("is of one camera: give the left one's file here and the right one's as --right-calibration");
   return std::nullopt;
}

Calibration parse_calibrations(const NamedText& left, const NamedText& right) {
   const CameraInfo first = camera_of(left), second = camera_of(right);
   try {
      return pair_of(first, second);
   } catch (const InputError& problem) {
      throw InputError(left.name + ": with " + right.name + ", " + problem.what());
   }
}

}  // namespace stereo::app
