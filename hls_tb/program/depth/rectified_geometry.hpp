// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/matx.hpp>
#include <string>

#include "program/depth/calibration.hpp"

namespace stereo::app {

/// A rectified pair in space, lengths in the calibration's unit. The point of the left image's pixel x, y with
/// disparity d is X/W, Y/W, Z/W of (X, Y, Z, W) = q (x, y, d, 1), as cv::reprojectImageTo3D has it.
struct RectifiedGeometry {
   /// Of the form [a 0 0 b; 0 c 0 e; 0 0 0 f; 0 0 g h] with a, c, f not 0 and g above 0: W is above 0 for what stands
   /// before the cameras.
   cv::Matx44d q;

   double focal_px() const;  ///< above 0
   double baseline() const;  ///< above 0
   double cx_px() const;     ///< principal point of the left image
   double cy_px() const;
   double cx_difference_px() const;  ///< the disparity at infinity
   bool usual_axes() const;          ///< x to the right, y down, z forward
};

/// Of images that are rectified already: from Q, else from P1 and P2, else from M1, M2 and T. Throws InputError with
/// one sentence where there is none of these, where one has not the form that it must have, or where any matrix of the
/// calibration says that the pair is not rectified or that the right camera does not stand to the right.
RectifiedGeometry rectified_geometry(const Calibration& calibration);
/// Of a pair whose rows agree, which Q does not say. Throws InputError.
RectifiedGeometry geometry_of_q(const cv::Mat& q);

/// Throws InputError unless a matrix is [fx 0 cx; 0 fy cy; 0 0 1] with fx, fy above 0. `name`: how the sentence begins.
void require_camera_matrix(const std::string& name, const cv::Mat& camera);
/// Throws InputError unless a matrix is a rotation.
void require_rotation(const std::string& name, const cv::Mat& r);

/// A sentence that ends with a line feed where a principal point is far from the middle of its image, as with images of
/// another size than the calibration's; else nothing. `name`: of the camera, for the user.
std::string principal_point_warning(const std::string& name, double x, double y, cv::Size images);
/// The same of a pair that is rectified already. Throws InputError where the point lies at the image's edge or outside,
/// unless the size is `known` to be the calibration's.
std::string checked_principal_point(const RectifiedGeometry& geometry, cv::Size images, bool known);

}  // namespace stereo::app
