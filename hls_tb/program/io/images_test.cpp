// SPDX-License-Identifier: Apache-2.0
// What the pictures of a disparity map hold.
#include "program/io/images.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "definition/block_matching/models.hpp"
#include "program/io/overview.hpp"

namespace stereo::app {
namespace {

cv::Mat decoded(const std::string& png) {
   return cv::imdecode(std::vector<uint8_t>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
}

const cv::Vec3b kBlack(0, 0, 0);

TEST(Images, DisparitiesAreGreyValues) {
   DisparityMap map(4, 2, 9);
   map.at(3, 1) = 255;
   map.valid_at(0, 0) = 0;
   const cv::Mat image = decoded(encode_png(map));
   ASSERT_EQ(image.type(), CV_8UC1);
   ASSERT_EQ(image.size(), cv::Size(4, 2));
   EXPECT_EQ(image.at<uint8_t>(1, 3), 255);
   EXPECT_EQ(image.at<uint8_t>(0, 0), 9) << "also where they are not valid";
}

TEST(Images, SixteenthsHave16Bits) {
   DisparityMap map(4, 2, 9, true);
   map.at(3, 1) = 255 * 16;
   const cv::Mat image = decoded(encode_png(map));
   ASSERT_EQ(image.type(), CV_16UC1);
   EXPECT_EQ(image.at<uint16_t>(1, 3), 4080);
   EXPECT_EQ(image.at<uint16_t>(0, 0), 9);
}

TEST(Images, ValidityIsBlackAndWhite) {
   DisparityMap map(4, 2, 9);
   map.valid_at(2, 1) = 0;
   const cv::Mat image = decoded(encode_valid_png(map));
   ASSERT_EQ(image.type(), CV_8UC1);
   EXPECT_EQ(image.at<uint8_t>(1, 2), 0);
   EXPECT_EQ(cv::countNonZero(image == 255), 7);
}

TEST(Images, InvalidPixelsHaveNoColour) {
   DisparityMap map(4, 2, 9);
   map.valid_at(2, 1) = 0;
   const cv::Mat image = decoded(encode_color_png(map, 16));
   ASSERT_EQ(image.type(), CV_8UC3);
   for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 4; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x) == kBlack, x == 2 && y == 1) << x << ' ' << y;
}

TEST(Images, ColoursAreThoseOfPixelsWhateverTheUnit) {
   DisparityMap pixels(8, 1), sixteenths(8, 1, 0, true);
   for (int x = 0; x < 8; ++x) {
      pixels.at(x, 0) = uint16_t(x);
      sixteenths.at(x, 0) = uint16_t(16 * x);
   }
   EXPECT_EQ(encode_color_png(pixels, 8), encode_color_png(sixteenths, 8));
}

TEST(Images, TheOverviewPutsTheMapWhereItBelongs) {
   const ImagePair pair{GrayImage(300, 200, 90), GrayImage(300, 200, 90)};
   const auto columns_of_the_map = [&pair](Reference reference) {
      const block_matching::Matching parameters{.disparities = 60, .reference = reference};
      DisparityMap map(map_width(300, parameters), 200, 30);
      const cv::Mat page = decoded(encode_overview_png(pair, map, map_geometry(parameters, 300)));
      std::vector<int> columns;  // of colour, left of the colour bar
      for (int x = 600; x < 920; ++x) {
         const cv::Vec3b pixel = page.at<cv::Vec3b>(150, x);
         if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) columns.push_back(x);
      }
      return columns;
   };
   const auto right = columns_of_the_map(Reference::right), left = columns_of_the_map(Reference::left);
   ASSERT_EQ(right.size(), 240u);
   ASSERT_EQ(left.size(), 240u);
   EXPECT_EQ(right.back() - right.front(), 239);
   EXPECT_EQ(left.front() - right.front(), 60);
}

}  // namespace
}  // namespace stereo::app
