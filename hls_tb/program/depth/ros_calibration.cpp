// SPDX-License-Identifier: Apache-2.0
#include "program/depth/ros_calibration.hpp"

#include <cmath>
#include <opencv2/core.hpp>
#include <sstream>

#include "definition/gray_image.hpp"
#include "program/depth/rectified_geometry.hpp"
#include "program/errors.hpp"

namespace stereo::app {
namespace {

// Files of camera_calibration, messages of ROS 1, messages of ROS 2.
using Names = std::initializer_list<const char*>;
constexpr Names kCamera = {"camera_matrix", "K", "k"}, kDistortion = {"distortion_coefficients", "D", "d"},
                kTurn = {"rectification_matrix", "R", "r"}, kProjection = {"projection_matrix", "P", "p"},
                kWidth = {"image_width", "width"}, kHeight = {"image_height", "height"};

const char* name_of(const Tree& tree, Names names) {
   for (const char* const name : names)
      if (tree.contains(name)) return name;
   return *names.begin();
}

cv::Mat matrix_at(const Tree& tree, Names names, int rows, int columns) {
   return matrix_of(required_member(tree, names), rows, columns, name_of(tree, names));
}

int side_at(const Tree& tree, Names names) {
   const std::vector<double> side = numbers_of(required_member(tree, names), name_of(tree, names));
   return side_of(side.size() == 1 ? side[0] : 0, name_of(tree, names));
}

/// Nothing where the node is missing.
double number_at(const Tree& tree, const char* name) {
   const Tree* const node = member(tree, {name});
   const std::vector<double> numbers = node == nullptr ? std::vector<double>() : numbers_of(*node, name);
   return numbers.size() == 1 ? numbers[0] : 0;
}

/// Images of a part of the sensor have other matrices than those of the message.
void require_whole_images(const Tree& tree, cv::Size size) {
   const Tree* const part = member(tree, {"roi"});
   bool whole = number_at(tree, "binning_x") <= 1 && number_at(tree, "binning_y") <= 1;
   if (part != nullptr && part->is_object()) {
      const double width = number_at(*part, "width"), height = number_at(*part, "height");
      whole = whole && number_at(*part, "x_offset") == 0 && number_at(*part, "y_offset") == 0 &&
              (width == 0 || width == size.width) && (height == 0 || height == size.height);
   }
   if (!whole)
      throw InputError(
          "its binning or roi says that the images are binned or a part of the calibrated ones, which "
          "is not supported");
}

/// Coefficients of the tree's own number; rows and cols of a file are not looked at.
cv::Mat distortion_at(const Tree& tree, Lens lens) {
   const Tree* node = member(tree, kDistortion);
   const char* const name = name_of(tree, kDistortion);
   if (node != nullptr && node->is_object()) node = &required_member(*node, {"data"});
   if (node == nullptr || (node->is_string() && node->get_ref<const std::string&>().empty())) return {};
   return distortion_of(numbers_of(*node, name), lens, name);
}

void require_projection(const cv::Mat& p, const char* name) {
   require_camera_matrix(std::string("its ") + name, p.colRange(0, 3));
   if (p.at<double>(2, 3) != 0)
      throw InputError(std::string("its ") + name + " is not that of a rectified camera: row 3, column 4 must be 0");
}

bool are_close(double a, double b, double scale) {
   constexpr double kTolerance = 0.01;
   return std::abs(a - b) <= kTolerance * scale;
}

}  // namespace

bool is_camera_info(const Tree& tree) {
   if (!tree.is_object()) return false;
   return tree.contains("camera_matrix") ||
          ((tree.contains("K") || tree.contains("k")) && (tree.contains("P") || tree.contains("p")));
}

CameraInfo parse_camera_info(const Tree& tree) {
   CameraInfo camera;
   camera.size = {side_at(tree, kWidth), side_at(tree, kHeight)};
   require_whole_images(tree, camera.size);
   camera.m = matrix_at(tree, kCamera, 3, 3);
   if (cv::countNonZero(camera.m) == 0) throw InputError("it is of a camera that was not calibrated");
   require_camera_matrix(std::string("its ") + name_of(tree, kCamera), camera.m);
   camera.lens = lens_of_word(word_at(tree, "distortion_model"));
   camera.d = distortion_at(tree, camera.lens);
   if (!camera.d.empty() && camera.lens == Lens::unsaid)
      throw InputError("it has coefficients but no distortion_model");
   camera.r = matrix_at(tree, kTurn, 3, 3);
   require_rotation(std::string("its ") + name_of(tree, kTurn), camera.r);
   camera.p = matrix_at(tree, kProjection, 3, 4);
   require_projection(camera.p, name_of(tree, kProjection));
   return camera;
}

Calibration pair_of(const CameraInfo& left, const CameraInfo& right) {
   if (left.size != right.size)
      throw InputError("its cameras have images of " + size_text(left.size) + " and " + size_text(right.size));
   if (left.lens != right.lens && !left.d.empty() && !right.d.empty())
      throw InputError("its cameras have different distortion models");
   const auto entry = [](const CameraInfo& camera, int row, int column) { return camera.p.at<double>(row, column); };
   const double focal = entry(left, 0, 0);
   if (!are_close(focal, entry(right, 0, 0), focal) || !are_close(entry(left, 1, 1), entry(right, 1, 1), focal) ||
       !are_close(entry(left, 1, 2), entry(right, 1, 2), 100))
      throw InputError(
          "the projection matrices of its cameras have different focal lengths or rows: they are not of one "
          "calibration "
          "of a pair");
   const auto place = [&](const CameraInfo& camera) {
      return cv::Vec3d(entry(camera, 0, 3) / entry(camera, 0, 0), entry(camera, 1, 3) / entry(camera, 1, 1), 0);
   };
   const cv::Vec3d to_right = place(right) - place(left);
   if (to_right == cv::Vec3d(0, 0, 0))
      throw InputError(
          "the projection matrices of its cameras have no baseline in their fourth column: each camera was calibrated "
          "for itself, but a pair is needed");
   if (to_right[0] > 0)
      throw InputError(
          "its left camera stands to the right of the right one: exchange the files, and --left and --right where "
          "these "
          "are exchanged, too");
   Calibration pair;
   pair.m1 = left.m;
   pair.m2 = right.m;
   pair.d1 = left.d;
   pair.d2 = right.d;
   pair.p1 = left.p;
   pair.p2 = right.p;
   // Rectified, a point X of the left camera is r1 X, and seen from the right one r1 X + to_right = r2 X'.
   pair.r = right.r.t() * left.r;
   pair.t = right.r.t() * cv::Mat(to_right);
   pair.image_size = left.size;
   pair.lens = left.d.empty() ? right.lens : left.lens;
   pair.unit_mm = 1000;
   return pair;
}

std::optional<Calibration> parse_ros_pair(const Tree& tree) {
   const Tree *const left = member(tree, {"left"}), *const right = member(tree, {"right"});
   if (left == nullptr || right == nullptr || (!is_camera_info(*left) && !is_camera_info(*right))) return std::nullopt;
   const auto camera = [](const Tree& node, const char* side) {
      try {
         return parse_camera_info(node);
      } catch (const InputError& problem) {
         throw InputError(std::string("of its ") + side + " camera, " + problem.what());
      }
   };
   return pair_of(camera(*left, "left"), camera(*right, "right"));
}

}  // namespace stereo::app
