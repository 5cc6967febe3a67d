// SPDX-License-Identifier: Apache-2.0
// Calibrations of benchmarks, in the benchmarks' words, against values worked out by hand.
#include "program/depth/benchmark_calibration.hpp"

#include <gtest/gtest.h>

#include "program/depth/depth.hpp"
#include "program/errors.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

const std::string kMiddlebury =
    "cam0=[4000 0 1200; 0 4000 1000; 0 0 1]\ncam1=[4000 0 1330; 0 4000 1000; 0 0 1]\ndoffs=130\nbaseline=200\n"
    "width=2964\nheight=1988\nndisp=280\nisint=0\nvmin=31\nvmax=257\ndyavg=0.918\ndymax=1.516\n";

const std::string kKitti =
    "P0: 7.0e+02 0 6.0e+02 0 0 7.0e+02 1.8e+02 0 0 0 1 0\nP1: 7.0e+02 0 6.0e+02 -3.5e+02 0 7.0e+02 1.8e+02 0 0 0 1 0\n"
    "P2: 7.0e+02 0 6.0e+02 4.2e+01 0 7.0e+02 1.8e+02 0 0 0 1 0\nP3: 7.0e+02 0 6.0e+02 -3.36e+02 0 7.0e+02 1.8e+02 0 0 "
    "0 1 "
    "0\nTr: 1 0 0 0 0 1 0 0 0 0 1 0\n";

/// Cameras 2 and 3, the latter turned by a quarter about its axis: x of camera 0 is its y.
const std::string kCamToCam =
    "calib_time: 09-Jan-2012 13:57:47\ncorner_dist: 9.95e-02\n"
    "S_02: 1392 512\nK_02: 960 0 690 0 950 240 0 0 1\nD_02: -0.3 0.2 0.001 0.002 -0.1\nR_02: 1 0 0 0 1 0 0 0 1\n"
    "T_02: 0.06 0 0\nS_rect_02: 1242 375\nR_rect_02: 1 0 0 0 1 0 0 0 1\n"
    "P_rect_02: 700 0 600 42 0 700 180 0 0 0 1 0\n"
    "S_03: 1392 512\nK_03: 961 0 691 0 951 241 0 0 1\nD_03: -0.4 0.3 0.001 0.002 -0.2\nR_03: 0 1 0 -1 0 0 0 0 1\n"
    "T_03: -0.47 0.01 0.02\nS_rect_03: 1242 375\nP_rect_03: 700 0 600 -290.9 0 700 180 0 0 0 1 0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
   return text.replace(text.find(from), from.size(), to);
}

std::string sentence(const std::string& text) {
   try {
      return parse_benchmark_calibration(text) ? "taken" : "";
   } catch (const InputError& problem) {
      return problem.what();
   }
}

TEST(BenchmarkCalibration, Middlebury) {
   const std::optional<Calibration> found = parse_benchmark_calibration(kMiddlebury);
   ASSERT_TRUE(found);
   EXPECT_EQ(found->unit_mm, 1);
   EXPECT_EQ(found->image_size, cv::Size(2964, 1988));
   const RectifiedGeometry geometry = rectified_geometry(*found);
   EXPECT_NEAR(geometry.baseline(), 200, 1e-9);
   EXPECT_NEAR(geometry.cx_difference_px(), -130, 1e-9);
   // The benchmark's formula: z = baseline f / (d + doffs) = 200 mm * 4000 / (70 + 130).
   const Point point = points_of(DisparityImage(1, 1, 70), Reference::left, geometry, 0.001)[0];
   EXPECT_FLOAT_EQ(point.z_m, 4);
   EXPECT_FLOAT_EQ(point.x_m, -1.2F);
   EXPECT_FLOAT_EQ(point.y_m, -1);
}

TEST(BenchmarkCalibration, KittiIsOfTheColourCameras) {
   const std::optional<Calibration> found = parse_benchmark_calibration(kKitti);
   ASSERT_TRUE(found);
   EXPECT_EQ(found->unit_mm, 1000);
   EXPECT_TRUE(found->image_size.empty());
   EXPECT_NEAR(rectified_geometry(*found).baseline(), 0.54, 1e-12) << "(42 + 336) / 700";
   EXPECT_NEAR(rectified_geometry(*found).cx_px(), 600, 1e-12);
   const std::string gray = kKitti.substr(0, kKitti.find("P2"));
   EXPECT_NEAR(rectified_geometry(*parse_benchmark_calibration(gray)).baseline(), 0.5, 1e-12);
}

TEST(BenchmarkCalibration, CamToCam) {
   const std::optional<Calibration> found = parse_benchmark_calibration(kCamToCam);
   ASSERT_TRUE(found);
   EXPECT_EQ(found->unit_mm, 1000);
   EXPECT_EQ(found->image_size, cv::Size(1392, 512));
   EXPECT_EQ(found->rectified_size, cv::Size(1242, 375));
   EXPECT_NEAR(rectified_geometry(*found).baseline(), 332.9 / 700, 1e-12) << "(42 + 290.9) / 700";
   EXPECT_EQ(found->m1.at<double>(0, 0), 960);
   EXPECT_EQ(found->m2.at<double>(1, 2), 241);
   EXPECT_EQ(found->d2.at<double>(0), -0.4);
   // X_3 = R_03 X_0 + T_03 with X_0 = X_2 - (0.06, 0, 0), and R_03 (0.06, 0, 0) = (0, -0.06, 0).
   EXPECT_NEAR(found->t.at<double>(0), -0.47, 1e-12);
   EXPECT_NEAR(found->t.at<double>(1), 0.07, 1e-12);
   EXPECT_NEAR(found->t.at<double>(2), 0.02, 1e-12);
   EXPECT_EQ(found->r.at<double>(0, 1), 1);
   EXPECT_EQ(found->r.at<double>(1, 0), -1);
}

TEST(BenchmarkCalibration, OthersAreNone) {
   for (const std::string text : {"", "hello", "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n", "P2: 1 2 3\n"})
      EXPECT_EQ(sentence(text), "") << text;
}

TEST(BenchmarkCalibration, DamagedOnesAreRefused) {
   const std::pair<std::string, std::string> cases[] = {
       {replaced(kMiddlebury, "doffs=130", "doffs=13"), "its doffs is 13 but"},
       {replaced(kMiddlebury, "doffs=130\n", ""), "it has no doffs"},
       {replaced(kMiddlebury, "baseline=200", "baseline=wide"), "its baseline is not 1 number"},
       {replaced(kMiddlebury, "baseline=200", "baseline=inf"), "its baseline is not 1 number"},
       {replaced(kMiddlebury, "width=2964", "width=0"), "its image size"},
       {replaced(kMiddlebury, "width=2964", "width=1e9"), "its image size"},
       {replaced(kMiddlebury, "cam1=[4000 0", "cam1=[4000"), "its cam1 is not 9 numbers"},
       {replaced(kMiddlebury, "cam1", "cam2"), "it has no cam1"},
       {replaced(kKitti, "P3", "P4"), "it has no P3"},
       {replaced(kKitti, "P2: 7.0e+02", "P2: 7.0e+02x"), "its P2 is not 12 numbers"},
       {replaced(kCamToCam, "P_rect_03", "P_rect_04"), "it has no P_rect_03"},
       {replaced(kCamToCam, "T_03: -0.47", "T_03:"), "its T_03 is not 3 numbers"},
       {replaced(kCamToCam, "S_02: 1392", "S_02: 13.5"), "its image size"}};
   for (const auto& [text, words] : cases) EXPECT_NE(sentence(text).find(words), std::string::npos) << sentence(text);
}

TEST(BenchmarkCalibration, SurvivesDamage) {
   Random random(test::test_seed());
   int taken = 0;
   for (const std::string& whole : {kMiddlebury, kKitti, kCamToCam})
      for (int round = 0; round < 3000; ++round) {
         std::string damaged = whole.substr(0, std::size_t(random.below(int(whole.size()) * 2)));
         for (int i = random.below(4); i > 0 && !damaged.empty(); --i)
            damaged[std::size_t(random.below(int(damaged.size())))] = char(random.below(256));
         taken += sentence(damaged) == "taken" ? 1 : 0;
      }
   EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace stereo::app
