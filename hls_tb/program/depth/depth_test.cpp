// SPDX-License-Identifier: Apache-2.0
// Geometry from the calibration to the point cloud, on pairs of known geometry.
#include "program/depth/depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "definition/block_matching/models.hpp"
#include "program/depth/pair_warnings.hpp"
#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "program/io/opencv_images.hpp"
#include "scene/scene.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

/// 500 px of focal length, a baseline of 100, the principal point 20,10; `infinity`: the disparity there.
RectifiedGeometry geometry_of(double infinity = 0) {
   return {{1, 0, 0, -20, 0, 1, 0, -10, 0, 0, 0, 500, 0, 0, 0.01, -0.01 * infinity}};
}
const RectifiedGeometry kGeometry = geometry_of();
const std::string kAxes = axes_of(kGeometry);

TEST(Depth, IsFocalLengthTimesBaselineOverDisparity) {
   DisparityImage disparity(40, 20, 7);
   disparity.at(3, 2) = kNoDisparity;
   disparity.at(4, 2) = 0;
   disparity.at(5, 2) = -1;
   disparity.at(6, 2) = 0.5F;  // 100 m
   const std::vector<Point> points = points_of(disparity, Reference::left, kGeometry, 0.001);
   const cv::Mat_<uint16_t> image = depth_image(points, 40, 20);
   ASSERT_EQ(image.size(), cv::Size(40, 20));
   EXPECT_EQ(image(0, 0), 7143) << "500 px * 100 mm / 7 px = 7142.857 mm";
   for (const int unknown : {3, 4, 5, 6}) EXPECT_EQ(image(2, unknown), 0) << unknown;
   EXPECT_EQ(cv::countNonZero(image), 800 - 4);
   EXPECT_NEAR(points[2 * 40 + 6].z_m, 100, 1e-4) << "the cloud has it, the image cannot";
   // Pixel 27,13: 7 px right of the principal point and 3 below it, at 100/7 mm a pixel.
   const Point& point = points[13 * 40 + 27];
   EXPECT_NEAR(point.x_m, 0.1, 1e-6);
   EXPECT_NEAR(point.y_m, 0.3 / 7, 1e-6);
}

TEST(Depth, OfTheRightImageIsSeenFromTheLeftCameraToo) {
   const std::vector<Point> left = points_of(DisparityImage(40, 1, 7), Reference::left, kGeometry, 0.001);
   const std::vector<Point> right = points_of(DisparityImage(40, 1, 7), Reference::right, kGeometry, 0.001);
   for (int x = 0; x + 7 < 40; ++x) EXPECT_FLOAT_EQ(right[std::size_t(x)].x_m, left[std::size_t(x) + 7].x_m);
   EXPECT_EQ(right[0].z_m, left[0].z_m);
}

TEST(Depth, CountsDisparitiesFromInfinity) {
   const RectifiedGeometry geometry = geometry_of(5);
   const cv::Mat_<uint16_t> image =
       depth_image(points_of(DisparityImage(2, 1, 7), Reference::left, geometry, 0.001), 2, 1);
   EXPECT_EQ(image(0, 0), 25000) << "500 px * 100 mm / (7 - 5) px";
}

TEST(Depth, CloudHoldsWhatIsKnown) {
   DisparityImage disparity(3, 1, 5);
   disparity.at(1, 0) = kNoDisparity;
   const std::vector<Point> points = points_of(disparity, Reference::left, kGeometry, 0.001);
   const cv::Mat colors = (cv::Mat_<cv::Vec3b>(1, 3) << cv::Vec3b(1, 2, 3), cv::Vec3b(4, 5, 6), cv::Vec3b(7, 8, 9));
   const std::string ply = encode_ply(points, colors, kAxes);
   ASSERT_EQ(ply.find("ply\nformat binary_little_endian 1.0\n"), 0u);
   EXPECT_NE(ply.find("left camera: x to the right, y down, z forward\n"), std::string::npos);
   EXPECT_NE(ply.find("element vertex 2\n"), std::string::npos);
   const std::size_t body = ply.find("end_header\n") + 11;
   ASSERT_EQ(ply.size() - body, 2u * 15u) << "three floats and three bytes a point";
   float z = 0;
   std::memcpy(&z, ply.data() + body + 8, 4);
   EXPECT_EQ(z, 10.0F);
   EXPECT_EQ(ply.substr(body + 12, 3), "\3\2\1") << "red first";
   EXPECT_EQ(ply.substr(body + 27, 3), "\11\10\7");
   const std::string gray = encode_ply(points, (cv::Mat_<uint8_t>(1, 3) << 50, 60, 70), kAxes);
   EXPECT_EQ(gray.substr(gray.size() - 3), "FFF");
}

cv::Mat camera(double focal, double cx, double cy) {
   return (cv::Mat_<double>(3, 3) << focal, 0, cx, 0, focal, cy, 0, 0, 1);
}

cv::Mat rotation(double x, double y, double z) {
   cv::Mat r;
   cv::Rodrigues(cv::Mat_<double>((cv::Mat_<double>(3, 1) << x, y, z)), r);
   return r;
}

TEST(Depth, NearerAndFartherPointsAreLeftOut) {
   DisparityImage disparity(4, 1, kNoDisparity);
   for (int x = 0; x < 3; ++x) disparity.at(x, 0) = float(5 * (x + 1));  // 10, 5, 3.333 m
   std::vector<Point> points = points_of(disparity, Reference::left, kGeometry, 0.001);
   EXPECT_EQ(keep_depths(points, 0, 1e9), 0);
   EXPECT_EQ(keep_depths(points, 3.4, 9.9), 2);
   const cv::Mat_<uint16_t> image = depth_image(points, 4, 1);
   EXPECT_EQ(std::vector<uint16_t>(image.begin(), image.end()), (std::vector<uint16_t>{0, 5000, 0, 0}));
   for (Point& point : points) point.z_m = -point.z_m;
   EXPECT_EQ(keep_depths(points, 6, 9), 1) << "z may point backward";
}

GrayImage seen_by_turned_camera(const GrayImage& image, const cv::Mat& k, const cv::Mat& turn) {
   GrayImage copy = image, result(image.width, image.height);
   cv::warpPerspective(as_mat(copy), as_mat(result), k * turn * k.inv(), {image.width, image.height});
   return result;
}

constexpr MapGeometry kMaps{Reference::left, 0, 480, 80, 0, false};
constexpr double kFocal = 600, kBaseline = 0.12;

/// Two cameras, each turned away from the rectified frame, and what they see of a scene.
struct TurnedCameras {
   Scene scene = make_scene({.width = 480, .height = 360, .disparities = 48, .seed = test::test_seed()});
   ImagePair seen;
   Calibration calibration;

   TurnedCameras() {
      const cv::Mat k = camera(kFocal, 239.5, 179.5), left = rotation(0.02, 0.01, -0.03),
                    right = rotation(-0.02, 0.015, 0.02);
      seen = {seen_by_turned_camera(scene.images.left, k, left), seen_by_turned_camera(scene.images.right, k, right)};
      calibration.m1 = calibration.m2 = k;
      calibration.r = right * left.t();
      calibration.t = -right * (cv::Mat_<double>(3, 1) << kBaseline, 0, 0);
   }
};

TEST(Rectification, UndoesTheTurnOfTheCameras) {
   const TurnedCameras cameras;
   const auto before = vertical_offset(matched_features(cameras.seen));
   ASSERT_TRUE(before);
   EXPECT_GT(before->median_px, 8) << "they are turned by more than two degrees against each other";
   EXPECT_NE(pair_warning(cameras.seen, kMaps), "");

   const Rectification rectification = make_rectification(cameras.calibration, 480, 360);
   ImagePair copy = cameras.seen;
   const ImagePair pair{gray_of_any(rectification.left(as_mat(copy.left))),
                        gray_of_any(rectification.right(as_mat(copy.right)))};
   const auto after = vertical_offset(matched_features(pair));
   ASSERT_TRUE(after);
   EXPECT_LT(after->median_px, 0.5);
   EXPECT_GT(after->features, 50);
   EXPECT_EQ(pair_warning(pair, kMaps), "");
   EXPECT_NEAR(rectification.geometry.baseline(), kBaseline, 1e-9);
   EXPECT_NEAR(rectification.geometry.cx_difference_px(), 0, 1e-9);
}

// The distances of the scene's pixels, from the truth in the rectified frame, against those from the turned cameras.
TEST(Rectification, DepthOfTurnedCamerasIsThatOfTheScene) {
   const TurnedCameras cameras;
   const Rectification rectification = make_rectification(cameras.calibration, 480, 360);
   ImagePair copy = cameras.seen;
   const ImagePair pair{gray_of_any(rectification.left(as_mat(copy.left))),
                        gray_of_any(rectification.right(as_mat(copy.right)))};
   const block_matching::Matching parameters{
       DisparityCount{80},       MatchingWindow{11},    ReferenceImage{Reference::left},
       Comparison{Cost::census}, LeftRightThreshold{1}, SubpixelSteps{true}};
   const DisparityImage found =
       at_image_size(match_fast(pair.left, pair.right, parameters), map_geometry(parameters, 480), 480);
   std::vector<float> depths, true_depths;
   for (const Point& point : points_of(found, Reference::left, rectification.geometry, 1))
      if (point.z_m > 0) depths.push_back(point.z_m);
   for (const uint8_t disparity : cameras.scene.left_disparity.pixels)
      if (disparity > 0) true_depths.push_back(float(kFocal * kBaseline / disparity));
   ASSERT_GT(depths.size(), 480u * 360u / 3);
   const auto median = [](std::vector<float>& values) {
      std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
      return values[values.size() / 2];
   };
   EXPECT_NEAR(median(depths) / median(true_depths), 1, 0.1);
}

}  // namespace
}  // namespace stereo::app
