// SPDX-License-Identifier: Apache-2.0
// Calibrations as others write them, of cameras that are known: what is read is these cameras, and what is rectified is
// what OpenCV makes of them.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "testing/seed.hpp"
#include "testing/written_calibrations.hpp"

namespace stereo::app {
namespace {

using namespace test;

constexpr int kRounds = 4;

std::string sentence(const Written& written) {
   try {
      load_written(written);
   } catch (const InputError& problem) {
      return problem.what();
   }
   return "taken";
}

void expect_same(const cv::Mat& found, const cv::Mat& wanted, double tolerance, const char* what) {
   ASSERT_EQ(found.size(), wanted.size()) << what;
   EXPECT_LE(cv::norm(found, wanted, cv::NORM_INF), tolerance) << what << "\n" << found << "\n" << wanted;
}

/// The cameras, and the rectification that OpenCV makes of them. `unit`: of T.
void expect_pair(const Calibration& found, const Pair& pair, double unit_mm) {
   constexpr double kTolerance = 1e-9;
   expect_same(found.m1, pair.m1, kTolerance, "M1");
   expect_same(found.m2, pair.m2, kTolerance, "M2");
   expect_same(found.r, pair.r, kTolerance, "R");
   expect_same(found.t * unit_mm / 1000, pair.t, kTolerance, "T");
   EXPECT_EQ(found.unit_mm, unit_mm);
   EXPECT_EQ(found.image_size, kCameraSize);
   EXPECT_EQ(found.lens, pair.fisheye ? Lens::fisheye : Lens::radial);
   const Rectification made = make_rectification(found, kCameraSize.width, kCameraSize.height);
   EXPECT_NEAR(made.geometry.focal_px(), pair.q.at<double>(2, 3), 1e-6);
   EXPECT_NEAR(made.geometry.baseline() * unit_mm / 1000, 1 / pair.q.at<double>(3, 2), 1e-9);
   EXPECT_NEAR(made.geometry.cx_px(), -pair.q.at<double>(0, 3), 1e-6);
   cv::Mat x, y;
   const auto maps = [&](const cv::Mat& m, const cv::Mat& d, const cv::Mat& r, const cv::Mat& p) {
      if (pair.fisheye) cv::fisheye::initUndistortRectifyMap(m, d, r, p, kCameraSize, CV_32FC1, x, y);
      else cv::initUndistortRectifyMap(m, d, r, p, kCameraSize, CV_32FC1, x, y);
   };
   maps(pair.m1, pair.d1, pair.r1, pair.p1);
   expect_same(made.left_x, x, 1e-3, "left x");
   expect_same(made.left_y, y, 1e-3, "left y");
   maps(pair.m2, pair.d2, pair.r2, pair.p2);
   expect_same(made.right_x, x, 1e-3, "right x");
   expect_same(made.right_y, y, 1e-3, "right y");
}

TEST(RosCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true}) {
         const Pair pair = random_pair(random, fisheye);
         for (const Written& written : {Written{ros_file(pair, true), ros_file(pair, false)},
                                        {ros_message(pair, true), ros_message(pair, false)},
                                        {ros_both(pair), ""}}) {
            const Calibration found = load_written(written);
            expect_pair(found, pair, 1000);
            expect_same(found.d1, pair.d1, 0, "D1");
            const RectifiedGeometry rectified = rectified_geometry(found);
            EXPECT_NEAR(rectified.focal_px(), pair.q.at<double>(2, 3), 1e-9);
            EXPECT_NEAR(rectified.baseline(), 1 / pair.q.at<double>(3, 2), 1e-9);
         }
      }
}

/// Without k3, which Kalibr does not have.
Pair without_fifth(Pair pair) {
   if (pair.fisheye) return pair;
   pair.d1.at<double>(4) = pair.d2.at<double>(4) = 0;
   add_rectification(pair);
   return pair;
}

TEST(KalibrCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true})
         for (const Chain chain : {Chain::direct, Chain::imu, Chain::both}) {
            const Pair pair = without_fifth(random_pair(random, fisheye));
            const Calibration found = load_written({kalibr(pair, chain), ""});
            expect_pair(found, pair, 1000);
            expect_same(found.d2, pair.d2.colRange(0, 4), 0, "D2");
         }
}

TEST(MatlabCalibration, IsThePairThatWasCalibrated) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const Release release : {Release::rows, Release::columns, Release::both}) {
         const Pair pair = random_pair(random, false);
         const std::string text = matlab(pair, release);
         for (const std::string& whole : {text, "{\"stereoParams\":" + text + "}"}) {
            const Calibration found = load_written({whole, ""});
            expect_pair(found, pair, 1);
            expect_same(found.d1, pair.d1, 0, "D1");
         }
      }
}

TEST(MatlabCalibration, UnitsAreThoseOfItsWord) {
   Random random(test::test_seed());
   const Pair pair = random_pair(random, false);
   const std::string text = matlab(pair);
   const std::string end = "\"WorldUnits\":\"millimeters\"}";
   const auto with = [&](const std::string& units) {
      return load_written({text.substr(0, text.size() - end.size()) + units + "}", ""});
   };
   EXPECT_EQ(with("\"WorldUnits\":\"m\"").unit_mm, 1000);
   EXPECT_EQ(with("\"WorldUnits\":\"inches\"").unit_mm, 25.4);
   EXPECT_EQ(with("\"WorldUnits\":\"squares\"").unit_mm, 0);
   EXPECT_NE(with("\"WorldUnits\":\"squares\"").unknown_unit.find("squares"), std::string::npos);
   EXPECT_EQ(with("\"NumPatterns\":1").unit_mm, 1) << "that of CameraParameters1";
}

TEST(OpenCvCalibration, FisheyeIsSaidByTheFileOrTheUser) {
   Random random(test::test_seed());
   const Pair fisheye = random_pair(random, true);
   Pair radial = fisheye;
   radial.fisheye = false;
   add_rectification(radial);
   const std::string model = "distortion_model: ";
   const auto expect = [](const Written& written, const Pair& pair) {
      const Calibration found = load_written(written);
      EXPECT_EQ(found.lens, pair.fisheye ? Lens::fisheye : Lens::radial);
      const Rectification made = make_rectification(found, kCameraSize.width, kCameraSize.height);
      EXPECT_NEAR(made.geometry.focal_px(), pair.q.at<double>(2, 3), 1e-6);
   };
   expect({opencv(fisheye, "M", model + "equidistant\n"), ""}, fisheye);
   expect({opencv(fisheye, "K", model + "fisheye\n"), ""}, fisheye);
   expect({opencv(fisheye, "M"), "", true}, fisheye);
   expect({opencv(fisheye, "K"), "", true}, fisheye);
   expect({opencv(radial, "M"), ""}, radial);
   expect({opencv(radial, "K", model + "plumb_bob\n"), ""}, radial);
   EXPECT_NE(std::abs(fisheye.q.at<double>(2, 3) - radial.q.at<double>(2, 3)), 0) << "else nothing was told";
   EXPECT_NE(sentence({opencv(fisheye, "K"), ""}).find("give --fisheye"), std::string::npos);
   EXPECT_NE(sentence({opencv(radial, "M", model + "plumb_bob\n"), "", true}).find("of another model"),
             std::string::npos);
   EXPECT_NE(sentence({opencv(radial, "M", model + "scaramuzza\n"), ""}).find("distortion_model is scaramuzza"),
             std::string::npos);
   const Pair five = random_pair(random, false);
   EXPECT_NE(sentence({opencv(five, "M", model + "equidistant\n"), ""}).find("5 coefficients"), std::string::npos);
   EXPECT_NE(sentence({opencv(five, "K", opencv_matrix("M1", five.m1)), ""}).find("K1 stands beside its M1"),
             std::string::npos);
}

}  // namespace
}  // namespace stereo::app
