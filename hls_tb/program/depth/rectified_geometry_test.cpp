// SPDX-License-Identifier: Apache-2.0
// Geometry of rectified pairs: what is taken is that of cv::reprojectImageTo3D, the rest is refused with its reason.
#include "program/depth/rectified_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "program/depth/depth.hpp"
#include "program/errors.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

constexpr int kRounds = 200;
constexpr int kWidth = 64, kHeight = 48;

cv::Mat camera(double focal, double cx, double cy) {
   return (cv::Mat_<double>(3, 3) << focal, 0, cx, 0, focal, cy, 0, 0, 1);
}

cv::Mat q_of(double focal, double baseline, double cx, double cy, double infinity) {
   return (cv::Mat_<double>(4, 4) << 1, 0, 0, -cx, 0, 1, 0, -cy, 0, 0, 0, focal, 0, 0, 1 / baseline,
           -infinity / baseline);
}

std::string sentence(const Calibration& calibration) {
   try {
      rectified_geometry(calibration);
   } catch (const InputError& problem) {
      return problem.what();
   }
   return "";
}

std::string sentence_of_q(const cv::Mat& q) {
   Calibration calibration;
   calibration.q = q;
   return sentence(calibration);
}

DisparityImage random_disparities(Random& random) {
   DisparityImage image(kWidth, kHeight);
   for (float& px : image.px)
      if (random.below(5) != 0) px = float(random.below(1024) - 256) / 16;
   return image;
}

double drawn_entry(Random& random, double low, double high) { return random.between(low, high); }

/// As people have them: any scale, axes that point the other way, principal points in different columns.
cv::Mat random_q(Random& random) {
   const double focal = drawn_entry(random, 20, 2000);
   const double baseline = drawn_entry(random, 0.01, 500);
   const double column = drawn_entry(random, 10, 50);
   const double row = drawn_entry(random, 5, 40);
   const double offset = drawn_entry(random, -20, 20);
   cv::Mat q = q_of(focal, baseline, column, row, offset);
   if (random.below(2) == 0) q.row(1) *= -1;                           // y up
   if (random.below(2) == 0) q.row(2) *= -1;                           // z backward
   if (random.below(4) == 0) q.row(1) *= drawn_entry(random, 0.5, 2);  // pixels that are not square
   const double scale = std::pow(10, drawn_entry(random, -4, 4));
   const int sign = random.below(2) == 0 ? 1 : -1;
   return q * scale * sign;
}

/// Points of the program against those of OpenCV, and that the program's others stand nowhere before the camera.
void expect_reprojection(const cv::Mat& q, const DisparityImage& disparity, int fewest) {
   cv::Mat map(kHeight, kWidth, CV_32F), wanted;
   std::copy(disparity.px.begin(), disparity.px.end(), map.ptr<float>());
   cv::reprojectImageTo3D(map, wanted, q);
   const std::vector<Point> points = points_of(disparity, Reference::left, geometry_of_q(q), 1);
   const double infinity = -q.at<double>(3, 3) / q.at<double>(3, 2);
   int known = 0;
   for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = double(disparity.px[i]);
      ASSERT_EQ(points[i].z_m != 0, d > infinity) << "pixel " << i << ", disparity " << d << ", " << q;
      if (points[i].z_m == 0) continue;
      ++known;
      const cv::Vec3f& there = wanted.at<cv::Vec3f>(int(i));
      const float found[] = {points[i].x_m, points[i].y_m, points[i].z_m};
      for (int axis = 0; axis < 3; ++axis)
         ASSERT_NEAR(found[axis], there[axis], 1e-5 * std::max(1.0F, std::abs(there[axis])))
             << "pixel " << i << ", axis " << axis << ", " << q;
   }
   ASSERT_GE(known, fewest);
}

TEST(GeometryOfQ, CloudIsThatOfReprojectImageTo3D) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round) {
      const cv::Mat q = random_q(random);
      expect_reprojection(q, random_disparities(random), 100);
   }
}

TEST(GeometryOfQ, IsTheSameWhateverItsScale) {
   for (const double scale : {1.0, 10.0, 0.1, -1.0, -3e-3, 1e9}) {
      const RectifiedGeometry geometry = geometry_of_q(q_of(500, 0.1, 319.5, 239.5, 2) * scale);
      EXPECT_NEAR(geometry.focal_px(), 500, 1e-9) << scale;
      EXPECT_NEAR(geometry.baseline(), 0.1, 1e-12) << scale;
      EXPECT_NEAR(geometry.cx_px(), 319.5, 1e-9) << scale;
      EXPECT_NEAR(geometry.cy_px(), 239.5, 1e-9) << scale;
      EXPECT_NEAR(geometry.cx_difference_px(), 2, 1e-9) << scale;
      EXPECT_TRUE(geometry.usual_axes()) << scale;
   }
}

TEST(GeometryOfQ, OtherAxesAreTakenAndSaid) {
   cv::Mat q = q_of(500, 0.1, 20, 10, 0);
   q.row(1) *= -1;
   q.row(2) *= -1;  // y up and z backward, as a sample of OpenCV has it
   const RectifiedGeometry geometry = geometry_of_q(q);
   EXPECT_FALSE(geometry.usual_axes());
   EXPECT_NE(axes_of(geometry), axes_of(geometry_of_q(q_of(500, 0.1, 20, 10, 0))));
   const std::vector<Point> points = points_of(DisparityImage(kWidth, kHeight, 5), Reference::left, geometry, 1);
   EXPECT_FLOAT_EQ(points[0].z_m, -10);
   EXPECT_FLOAT_EQ(points[0].y_m, 0.2F);
   EXPECT_EQ(depth_image(points, kWidth, kHeight).at<uint16_t>(0, 0), 10000) << "depth has no sign";
}

TEST(GeometryOfQ, DamagedOnesAreRefused) {
   const cv::Mat q = q_of(500, 0.1, 319.5, 239.5, 0);
   EXPECT_NE(sentence_of_q(q.t()).find("row 4, column 1 must be 0; is it transposed?"), std::string::npos);
   cv::Mat swapped = q.clone();
   q.row(3).copyTo(swapped.row(2));
   q.row(2).copyTo(swapped.row(3));
   EXPECT_NE(sentence_of_q(swapped).find("row 3, column 3 must be 0"), std::string::npos);
   EXPECT_NE(sentence_of_q(cv::Mat::eye(4, 4, CV_64F)), "");
   EXPECT_NE(sentence_of_q(cv::Mat::zeros(4, 4, CV_64F)).find("lacks the focal length or the baseline"),
             std::string::npos);
   for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {2, 3}, {3, 2}}) {
      cv::Mat less = q.clone();
      less.at<double>(row, column) = 0;
      EXPECT_NE(sentence_of_q(less).find("lacks the focal length or the baseline"), std::string::npos)
          << row << ' ' << column;
   }
   cv::Mat exchanged = q.clone();
   exchanged.row(3) *= -1;
   EXPECT_NE(sentence_of_q(exchanged).find("exchange --left and --right"), std::string::npos);
   EXPECT_NE(sentence_of_q(-exchanged).find("exchange --left and --right"), std::string::npos);
}

// Any entry changed: refused with a sentence, or what reprojectImageTo3D makes of it.
TEST(GeometryOfQ, DamagedOnesAreRefusedOrRight) {
   Random random(test::test_seed());
   int refused = 0;
   for (int round = 0; round < kRounds; ++round) {
      cv::Mat q = random_q(random);
      const int row = random.below(4), column = random.below(4);
      const double largest = cv::norm(q.row(row), cv::NORM_INF);
      const double share = drawn_entry(random, 0.1, 3);
      const int sign = random.below(2) == 0 ? 1 : -1;
      q.at<double>(row, column) += largest * share * sign;
      if (random.below(4) == 0) q = q.t();
      if (sentence_of_q(q).empty()) expect_reprojection(q, random_disparities(random), 0);
      else ++refused;
   }
   EXPECT_GT(refused, kRounds / 3) << "nine of sixteen entries must be 0";
}

TEST(RectifiedGeometry, IsTheSameFromQAndFromProjectionsAndFromCameras) {
   Calibration cameras, projections, q;
   cameras.m1 = camera(500, 21, 11);
   cameras.m2 = camera(500, 18, 11);
   cameras.t = (cv::Mat_<double>(3, 1) << -100, 0, 0);
   projections.p1 = (cv::Mat_<double>(3, 4) << 500, 0, 21, 0, 0, 500, 11, 0, 0, 0, 1, 0);
   projections.p2 = (cv::Mat_<double>(3, 4) << 500, 0, 18, -50000, 0, 500, 11, 0, 0, 0, 1, 0);
   q.q = (cv::Mat_<double>(4, 4) << 1, 0, 0, -21, 0, 1, 0, -11, 0, 0, 0, 500, 0, 0, 0.01, -0.03);
   for (const Calibration& calibration : {cameras, projections, q}) {
      const RectifiedGeometry geometry = rectified_geometry(calibration);
      EXPECT_NEAR(geometry.focal_px(), 500, 1e-9);
      EXPECT_NEAR(geometry.baseline(), 100, 1e-9);
      EXPECT_NEAR(geometry.cx_px(), 21, 1e-9);
      EXPECT_NEAR(geometry.cy_px(), 11, 1e-9);
      EXPECT_NEAR(geometry.cx_difference_px(), 3, 1e-9);
   }
}

// P1 and P2 that both stand away from a third camera, as KITTI's P2 and P3 from its first one.
TEST(RectifiedGeometry, ProjectionsMayHaveACommonOriginElsewhere) {
   Calibration calibration;
   calibration.p1 = (cv::Mat_<double>(3, 4) << 500, 0, 20, 30.5, 0, 500, 10, 0.2, 0, 0, 1, 0.002);
   calibration.p2 = (cv::Mat_<double>(3, 4) << 500, 0, 20, -219.5, 0, 500, 10, 0.2, 0, 0, 1, 0.002);
   EXPECT_NEAR(rectified_geometry(calibration).baseline(), 0.5, 1e-12);
}

TEST(RectifiedGeometry, PixelsNeedNotBeSquare) {
   Calibration calibration;
   calibration.m1 = camera(500, 20, 10);
   calibration.m1.at<double>(1, 1) = 250;
   calibration.t = (cv::Mat_<double>(3, 1) << -100, 0, 0);
   const std::vector<Point> points =
       points_of(DisparityImage(21, 11, 5), Reference::left, rectified_geometry(calibration), 1);
   EXPECT_FLOAT_EQ(points[0].z_m, 10000);
   EXPECT_FLOAT_EQ(points[0].x_m, -400) << "20 px of 500 at 10000";
   EXPECT_FLOAT_EQ(points[0].y_m, -400) << "10 px of 250 at 10000";
}

TEST(RectifiedGeometry, RefusesWhatIsNone) {
   const auto expect = [](const Calibration& calibration, const std::string& words) {
      EXPECT_NE(sentence(calibration).find(words), std::string::npos) << words << ": " << sentence(calibration);
   };
   expect({}, "neither Q, nor");
   Calibration good;
   good.m1 = camera(500, 20, 10);
   good.m2 = camera(500, 22, 10);
   good.t = (cv::Mat_<double>(3, 1) << -0.1, 0.0005, -0.0005);
   good.r = cv::Mat::eye(3, 3, CV_64F);
   ASSERT_EQ(sentence(good), "");
   const auto with_t = [&good](double x, double y, double z) {
      Calibration calibration = good;
      calibration.t = (cv::Mat_<double>(3, 1) << x, y, z);
      return calibration;
   };
   expect(with_t(0.1, 0, 0), "exchange --left and --right");
   expect(with_t(0, 0, 0), "lacks the focal length or the baseline");
   expect(with_t(-0.01, -0.1, 0), "M1, M2 and T puts the right camera at 0.01, 0.1, 0");
   expect(with_t(-0.01, -0.1, 0), "one above the other");
   expect(with_t(-0.1, 0, 0.02), "stand side by side");
   expect(with_t(0, 0, 0.1), "stand side by side");
   Calibration bad = good;
   bad.m1 = cv::Mat(good.m1.t());
   expect(bad, "M1 is not a camera matrix, fx 0 cx, 0 fy cy, 0 0 1: row 3, column 1 must be 0");
   bad = good;
   bad.m2 = cv::Mat(good.m2 * 2);
   expect(bad, "M2 is not a camera matrix, fx 0 cx, 0 fy cy, 0 0 1: row 3, column 3 must be 1");
   bad = good;
   bad.m2 = camera(520, 22, 10);
   expect(bad, "focal lengths of 500 and 520 px");
   bad = good;
   bad.m2 = camera(500, 22, 12);
   expect(bad, "principal rows of 10 and 12 px");
   bad = good;
   bad.r = cv::Mat();
   cv::Rodrigues(cv::Vec3d(0, 17 * CV_PI / 180, 0), bad.r);
   expect(bad, "R turns the right camera by 17 degrees");
   bad = good;
   bad.r = cv::Mat(2 * good.r);
   expect(bad, "R is not a rotation");
}

TEST(RectifiedGeometry, ProjectionsBesideQAreCheckedToo) {
   Calibration calibration;
   calibration.q = q_of(500, 0.1, 20, 10, 0);
   calibration.p1 = (cv::Mat_<double>(3, 4) << 500, 0, 20, 0, 0, 500, 10, 0, 0, 0, 1, 0);
   calibration.p2 = (cv::Mat_<double>(3, 4) << 500, 0, 20, -50, 0, 500, 10, 0, 0, 0, 1, 0);
   ASSERT_EQ(sentence(calibration), "");
   calibration.p2.at<double>(0, 3) = -60;
   EXPECT_NE(sentence(calibration).find("Q has another focal length or baseline"), std::string::npos);
   calibration.p2.at<double>(0, 3) = 0;
   calibration.p2.at<double>(1, 3) = -50;
   EXPECT_NE(sentence(calibration).find("P1 and P2 puts the right camera at 0, 0.1, 0"), std::string::npos)
       << sentence(calibration);
}

TEST(PrincipalPoint, FarFromTheMiddleIsSaid) {
   const RectifiedGeometry geometry = geometry_of_q(q_of(500, 0.1, 319.5, 239.5, 0));
   EXPECT_EQ(checked_principal_point(geometry, {640, 480}, false), "");
   EXPECT_NE(checked_principal_point(geometry, {1280, 960}, false).find("warning: the principal point"),
             std::string::npos);
   for (const cv::Size smaller : {cv::Size(320, 240), cv::Size(160, 120)}) {
      EXPECT_THROW(checked_principal_point(geometry, smaller, false), InputError);
      EXPECT_NE(checked_principal_point(geometry, smaller, true), "") << "the user says that it is so";
   }
}

TEST(FittedCalibration, ScalesAllMatrices) {
   Calibration calibration;
   calibration.m1 = calibration.m2 = camera(500, 319.5, 239.5);
   calibration.t = (cv::Mat_<double>(3, 1) << -0.1, 0, 0);
   calibration.p1 = (cv::Mat_<double>(3, 4) << 500, 0, 319.5, 0, 0, 500, 239.5, 0, 0, 0, 1, 0);
   calibration.p2 = (cv::Mat_<double>(3, 4) << 500, 0, 317.5, -50, 0, 500, 239.5, 0, 0, 0, 1, 0);
   calibration.q = q_of(500, 0.1, 319.5, 239.5, 2);
   const Calibration half = fitted_calibration(calibration, {320, 240}, {640, 480});
   Calibration cameras = half, projections = half;
   cameras.q = cameras.p1 = cameras.p2 = projections.q = cv::Mat();
   for (const Calibration& scaled : {half, projections, cameras}) {
      const RectifiedGeometry geometry = rectified_geometry(scaled);
      EXPECT_NEAR(geometry.focal_px(), 250, 1e-9);
      EXPECT_NEAR(geometry.baseline(), 0.1, 1e-9);
      EXPECT_NEAR(geometry.cx_px(), 159.5, 1e-9) << "the middle stays the middle";
      EXPECT_NEAR(geometry.cy_px(), 119.5, 1e-9);
   }
   EXPECT_NEAR(rectified_geometry(half).cx_difference_px(), 1, 1e-9);
   // A place in space stays where it is.
   const Point there = points_of(DisparityImage(640, 480, 12), Reference::left, rectified_geometry(calibration), 1)[0];
   const Point scaled = points_of(DisparityImage(320, 240, 6), Reference::left, rectified_geometry(half), 1)[0];
   EXPECT_NEAR(there.z_m, scaled.z_m, 1e-6);
}

TEST(FittedCalibration, UsesTheSizeOfTheFile) {
   const auto refusal = [](cv::Size file, cv::Size images, cv::Size given) -> std::string {
      Calibration calibration;
      calibration.image_size = file;
      try {
         fitted_calibration(calibration, images, given);
      } catch (const InputError& problem) {
         return problem.what();
      }
      return "";
   };
   EXPECT_EQ(refusal({}, {1280, 960}, {}), "");
   EXPECT_EQ(refusal({640, 480}, {640, 480}, {}), "");
   EXPECT_EQ(refusal({640, 480}, {1280, 960}, {640, 480}), "");
   EXPECT_EQ(refusal({}, {427, 320}, {640, 480}), "") << "rounded";
   EXPECT_NE(refusal({640, 480}, {1280, 960}, {}).find("images of 640x480 but these are 1280x960"), std::string::npos);
   EXPECT_NE(refusal({640, 480}, {640, 480}, {320, 240}).find("--calibrated-size 320x240"), std::string::npos);
   EXPECT_NE(refusal({}, {640, 360}, {640, 480}).find("no scaling"), std::string::npos);
}

}  // namespace
}  // namespace stereo::app
