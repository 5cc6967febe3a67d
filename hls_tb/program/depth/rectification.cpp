// SPDX-License-Identifier: Apache-2.0
#include "program/depth/rectification.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "definition/gray_image.hpp"
#include "program/errors.hpp"

namespace stereo::app {
namespace {

void require_matrices(const Calibration& calibration) {
   std::string missing;
   const std::pair<const char*, const cv::Mat*> needed[] = {
       {"M1", &calibration.m1}, {"M2", &calibration.m2}, {"R", &calibration.r}, {"T", &calibration.t}};
   for (const auto& [name, matrix] : needed)
      if (matrix->empty()) missing += (missing.empty() ? "" : ", ") + std::string(name);
   if (!missing.empty())
      throw InputError(
          "--calibration: lacks " + missing +
          ", which rectification needs; add --extrinsics, or --rectified for a pair that is rectified already");
}

/// A camera whose axis leaves its image was calibrated with another image.
void require_camera(const char* name, const cv::Mat& camera, int width, int height) {
   const double focal = camera.at<double>(0, 0), x = camera.at<double>(0, 2), y = camera.at<double>(1, 2);
   if (focal <= 0 || camera.at<double>(1, 1) <= 0 || x <= 0 || x >= width || y <= 0 || y >= height)
      throw InputError("--calibration: its " + std::string(name) + " does not belong to images of " +
                       size_text(width, height) + "; give images of the size that the cameras were calibrated with");
   require_camera_matrix("--calibration: its " + std::string(name), camera);
}

/// What cv::stereoRectify makes.
struct Rectified {
   cv::Mat r1, r2, p1, p2, q;
};

cv::Mat coefficients(const cv::Mat& d) { return d.empty() ? cv::Mat(cv::Mat::zeros(1, 4, CV_64F)) : d; }

[[noreturn]] void refuse_upright() {
   throw InputError("--calibration: its cameras stand one above the other; this matcher needs them side by side");
}

/// OpenCV makes something of every pair: of cameras that look elsewhere or stand one behind the other, and with
/// cv::fisheye::stereoRectify also one above the other, images that show nothing of both.
void require_side_by_side(const Calibration& calibration) {
   constexpr double kLargestTurn = 60;  // degrees
   cv::Mat turn, half;
   cv::Rodrigues(calibration.r, turn);
   if (const double degrees = cv::norm(turn) * 180 / CV_PI; degrees > kLargestTurn) {
      std::ostringstream text;
      text << "--calibration: its R turns the right camera by " << degrees
           << " degrees against the left one, too far for images that show the same";
      throw InputError(text.str());
   }
   cv::Rodrigues(turn * -0.5, half);
   const cv::Mat t = half * calibration.t;
   if (std::abs(t.at<double>(1)) > std::abs(t.at<double>(0))) refuse_upright();
   if (std::abs(t.at<double>(2)) > std::abs(t.at<double>(0)))
      throw InputError("--calibration: its cameras stand one behind the other; this matcher needs them side by side");
}

Rectified rectified(const Calibration& c, cv::Size size) {
   Rectified made;
   require_side_by_side(c);
   if (c.lens == Lens::fisheye) {
      cv::fisheye::stereoRectify(c.m1, coefficients(c.d1), c.m2, coefficients(c.d2), size, c.r, c.t, made.r1, made.r2,
                                 made.p1, made.p2, made.q, cv::CALIB_ZERO_DISPARITY, size, 0);
   } else {
      cv::stereoRectify(c.m1, c.d1, c.m2, c.d2, size, c.r, c.t, made.r1, made.r2, made.p1, made.p2, made.q,
                        cv::CALIB_ZERO_DISPARITY, 0, size);
   }
   if (!cv::checkRange(made.q) || !cv::checkRange(made.p1) || !cv::checkRange(made.p2))
      throw InputError("--calibration: its cameras cannot be rectified");
   if (made.p2.at<double>(1, 3) != 0) refuse_upright();
   return made;
}

void make_maps(Lens lens, const cv::Mat& m, const cv::Mat& d, const cv::Mat& r, const cv::Mat& p, cv::Size size,
               cv::Mat& x, cv::Mat& y) {
   if (lens == Lens::fisheye) cv::fisheye::initUndistortRectifyMap(m, coefficients(d), r, p, size, CV_32FC1, x, y);
   else cv::initUndistortRectifyMap(m, d, r, p, size, CV_32FC1, x, y);
}

}  // namespace

cv::Mat Rectification::left(const cv::Mat& image) const {
   cv::Mat result;
   cv::remap(image, result, left_x, left_y, cv::INTER_LINEAR);
   return result;
}

cv::Mat Rectification::right(const cv::Mat& image) const {
   cv::Mat result;
   cv::remap(image, result, right_x, right_y, cv::INTER_LINEAR);
   return result;
}

Rectification make_rectification(const Calibration& calibration, int width_px, int height_px, int behind_px) {
   require_matrices(calibration);
   require_camera("M1", calibration.m1, width_px, height_px);
   require_camera("M2", calibration.m2, width_px, height_px);
   require_rotation("--calibration: its R", calibration.r);
   const cv::Size size(width_px, height_px);
   Rectification made;
   for (const auto& [name, camera] :
        {std::pair{"the left camera", calibration.m1}, {"the right camera", calibration.m2}})
      made.warnings += principal_point_warning(name, camera.at<double>(0, 2), camera.at<double>(1, 2), size);
   try {
      const Rectified found = rectified(calibration, size);
      const cv::Size maps(width_px + behind_px, height_px + behind_px);
      make_maps(calibration.lens, calibration.m1, calibration.d1, found.r1, found.p1, maps, made.left_x, made.left_y);
      make_maps(calibration.lens, calibration.m2, calibration.d2, found.r2, found.p2, maps, made.right_x, made.right_y);
      made.geometry = geometry_of_q(found.q);
   } catch (const cv::Exception&) {
      throw InputError("--calibration: its cameras cannot be rectified");
   }
   return made;
}

}  // namespace stereo::app
