// SPDX-License-Identifier: Apache-2.0
#include "program/depth/kalibr_calibration.hpp"

#include <opencv2/core.hpp>

#include "definition/gray_image.hpp"
#include "program/depth/rectified_geometry.hpp"
#include "program/errors.hpp"
#include "program/io/shown_word.hpp"

namespace stereo::app {
namespace {

struct Camera {
   cv::Mat m, d;
   cv::Size size;
   Lens lens;
};

std::vector<double> numbers_at(const Tree& tree, const char* name, std::size_t count) {
   std::vector<double> numbers = numbers_of(required_member(tree, {name}), name);
   if (numbers.size() != count)
      throw InputError(std::string("its ") + name + " is not " + std::to_string(count) + " numbers");
   return numbers;
}

Camera camera_of(const Tree& tree) {
   if (const std::string model = word_at(tree, "camera_model"); model != "pinhole")
      throw InputError("its camera_model is " + (model.empty() ? "missing" : shown_word(model)) +
                       ", but only pinhole, with the distortion_model radtan or equidistant, is known");
   const std::vector<double> intrinsics = numbers_at(tree, "intrinsics", 4), size = numbers_at(tree, "resolution", 2);
   Camera camera;
   camera.m = (cv::Mat_<double>(3, 3) << intrinsics[0], 0, intrinsics[2], 0, intrinsics[1], intrinsics[3], 0, 0, 1);
   require_camera_matrix("what its intrinsics fu fv pu pv make", camera.m);
   camera.size = {side_of(size[0], "resolution"), side_of(size[1], "resolution")};
   const std::string model = word_at(tree, "distortion_model");
   camera.lens = model == "none" ? Lens::radial : lens_of_word(model);
   const Tree* const coefficients = member(tree, {"distortion_coeffs"});
   if (model == "none" || coefficients == nullptr) return camera;
   if (camera.lens == Lens::unsaid) throw InputError("it has distortion_coeffs but no distortion_model");
   camera.d = distortion_of(numbers_of(*coefficients, "distortion_coeffs"), camera.lens, "distortion_coeffs");
   return camera;
}

/// A motion: a rotation and a translation above 0 0 0 1.
cv::Mat motion_of(const Tree& node, const std::string& name) {
   cv::Mat motion = matrix_of(node, 4, 4, name);
   if (cv::norm(motion.row(3), cv::Mat((cv::Mat_<double>(1, 4) << 0, 0, 0, 1)), cv::NORM_INF) > 0)
      throw InputError("its " + name + " is not a motion of a camera: row 4 must be 0 0 0 1; is it transposed?");
   require_rotation("its " + name, motion(cv::Rect(0, 0, 3, 3)));
   return motion;
}

/// From the left camera to the right one.
cv::Mat motion_between(const Tree& left, const Tree& right) {
   const Tree *const chain = member(right, {"T_cn_cnm1"}), *const left_imu = member(left, {"T_cam_imu"}),
                     *const right_imu = member(right, {"T_cam_imu"});
   const cv::Mat direct = chain == nullptr ? cv::Mat() : motion_of(*chain, "T_cn_cnm1");
   if (left_imu == nullptr || right_imu == nullptr) {
      if (direct.empty()) throw InputError("it has no T_cn_cnm1 of cam1");
      return direct;
   }
   cv::Mat by_imu = motion_of(*right_imu, "T_cam_imu") * motion_of(*left_imu, "T_cam_imu").inv();
   constexpr double kLargest = 0.01;  // metres and radians
   if (!direct.empty() && cv::norm(direct, by_imu, cv::NORM_INF) > kLargest)
      throw InputError("its T_cn_cnm1 is another motion than its T_cam_imu say");
   return direct.empty() ? by_imu : direct;
}

}  // namespace

std::optional<Calibration> parse_kalibr(const Tree& tree) {
   const Tree *const left = member(tree, {"cam0"}), *const right = member(tree, {"cam1"});
   const Tree* const any = left != nullptr ? left : right;
   if (any == nullptr || member(*any, {"camera_model", "intrinsics"}) == nullptr) return std::nullopt;
   if (left == nullptr || right == nullptr)
      throw InputError(std::string("it has no ") + (left == nullptr ? "cam0" : "cam1"));
   if (tree.contains("cam2"))
      throw InputError(
          "it has more than two cameras: leave the pair in it, the left camera as cam0, the right one as cam1");
   const auto camera = [](const Tree& node, const char* name) {
      try {
         return camera_of(node);
      } catch (const InputError& problem) {
         throw InputError(std::string("of ") + name + ", " + problem.what());
      }
   };
   const Camera first = camera(*left, "cam0"), second = camera(*right, "cam1");
   if (first.size != second.size)
      throw InputError("its cameras have images of " + size_text(first.size) + " and " + size_text(second.size));
   if (first.lens != second.lens) throw InputError("its cameras have different distortion models");
   const cv::Mat motion = motion_between(*left, *right);
   Calibration pair;
   pair.m1 = first.m;
   pair.m2 = second.m;
   pair.d1 = first.d;
   pair.d2 = second.d;
   pair.r = motion(cv::Rect(0, 0, 3, 3)).clone();
   pair.t = motion(cv::Rect(3, 0, 1, 3)).clone();
   pair.image_size = first.size;
   pair.lens = first.lens;
   pair.unit_mm = 1000;
   return pair;
}

}  // namespace stereo::app
