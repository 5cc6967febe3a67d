// SPDX-License-Identifier: Apache-2.0
#include "program/io/png_mark.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

namespace stereo::app {
namespace {

TEST(PngMark, IsFoundAgainAndLeavesTheImage) {
   cv::Mat image(5, 7, CV_8UC3);
   cv::randu(image, 0, 255);
   std::vector<uchar> bytes;
   cv::imencode(".png", image, bytes);
   const std::string plain(bytes.begin(), bytes.end()), marked = marked_png(plain);
   const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "png_mark_test.png";
   for (const std::string& content : {plain, marked, std::string("short")}) {
      std::ofstream(path, std::ios::binary) << content;
      EXPECT_EQ(is_marked_png(path), content == marked);
   }
   std::ofstream(path, std::ios::binary) << marked;
   EXPECT_EQ(cv::countNonZero(cv::imread(path.string()).reshape(1) != image.reshape(1)), 0);
   std::filesystem::remove(path);
   EXPECT_FALSE(is_marked_png(path)) << "it is not there";
}

}  // namespace
}  // namespace stereo::app
