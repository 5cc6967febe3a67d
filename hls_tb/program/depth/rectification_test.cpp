// SPDX-License-Identifier: Apache-2.0
// Rectified cameras, against what a lens does by its definition.
#include "program/depth/rectification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "program/errors.hpp"
#include "testing/seed.hpp"
#include "testing/written_calibrations.hpp"

namespace stereo::app {
namespace {

using namespace test;

constexpr int kRounds = 4;

TEST(FisheyeRectification, CamerasThatStandOtherwiseAreRefused) {
   const auto refusal = [](const cv::Mat& t) {
      const Pair pair = simple_pair(true);
      Calibration calibration = load_written({kalibr(pair), ""});
      calibration.t = t;
      try {
         make_rectification(calibration, kCameraSize.width, kCameraSize.height);
      } catch (const InputError& problem) {
         return std::string(problem.what());
      }
      return std::string("taken");
   };
   EXPECT_EQ(refusal((cv::Mat_<double>(3, 1) << -0.1, 0, 0)), "taken");
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << -0.01, -0.1, 0)).find("one above the other"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << -0.01, 0, 0.1)).find("one behind the other"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << 0.1, 0, 0)).find("exchange"), std::string::npos);
   EXPECT_NE(refusal((cv::Mat_<double>(3, 1) << 0, 0, 0)), "taken");
}

/// Where a lens puts what lies in a direction, from the definition of its model.
cv::Point2d seen(const cv::Vec3d& point, const cv::Mat& m, const cv::Mat& d, bool fisheye) {
   const auto k = [&d](int i) { return i < int(d.total()) ? d.at<double>(i) : 0; };
   double x = point[0] / point[2], y = point[1] / point[2];
   const double r2 = x * x + y * y;
   if (fisheye) {
      const double r = std::sqrt(r2), a = std::atan(r), a2 = a * a;
      const double bent = a * (1 + a2 * (k(0) + a2 * (k(1) + a2 * (k(2) + a2 * k(3)))));
      x *= r > 0 ? bent / r : 1;
      y *= r > 0 ? bent / r : 1;
   } else {
      const double radial = 1 + r2 * (k(0) + r2 * (k(1) + r2 * k(4))), p1 = k(2), p2 = k(3), u = x, v = y;
      x = u * radial + 2 * p1 * u * v + p2 * (r2 + 2 * u * u);
      y = v * radial + p1 * (r2 + 2 * v * v) + 2 * p2 * u * v;
   }
   return {m.at<double>(0, 0) * x + m.at<double>(0, 2), m.at<double>(1, 1) * y + m.at<double>(1, 2)};
}

TEST(Rectification, APointIsSeenInTheSameRowAndAtItsDepth) {
   Random random(test::test_seed());
   for (int round = 0; round < kRounds; ++round)
      for (const bool fisheye : {false, true}) {
         const Pair pair = random_pair(random, fisheye);
         const Rectification made =
             make_rectification(load_written({ros_both(pair), ""}), kCameraSize.width, kCameraSize.height);
         for (int i = 0; i < 50; ++i) {
            const int x = 40 + random.below(240), y = 20 + random.below(200), d = 1 + random.below(32);
            const cv::Vec4d place = made.geometry.q * cv::Vec4d(x, y, d, 1);
            const cv::Mat point = (cv::Mat_<double>(3, 1) << place[0], place[1], place[2]) / place[3];
            const cv::Mat in_left = pair.r1.t() * point, in_right = pair.r * in_left + pair.t;
            const auto vector = [](const cv::Mat& v) { return cv::Vec3d(v.ptr<double>()); };
            const cv::Point2d left = seen(vector(in_left), pair.m1, pair.d1, fisheye);
            const cv::Point2d right = seen(vector(in_right), pair.m2, pair.d2, fisheye);
            EXPECT_NEAR(made.left_x.at<float>(y, x), left.x, 1e-3);
            EXPECT_NEAR(made.left_y.at<float>(y, x), left.y, 1e-3);
            EXPECT_NEAR(made.right_x.at<float>(y, x - d), right.x, 1e-3);
            EXPECT_NEAR(made.right_y.at<float>(y, x - d), right.y, 1e-3);
         }
      }
}

}  // namespace
}  // namespace stereo::app
