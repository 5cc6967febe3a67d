// SPDX-License-Identifier: Apache-2.0
// How far the integer rectification is from cv::remap, on calibrations as cameras have them.
#include "program/rectification/map_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <opencv2/calib3d.hpp>

#include "program/depth/rectification.hpp"
#include "program/errors.hpp"
#include "scene/random.hpp"
#include "scene/scene.hpp"
#include "testing/seed.hpp"

namespace stereo::app {
namespace {

using rectification::Table;
using rectification::Warp;
using test::test_seed;

constexpr int kWidth = 320, kHeight = 240;

cv::Mat random_camera(Random& random) {
   const double focal = random.between(0.7, 1.2) * kWidth;
   return (cv::Mat_<double>(3, 3) << focal, 0, kWidth / 2.0 + random.between(-8, 8), 0,
           focal * random.between(0.99, 1.01), kHeight / 2.0 + random.between(-8, 8), 0, 0, 1);
}

/// Barrel or cushion: k1 k2 p1 p2 k3.
cv::Mat random_distortion(Random& random) {
   return (cv::Mat_<double>(1, 5) << random.between(-0.3, 0.1), random.between(-0.05, 0.1), random.between(-1e-3, 1e-3),
           random.between(-1e-3, 1e-3), 0);
}

/// Cameras side by side, each axis a degree or so away from the other camera's.
Calibration random_calibration(Random& random) {
   Calibration calibration;
   calibration.m1 = random_camera(random);
   calibration.m2 = random_camera(random);
   calibration.d1 = random_distortion(random);
   calibration.d2 = random_distortion(random);
   const auto angle = [&random] { return random.between(-0.025, 0.025); };
   const cv::Vec3d axis(angle(), angle(), angle());
   cv::Rodrigues(axis, calibration.r);
   calibration.t = (cv::Mat_<double>(3, 1) << -100, random.between(-2, 2), random.between(-2, 2));
   return calibration;
}

struct Rectified {
   Table table;
   Difference place, grey;
   Difference deep_grey;  ///< of the same scene with pixels of kDeepBits
};
constexpr int kDeepBits = 12;
constexpr int kDeepLevels = 16;  // for one of 8 bits

/// The left image of the scene as if a camera had taken it.
Rectified rectified_left(const Calibration& calibration, const Warp& warp, const GrayImage& source) {
   const DeepImage deep = deepened({source, source}, kDeepBits, test_seed()).left;
   Warp deep_warp = warp;
   deep_warp.pixel_bits = kDeepBits;
   const Rectification made = make_rectification(calibration, source.width, source.height, warp.grid_px);
   const RemapMaps maps{made.left_x, made.left_y, {source.width, source.height}};
   Table table = table_of(maps, warp, "left camera");
   const GrayImage image = rectified(source, table, warp);
   const Difference place = place_difference(table, warp, maps);
   const Difference deep_grey = grey_difference(rectified(deep, table, deep_warp), deep, maps);
   return {std::move(table), place, grey_difference(image, source, maps), deep_grey};
}

constexpr Warp with_grid(int grid_px) {
   Warp warp;
   warp.grid_px = grid_px;
   warp.rows_above = warp.rows_below = 255;
   return warp;
}

/// What may at most lie between the table and the maps, for a distance of the nodes.
struct Bound {
   int grid_px;
   double place, mean_place, grey, mean_grey;
};
constexpr Bound kBounds[] = {{8, 0.12, 0.03, 18, 0.4}, {16, 0.38, 0.12, 45, 1.2}, {32, 1.6, 0.5, 120, 5}};

TEST(MapTable, IsCloseToRemapOnRandomCalibrations) {
   constexpr int kRounds = 30;
   double mean_of_finer = 0;
   for (const Bound& bound : kBounds) {
      Random random(test_seed());
      Difference place, grey, deep_grey;  // the largest, and the mean of the means
      for (int round = 0; round < kRounds; ++round) {
         const uint64_t seed = random.bits();
         SCOPED_TRACE("calibration of seed " + std::to_string(seed));
         Random of_round(seed);
         const Calibration calibration = random_calibration(of_round);
         const GrayImage source =
             make_scene({.width = kWidth, .height = kHeight, .disparities = 40, .seed = seed}).images.left;
         const Rectified made = rectified_left(calibration, with_grid(bound.grid_px), source);
         EXPECT_LE(made.place.largest, bound.place);
         EXPECT_LE(made.place.mean, bound.mean_place);
         EXPECT_LE(made.grey.largest, bound.grey);
         EXPECT_LE(made.grey.mean, bound.mean_grey);
         EXPECT_LE(made.deep_grey.largest, kDeepLevels * bound.grey);
         EXPECT_LE(made.deep_grey.mean, kDeepLevels * bound.mean_grey);
         place = {std::max(place.largest, made.place.largest), place.mean + made.place.mean / kRounds};
         grey = {std::max(grey.largest, made.grey.largest), grey.mean + made.grey.mean / kRounds};
         deep_grey = {std::max(deep_grey.largest, made.deep_grey.largest),
                      deep_grey.mean + made.deep_grey.mean / kRounds};
      }
      EXPECT_GT(grey.mean, mean_of_finer);
      mean_of_finer = grey.mean;
      std::cout << bound.grid_px << " px: " << with_grid(bound.grid_px).table_bits(kWidth, kHeight)
                << " bits a camera; from the float maps at most " << place.largest << " px, mean " << place.mean
                << " px; from cv::remap at most " << grey.largest << " grey levels, mean " << grey.mean << ", of "
                << kDeepBits << " bits " << deep_grey.largest << ", mean " << deep_grey.mean << "\n";
   }
}

TEST(MapTable, IsRemapWhereTheMapsAreStraight) {
   // A turned camera of a long focal length: between the nodes the maps are all but straight.
   constexpr int kFocal = 20000;
   Calibration calibration;
   calibration.m1 = (cv::Mat_<double>(3, 3) << kFocal, 0, 160, 0, kFocal, 120, 0, 0, 1);
   calibration.m2 = calibration.m1;
   cv::Rodrigues(cv::Vec3d(0, 0, 0.02), calibration.r);
   calibration.t = (cv::Mat_<double>(3, 1) << -100, 0, 0);
   Warp warp = with_grid(16);
   warp.offset_fraction_bits = 8;
   const GrayImage source = make_scene({.width = kWidth, .height = kHeight, .disparities = 40}).images.left;
   const Rectified made = rectified_left(calibration, warp, source);
   EXPECT_LE(made.place.largest, 0.025) << "in each direction half of 1/32 px, and of a node half of 1/256 px";
   EXPECT_LE(made.grey.largest, 5);
   EXPECT_LE(made.grey.mean, 0.03);
   EXPECT_LE(made.deep_grey.largest, kDeepLevels * 5);
   EXPECT_LE(made.deep_grey.mean, kDeepLevels * 0.03);
}

TEST(MapTable, RefusesOffsetsThatItsBitsCannotSay) {
   const cv::Mat x = cv::Mat(48, 48, CV_32FC1, cv::Scalar(31.9)), y = cv::Mat(48, 48, CV_32FC1, cv::Scalar(0));
   const RemapMaps maps{x, y, {32, 32}};
   Warp warp;
   warp.offset_bits = 12;  // -32 ... 31.98
   EXPECT_EQ(table_of(maps, warp, "left camera").at(0, 0), (rectification::Offset{2042, 0}));
   const auto refused = [&](float value) {
      const cv::Mat wrong(48, 48, CV_32FC1, cv::Scalar(value));
      try {
         table_of({wrong, y, {32, 32}}, warp, "left camera");
      } catch (const InputError& problem) {
         return std::string(problem.what()).find("its left camera has pixels that move farther") != std::string::npos;
      }
      return false;
   };
   EXPECT_TRUE(refused(32.1F));
   EXPECT_TRUE(refused(1e30F));
   EXPECT_TRUE(refused(std::nanf("")));
}

TEST(MapTable, MeasuresDifferences) {
   cv::Mat x(32, 32, CV_32FC1), y(32, 32, CV_32FC1);
   for (int row = 0; row < 32; ++row)
      for (int column = 0; column < 32; ++column) {
         x.at<float>(row, column) = float(column);
         y.at<float>(row, column) = float(row);
      }
   const RemapMaps maps{x, y, {16, 16}};
   const Warp warp;
   Table table = table_of(maps, warp, "left camera");
   GrayImage source(16, 16, 100);
   EXPECT_EQ(grey_difference(rectified(source, table, warp), source, maps).largest, 0);
   EXPECT_EQ(place_difference(table, warp, maps).largest, 0);
   GrayImage other = source;
   other.at(3, 3) = 90;
   EXPECT_EQ(grey_difference(other, source, maps).largest, 10);
   EXPECT_EQ(grey_difference(other, source, maps).mean, 10 / 256.0);
   Warp deep_warp = warp;
   deep_warp.pixel_bits = kDeepBits;
   const DeepImage deep_source(16, 16, 4000);
   EXPECT_EQ(grey_difference(rectified(deep_source, table, deep_warp), deep_source, maps).largest, 0);
   DeepImage deep_other = deep_source;
   deep_other.at(3, 3) = 3000;
   EXPECT_EQ(grey_difference(deep_other, deep_source, maps).largest, 1000);
   for (int j = 0; j < table.rows; ++j) table.at(0, j).x = 64;
   EXPECT_EQ(place_difference(table, warp, maps).largest, 1);
   EXPECT_EQ(place_difference(table, warp, maps).mean, 8.5 / 16) << "16/16, 15/16 ... 1/16 from the left to the right";
}

}  // namespace
}  // namespace stereo::app
