// SPDX-License-Identifier: Apache-2.0
#include "program/depth/matlab_calibration.hpp"

#include <map>
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
};

/// {WorldUnits: millimetres}
const std::map<std::string, double> kUnits{
    {"mm", 1},           {"millimeter", 1},   {"millimeters", 1}, {"millimetres", 1}, {"cm", 10},
    {"centimeters", 10}, {"centimetres", 10}, {"m", 1000},        {"meter", 1000},    {"meters", 1000},
    {"metres", 1000},    {"in", 25.4},        {"inch", 25.4},     {"inches", 25.4}};

/// As jsonencode writes it: a list of rows.
cv::Mat matrix_at(const Tree& node, int rows, int columns, const std::string& name) {
   if (!node.is_array() || node.empty() || !node.front().is_array())
      throw InputError("its " + name + " is not a list of rows, as jsonencode writes a matrix");
   return matrix_of(node, rows, columns, name);
}

/// The one that is there; both must be the same. Empty where there is none.
cv::Mat agreed(const cv::Mat& a, const cv::Mat& b, const std::string& names) {
   if (a.empty() || b.empty()) return a.empty() ? b : a;
   if (cv::norm(a, b, cv::NORM_INF) > 1e-6 * cv::norm(a, cv::NORM_INF))
      throw InputError("its " + names + " say different things");
   return a;
}

cv::Mat camera_matrix(const Tree& tree) {
   cv::Mat columns, rows;
   if (const Tree* const node = member(tree, {"K"})) {
      columns = matrix_at(*node, 3, 3, "K");
      require_camera_matrix("its K", columns);
   }
   if (const Tree* const node = member(tree, {"IntrinsicMatrix"})) {
      rows = matrix_at(*node, 3, 3, "IntrinsicMatrix").t();
      require_camera_matrix("transposed, as MATLAB has it, its IntrinsicMatrix", rows);
   }
   cv::Mat camera = agreed(columns, rows, "K and IntrinsicMatrix");
   if (camera.empty()) throw InputError("it has neither K nor IntrinsicMatrix");
   camera = camera.clone();
   camera.at<double>(0, 2) -= 1;
   camera.at<double>(1, 2) -= 1;
   return camera;
}

cv::Mat distortion(const Tree& tree) {
   std::vector<double> radial = numbers_of(required_member(tree, {"RadialDistortion"}), "RadialDistortion");
   const std::vector<double> tangential =
       numbers_of(required_member(tree, {"TangentialDistortion"}), "TangentialDistortion");
   if ((radial.size() != 2 && radial.size() != 3) || tangential.size() != 2)
      throw InputError("its RadialDistortion is not 2 or 3 numbers, or its TangentialDistortion not 2");
   radial.insert(radial.begin() + 2, tangential.begin(), tangential.end());
   return distortion_of(radial, Lens::radial, "RadialDistortion");
}

Camera camera_of(const Tree& tree) {
   const Tree* const intrinsics = member(tree, {"Intrinsics"});
   if (member(tree, {"MappingCoefficients"}) || (intrinsics && member(*intrinsics, {"MappingCoefficients"})))
      throw InputError("it is of MATLAB's fisheye model, MappingCoefficients, which is not known");
   Camera camera{camera_matrix(tree), distortion(tree), {}};
   const Tree* const size = member(tree, {"ImageSize"});
   if (size == nullptr || size->empty()) return camera;
   const std::vector<double> sides = numbers_of(*size, "ImageSize");
   if (sides.size() != 2) throw InputError("its ImageSize is not 2 numbers");
   camera.size = {side_of(sides[1], "ImageSize"), side_of(sides[0], "ImageSize")};
   return camera;
}

cv::Mat translation_of(const Tree& node, const std::string& name) {
   const Tree& row = node.is_array() && node.size() == 1 ? node.front() : node;
   const std::vector<double> numbers = numbers_of(row, name);
   if (numbers.size() != 3) throw InputError("its " + name + " is not 3 numbers");
   return cv::Mat(numbers, true);
}

void add_place(Calibration& pair, const Tree& tree) {
   cv::Mat turn, shift, pose_turn, pose_shift;
   if (const Tree* const node = member(tree, {"RotationOfCamera2"}))
      turn = matrix_at(*node, 3, 3, "RotationOfCamera2").t();
   if (const Tree* const node = member(tree, {"TranslationOfCamera2"}))
      shift = translation_of(*node, "TranslationOfCamera2");
   if (const Tree* const pose = member(tree, {"PoseCamera2"})) {
      pose_turn = matrix_at(required_member(*pose, {"R"}), 3, 3, "PoseCamera2.R");
      pose_shift = translation_of(required_member(*pose, {"Translation"}), "PoseCamera2.Translation");
   }
   pair.r = agreed(turn, pose_turn, "RotationOfCamera2 and PoseCamera2");
   pair.t = agreed(shift, pose_shift, "TranslationOfCamera2 and PoseCamera2");
   if (pair.r.empty() || pair.t.empty())
      throw InputError("it has neither RotationOfCamera2 and TranslationOfCamera2 nor PoseCamera2");
   require_rotation("its RotationOfCamera2", pair.r);
}

void add_unit(Calibration& pair, const Tree& tree) {
   const std::string word = word_at(tree, "WorldUnits");
   if (const auto unit = kUnits.find(word); unit != kUnits.end()) pair.unit_mm = unit->second;
   else if (word.empty()) pair.unknown_unit = "it has no WorldUnits";
   else pair.unknown_unit = "its WorldUnits, " + shown_word(word.substr(0, 20)) + ", are no unit that is known";
}

Calibration parsed(const Tree& tree) {
   const auto camera = [&tree](const char* name) {
      try {
         return camera_of(required_member(tree, {name}));
      } catch (const InputError& problem) {
         throw InputError(std::string("of ") + name + ", " + problem.what());
      }
   };
   const Camera left = camera("CameraParameters1"), right = camera("CameraParameters2");
   if (left.size != right.size)
      throw InputError("its cameras have images of " + size_text(left.size) + " and " + size_text(right.size));
   Calibration pair;
   pair.m1 = left.m;
   pair.m2 = right.m;
   pair.d1 = left.d;
   pair.d2 = right.d;
   pair.image_size = left.size;
   pair.lens = Lens::radial;
   add_place(pair, tree);
   add_unit(pair, member(tree, {"WorldUnits"}) ? tree : required_member(tree, {"CameraParameters1"}));
   return pair;
}

}  // namespace

std::optional<Calibration> parse_matlab(const Tree& tree) {
   const auto is_pair = [](const Tree& node) {
      return member(node, {"CameraParameters1", "CameraParameters2"}) != nullptr;
   };
   if (is_pair(tree)) return parsed(tree);
   // jsonencode(struct("stereoParams", stereoParams))
   if (tree.is_object() && tree.size() == 1 && is_pair(tree.front())) return parsed(tree.front());
   return std::nullopt;
}

}  // namespace stereo::app
