// SPDX-License-Identifier: Apache-2.0
#include "program/depth/rectified_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <sstream>

#include "definition/gray_image.hpp"
#include "program/depth/pair_warnings.hpp"
#include "program/errors.hpp"

namespace stereo::app {
namespace {

constexpr double kRounding = 1e-9;       ///< of an entry that must be 0, to the largest of its row
constexpr double kLargestTilt = 0.01;    ///< radians, and share of a length, by which a rectified pair may differ
constexpr double kFarFromMiddle = 0.15;  ///< of the image's side
constexpr double kAtTheEdge = 0.4;       ///< the same; behind it the image is another one
const std::string kOption = "--calibration: its ";

/// The first entry that is not 0 but must be, as "row 4, column 1"; else nothing. `pattern`: a character for each
/// entry, 0: must be 0.
std::string not_zero(const cv::Mat& matrix, const char* pattern) {
   for (int row = 0; row < matrix.rows; ++row) {
      const double largest = cv::norm(matrix.row(row), cv::NORM_INF);
      for (int column = 0; column < matrix.cols; ++column, ++pattern)
         if (*pattern == '0' && std::abs(matrix.at<double>(row, column)) > kRounding * largest)
            return "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
   }
   return "";
}

[[noreturn]] void refuse_exchanged() {
   throw InputError(
       "--calibration: its right camera stands to the left of the left one: exchange --left and --right, and "
       "calibrate in that order");
}

/// `name`: the matrices that it comes from.
[[noreturn]] void refuse_empty(const std::string& name) {
   throw InputError(kOption + name + " lacks the focal length or the baseline of a rectified pair");
}

void require_side_by_side(const std::string& name, double x, double y, double z) {
   const double largest = kLargestTilt * std::abs(x);
   if (std::abs(y) <= largest && std::abs(z) <= largest) return;
   std::ostringstream text;
   text << kOption << name << " puts the right camera at " << 0 - x << ", " << 0 - y << ", " << 0 - z
        << " (right, down, forward) from the left one, but those of a rectified pair stand side by side"
        << (std::abs(y) > std::abs(x) ? "; these stand one above the other" : "")
        << "; leave --rectified out, or give the Q of the rectified pair";
   throw InputError(text.str());
}

/// A camera of a rectified pair.
struct Pinhole {
   double fx, fy, cx, cy;
   double tx = 0, ty = 0, tz = 0;  ///< from the common origin into this camera's frame
};

Pinhole of_camera_matrix(const std::string& name, const cv::Mat& m) {
   require_camera_matrix(kOption + name, m);
   return {m.at<double>(0, 0), m.at<double>(1, 1), m.at<double>(0, 2), m.at<double>(1, 2)};
}

Pinhole of_projection(const std::string& name, const cv::Mat& p) {
   Pinhole camera = of_camera_matrix(name, p.colRange(0, 3));
   camera.tz = p.at<double>(2, 3);
   camera.tx = (p.at<double>(0, 3) - camera.cx * camera.tz) / camera.fx;
   camera.ty = (p.at<double>(1, 3) - camera.cy * camera.tz) / camera.fy;
   return camera;
}

void require_same(const std::string& name, const char* what, double left, double right, double tolerance) {
   if (std::abs(left - right) <= tolerance) return;
   std::ostringstream text;
   text << kOption << name << " have " << what << "s of " << left << " and " << right
        << " px, but a rectified pair has one; leave --rectified out, or give the Q of the rectified pair";
   throw InputError(text.str());
}

RectifiedGeometry geometry_of_cameras(const Pinhole& left, const Pinhole& right, const std::string& name) {
   require_same(name, "focal length", left.fx, right.fx, kLargestTilt * left.fx);
   require_same(name, "focal length", left.fy, right.fy, kLargestTilt * left.fy);
   require_same(name, "principal row", left.cy, right.cy, kLargestVerticalOffset);
   const double x = right.tx - left.tx;
   if (x == 0 && right.ty == left.ty && right.tz == left.tz) refuse_empty(name);
   require_side_by_side(name, x, right.ty - left.ty, right.tz - left.tz);
   if (x > 0) refuse_exchanged();
   const double ratio = left.fx / left.fy;
   return {
       {1, 0, 0, -left.cx, 0, ratio, 0, -left.cy * ratio, 0, 0, 0, left.fx, 0, 0, -1 / x, (left.cx - right.cx) / x}};
}

double angle_of(const cv::Mat& rotation) { return std::acos(std::clamp((cv::trace(rotation)[0] - 1) / 2, -1.0, 1.0)); }

void require_no_turn(const cv::Mat& r) {
   if (r.empty() || angle_of(r) <= kLargestTilt) return;
   std::ostringstream text;
   text << kOption << "R turns the right camera by " << angle_of(r) * 180 / CV_PI
        << " degrees, so M1 and T are not those of a rectified pair; leave --rectified out, or give its Q or P1 and P2";
   throw InputError(text.str());
}

void require_agreement(const RectifiedGeometry& q, const RectifiedGeometry& projections) {
   const auto differ = [](double a, double b) { return std::abs(a - b) > kLargestTilt * std::abs(b); };
   if (differ(q.focal_px(), projections.focal_px()) || differ(q.baseline(), projections.baseline()))
      throw InputError(kOption + "Q has another focal length or baseline than its P1 and P2");
}

/// T is as long as any rectification of the same cameras has the baseline.
void require_baseline(const RectifiedGeometry& geometry, const cv::Mat& t, const char* name) {
   if (t.empty()) return;
   const double wanted = cv::norm(t);
   if (std::abs(geometry.baseline() - wanted) <= kLargestTilt * wanted) return;
   std::ostringstream text;
   text << kOption << name << " has a baseline of " << geometry.baseline() << " but its T is " << wanted
        << " long: they are not of one calibration";
   throw InputError(text.str());
}

/// How far from the middle, in parts of the image's side.
double off_middle(double x, double y, cv::Size images) {
   return std::max(std::abs((x + 0.5) / images.width - 0.5), std::abs((y + 0.5) / images.height - 0.5));
}

std::string place_text(const std::string& name, double x, double y, cv::Size images) {
   std::ostringstream text;
   text << "the principal point of " << name << ", " << x << "," << y << ", is far from the middle of images of "
        << size_text(images.width, images.height)
        << ": were the cameras calibrated with others? Then give --calibrated-size";
   return text.str();
}

}  // namespace

double RectifiedGeometry::focal_px() const { return std::abs(q(2, 3) / q(0, 0)); }
double RectifiedGeometry::baseline() const { return std::abs(q(0, 0)) / q(3, 2); }
double RectifiedGeometry::cx_px() const { return -q(0, 3) / q(0, 0); }
double RectifiedGeometry::cy_px() const { return -q(1, 3) / q(1, 1); }
double RectifiedGeometry::cx_difference_px() const { return -q(3, 3) / q(3, 2); }
bool RectifiedGeometry::usual_axes() const { return q(0, 0) > 0 && q(1, 1) > 0 && q(2, 3) > 0; }

void require_camera_matrix(const std::string& name, const cv::Mat& camera) {
   std::string wrong = not_zero(camera, ".0.0..00.");
   if (!wrong.empty()) wrong += " must be 0";
   else if (std::abs(camera.at<double>(2, 2) - 1) > kRounding) wrong = "row 3, column 3 must be 1";
   else if (camera.at<double>(0, 0) <= 0 || camera.at<double>(1, 1) <= 0) wrong = "a focal length must be above 0";
   if (!wrong.empty()) throw InputError(name + " is not a camera matrix, fx 0 cx, 0 fy cy, 0 0 1: " + wrong);
}

void require_rotation(const std::string& name, const cv::Mat& r) {
   constexpr double kLargest = 1e-3;
   if (cv::norm(r * r.t(), cv::Mat::eye(3, 3, CV_64F), cv::NORM_INF) > kLargest || cv::determinant(r) < 0)
      throw InputError(name + " is not a rotation");
}

RectifiedGeometry geometry_of_q(const cv::Mat& q) {
   if (const std::string entry = not_zero(q, ".00.0.0.000.00.."); !entry.empty())
      throw InputError(kOption + "Q is not that of a rectified pair, as cv::stereoRectify makes it: " + entry +
                       " must be 0; is it transposed?");
   RectifiedGeometry geometry{cv::Matx44d(q.ptr<double>())};
   if (geometry.q(3, 2) < 0) geometry.q *= -1;
   const auto is_length = [](double value) { return std::isfinite(value) && value > 0; };
   if (geometry.q(1, 1) == 0 || !is_length(geometry.focal_px()) || !is_length(geometry.baseline())) refuse_empty("Q");
   if (geometry.q(0, 0) < 0 && geometry.q(1, 1) < 0 && geometry.q(2, 3) < 0) refuse_exchanged();
   return geometry;
}

namespace {

/// Nothing without P1 and P2.
std::optional<RectifiedGeometry> geometry_of_projections(const Calibration& calibration) {
   if (calibration.p1.empty() || calibration.p2.empty()) return std::nullopt;
   return geometry_of_cameras(of_projection("P1", calibration.p1), of_projection("P2", calibration.p2), "P1 and P2");
}

}  // namespace

RectifiedGeometry rectified_geometry(const Calibration& calibration) {
   const auto projections = geometry_of_projections(calibration);
   if (!calibration.q.empty()) {
      const RectifiedGeometry geometry = geometry_of_q(calibration.q);
      if (projections) require_agreement(geometry, *projections);
      require_baseline(geometry, calibration.t, "Q");
      return geometry;
   }
   if (projections) {
      require_baseline(*projections, calibration.t, "P2");
      return *projections;
   }
   if (calibration.m1.empty() || calibration.t.empty())
      throw InputError(
          "--calibration: has neither Q, nor P1 and P2, nor M1 and T, of which a rectified pair needs one");
   const Pinhole left = of_camera_matrix("M1", calibration.m1);
   Pinhole right = calibration.m2.empty() ? left : of_camera_matrix("M2", calibration.m2);
   if (!calibration.r.empty()) require_rotation(kOption + "R", calibration.r);
   require_no_turn(calibration.r);
   right.tx = calibration.t.at<double>(0);
   right.ty = calibration.t.at<double>(1);
   right.tz = calibration.t.at<double>(2);
   return geometry_of_cameras(left, right, calibration.m2.empty() ? "M1 and T" : "M1, M2 and T");
}

std::string principal_point_warning(const std::string& name, double x, double y, cv::Size images) {
   if (off_middle(x, y, images) <= kFarFromMiddle) return "";
   return "warning: " + place_text(name, x, y, images) + "\n";
}

std::string checked_principal_point(const RectifiedGeometry& geometry, cv::Size images, bool known) {
   const double x = geometry.cx_px(), y = geometry.cy_px();
   if (!known && off_middle(x, y, images) > kAtTheEdge)
      throw InputError("--calibration: " + place_text("its left camera", x, y, images));
   return principal_point_warning("the left camera", x, y, images);
}

}  // namespace stereo::app
