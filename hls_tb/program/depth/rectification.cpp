// SPDX-License-Identifier: Apache-2.0
#include "program/depth/rectification.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

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
   require_camera_matrix(name, camera);
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
   require_rotation(calibration.r);
   const cv::Size size(width_px, height_px);
   Rectification made;
   for (const auto& [name, camera] :
        {std::pair{"the left camera", calibration.m1}, {"the right camera", calibration.m2}})
      made.warnings += principal_point_warning(name, camera.at<double>(0, 2), camera.at<double>(1, 2), size);
   try {
      cv::Mat r1, r2, p1, p2, q;
      cv::stereoRectify(calibration.m1, calibration.d1, calibration.m2, calibration.d2, size, calibration.r,
                        calibration.t, r1, r2, p1, p2, q, cv::CALIB_ZERO_DISPARITY, 0, size);
      if (!cv::checkRange(q) || !cv::checkRange(p1) || !cv::checkRange(p2))
         throw InputError("--calibration: its cameras cannot be rectified");
      if (p2.at<double>(1, 3) != 0)
         throw InputError("--calibration: its cameras stand one above the other; this matcher needs them side by side");
      const cv::Size maps(width_px + behind_px, height_px + behind_px);
      cv::initUndistortRectifyMap(calibration.m1, calibration.d1, r1, p1, maps, CV_32FC1, made.left_x, made.left_y);
      cv::initUndistortRectifyMap(calibration.m2, calibration.d2, r2, p2, maps, CV_32FC1, made.right_x, made.right_y);
      made.geometry = geometry_of_q(q);
   } catch (const cv::Exception&) {
      throw InputError("--calibration: its cameras cannot be rectified");
   }
   return made;
}

}  // namespace stereo::app
