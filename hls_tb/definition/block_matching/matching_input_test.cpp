// SPDX-License-Identifier: Apache-2.0
// Where the map stands, and what cannot be matched.
#include "definition/block_matching/matching_input.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace stereo::test {
namespace {

/// The cost columns as docs/algorithm.md has them: x and all x+m+d lie in the image.
bool is_cost_column(int x, int width, const block_matching::Matching& parameters) {
   for (int d = 0; d < parameters.disparities; ++d) {
      const int other = x + parameters.min_disparity + d;
      if (x < 0 || x >= width || other < 0 || other >= width) return false;
   }
   return true;
}

TEST(Matching, CostColumnsAreThoseInsideBothImages) {
   constexpr int kWidth = 20;
   for (const int disparities : {1, 2, 7, 19})
      for (int min_disparity = -25; min_disparity <= 25; ++min_disparity) {
         const block_matching::Matching parameters{DisparityCount{disparities}, SmallestDisparity{min_disparity}};
         int count = 0, first = -1;
         for (int x = kWidth - 1; x >= 0; --x)
            if (is_cost_column(x, kWidth, parameters)) {
               ++count;
               first = x;
            }
         if (count == 0) {
            EXPECT_LE(cost_columns(kWidth, parameters), 0) << disparities << ' ' << min_disparity;
            continue;
         }
         EXPECT_EQ(cost_columns(kWidth, parameters), count) << disparities << ' ' << min_disparity;
         EXPECT_EQ(first_cost_column(parameters), first) << disparities << ' ' << min_disparity;
         EXPECT_EQ(map_first_column(parameters), first) << disparities << ' ' << min_disparity;
      }
}

TEST(Matching, TheMapOfALeftReferenceIsTheMirrorImage) {
   constexpr int kWidth = 20;
   for (const int disparities : {1, 2, 7, 12})
      for (const int min_disparity : {-15, -6, -1, 0, 1, 6}) {
         block_matching::Matching parameters{DisparityCount{disparities}, SmallestDisparity{min_disparity}};
         const int last = map_first_column(parameters) + map_width(kWidth, parameters) - 1;
         parameters.reference = Reference::left;
         EXPECT_EQ(map_first_column(parameters), kWidth - 1 - last) << disparities << ' ' << min_disparity;
      }
}

TEST(Matching, LargestCostOfAPixel) {
   block_matching::Matching parameters{DisparityCount{8}};
   EXPECT_EQ(largest_pixel_cost(parameters), 255);
   parameters.cost = Cost::ssd;
   EXPECT_EQ(largest_pixel_cost(parameters), 65025);
   parameters.prefilter = Prefilter::xsobel;
   parameters.prefilter_cap = 10;
   EXPECT_EQ(largest_pixel_cost(parameters), 400);
   parameters.cost = Cost::sad;
   EXPECT_EQ(largest_pixel_cost(parameters), 20);
   parameters.cost = Cost::census;
   EXPECT_EQ(largest_pixel_cost(parameters), 24);
}

void expect_rejected(const GrayImage& left, const GrayImage& right, const block_matching::Matching& parameters,
                     const std::string& reason) {
   try {
      check_matching_input(left, right, parameters);
      ADD_FAILURE() << "accepted: " << reason;
   } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
   }
}

TEST(Matching, RejectsImagesThatCannotBeMatched) {
   const GrayImage good(20, 10);
   expect_rejected(GrayImage(1, 1), GrayImage(1, 1), {DisparityCount{1}, MatchingWindow{3}},
                   "wider than the disparity range 1");
   expect_rejected(GrayImage(1, 9), GrayImage(1, 9), {DisparityCount{2}, MatchingWindow{3}},
                   "wider than the disparity range 2");
   expect_rejected(GrayImage(20, 1), GrayImage(20, 1), {DisparityCount{20}, MatchingWindow{3}},
                   "wider than the disparity range 20");
   expect_rejected(GrayImage(), GrayImage(), {DisparityCount{2}, MatchingWindow{3}}, "no pixels");
   expect_rejected(GrayImage(20, 0), GrayImage(20, 0), {DisparityCount{2}, MatchingWindow{3}}, "no pixels");
   expect_rejected(good, GrayImage(20, 11), {DisparityCount{5}, MatchingWindow{3}}, "left is 20x10, right is 20x11");
   expect_rejected(good, GrayImage(19, 10), {DisparityCount{5}, MatchingWindow{3}}, "differ in size");
}

TEST(Matching, RejectsOptionsOutOfRange) {
   const GrayImage good(20, 10);
   const auto reject = [&good](block_matching::Matching parameters, const std::string& reason) {
      expect_rejected(good, good, parameters, reason);
   };
   reject({DisparityCount{5}, MatchingWindow{0}}, "window side is 0");
   reject({DisparityCount{5}, MatchingWindow{-1}}, "window side is -1");
   reject({DisparityCount{0}, MatchingWindow{3}}, "disparity range is 0");
   expect_rejected(GrayImage(300, 2), GrayImage(300, 2), {DisparityCount{257}, MatchingWindow{3}},
                   "disparity range is 257");
   reject({DisparityCount{5}, SmallestDisparity{15}}, "from the smallest disparity 15 on lies outside");
   reject({DisparityCount{5}, SmallestDisparity{-19}}, "from the smallest disparity -19 on lies outside");
   reject({DisparityCount{5}, SmallestDisparity{-2147483647 - 1}}, "must be -16777216 ... 16777216");
   reject({DisparityCount{5}, SmallestDisparity{2147483647}}, "must be -16777216 ... 16777216");
   reject({DisparityCount{5}, CensusWindow{.census_width_px = 11}}, "census window's width is 11");
   reject({DisparityCount{5}, CensusWindow{.census_height_px = 9}}, "census window's height is 9");
   reject({DisparityCount{5}, CensusWindow{.census_width_px = 4}}, "census window is 4x5");
   reject({DisparityCount{5}, CensusWindow{.census_height_px = 6}}, "census window is 5x6");
   reject({DisparityCount{5}, Prefiltering{.prefilter_cap = 0}}, "cap is 0 but must be 1 ... 63");
   reject({DisparityCount{5}, Prefiltering{.prefilter_cap = 64}}, "cap is 64");
   reject({DisparityCount{5}, Comparison{Cost::census}, Prefiltering{.prefilter = Prefilter::xsobel}},
          "takes no prefilter");
   reject({DisparityCount{5}, LeftRightThreshold{5}}, "left/right threshold is 5 but must be -1 ... 4");
   reject({DisparityCount{5}, LeftRightThreshold{-2}}, "left/right threshold is -2");
   reject({DisparityCount{5}, UniquenessPercent{101}}, "uniqueness in percent is 101");
   reject({DisparityCount{5}, UniquenessPercent{-1}}, "uniqueness in percent is -1");
   reject({DisparityCount{5}, block_matching::TextureThreshold{1}}, "the texture check needs the prefilter");
   reject({DisparityCount{5}, block_matching::TextureThreshold{-1}}, "texture threshold is -1");
   reject({DisparityCount{5}, Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = 10},
           block_matching::TextureThreshold{91}},
          "texture threshold is 91 but must be 0 ... 90");
}

TEST(Matching, RejectsWindowCostsBeyond31Bits) {
   const GrayImage tall(4, 20000);
   block_matching::Matching parameters{DisparityCount{2}, MatchingWindow{11008}, Comparison{Cost::ssd}};
   EXPECT_NO_THROW(check_matching_input(tall, tall, parameters));  // 3 * 11008 * 65025 = 2147385600
   parameters.window_px = 20000;
   expect_rejected(tall, tall, parameters, "window costs must stay below 2^31");
}

TEST(Matching, AcceptsTheEndsOfTheRanges) {
   const GrayImage good(20, 10);
   for (const block_matching::Matching& parameters :
        {block_matching::Matching{DisparityCount{1}, MatchingWindow{1}},
         block_matching::Matching{DisparityCount{19}, MatchingWindow{2}},
         block_matching::Matching{DisparityCount{5}, SmallestDisparity{14}},
         block_matching::Matching{DisparityCount{5}, SmallestDisparity{-18}},
         block_matching::Matching{DisparityCount{5}, Comparison{Cost::census},
                                  CensusWindow{.census_width_px = 9, .census_height_px = 7}},
         block_matching::Matching{DisparityCount{5}, Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = 63},
                                  LeftRightThreshold{4}, UniquenessPercent{100},
                                  block_matching::TextureThreshold{567}}})
      EXPECT_NO_THROW(check_matching_input(good, good, parameters));
}

}  // namespace
}  // namespace stereo::test
