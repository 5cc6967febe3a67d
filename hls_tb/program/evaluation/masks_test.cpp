// SPDX-License-Identifier: Apache-2.0
// The regions of small maps, drawn by hand.
#include "program/evaluation/masks.hpp"

#include <gtest/gtest.h>

namespace stereo::app {
namespace {

constexpr float kNone = kNoDisparity;

DisparityImage row(const std::vector<float>& values) {
   DisparityImage image(int(values.size()), 1);
   image.px = values;
   return image;
}

/// '#' where the mask is 255, '.' where it is 0.
std::string drawn(const GrayImage& mask, int y = 0) {
   std::string text;
   for (int x = 0; x < mask.width; ++x) text += mask.at(x, y) == 255 ? '#' : mask.at(x, y) == 0 ? '.' : '?';
   return text;
}

// A wall of disparity 1; before it, in columns 4 and 5 of the left image, a post of disparity 3.
TEST(Masks, OcclusionBehindAPost) {
   const DisparityImage left = row({1, 1, 1, 1, 3, 3, 1, 1, 1});
   const DisparityImage right = row({1, 3, 3, 1, 1, 1, 1, 1, 1});
   // Column 0 leaves the image; 2 and 3 lead to the post, which is nearer by 2.
   EXPECT_EQ(drawn(non_occluded_mask(left, right, Reference::left)), ".#..#####");
   // The last column leaves the image. 3 and 4 lead to the post.
   EXPECT_EQ(drawn(non_occluded_mask(right, left, Reference::right)), "###..###.");
}

TEST(Masks, SearchableColumnsHaveTheWholeRangeInTheOtherImage) {
   GrayImage visible(8, 1);
   for (uint8_t& pixel : visible.pixels) pixel = 255;
   visible.at(5, 0) = 0;
   EXPECT_EQ(drawn(searchable_mask(visible, {0, 3}, Reference::left)), "...##.##");
   EXPECT_EQ(drawn(searchable_mask(visible, {0, 3}, Reference::right)), "#####...");
   EXPECT_EQ(drawn(searchable_mask(visible, {1, 3}, Reference::left)), "....#.##");
   EXPECT_EQ(drawn(searchable_mask(visible, {-2, 3}, Reference::left)), ".####...") << "they lead out at the other end";
   EXPECT_EQ(drawn(searchable_mask(visible, {0, 99}, Reference::left)), "........");
}

TEST(Masks, OcclusionNeedsKnownDisparitiesAndMoreThanOnePixel) {
   EXPECT_EQ(drawn(non_occluded_mask(row({1, 1, 1, kNone, 1}), row({2, 2.25F, 1, kNone, 1}), Reference::left)),
             ".#...");
   // 0.5, 1.5 and 2.5 round to the even neighbour, 0, 2 and 2, as cvRound does.
   EXPECT_EQ(drawn(non_occluded_mask(row({0.5F, 1.5F, 2.5F}), row({0, 9, 9}), Reference::left)), "#.#");
}

TEST(Masks, OcclusionOfMapsThatLeadFarAway) {
   EXPECT_EQ(drawn(non_occluded_mask(row({65536, -65536, 0}), row({0, 0, 0}), Reference::left)), "..#");
}

TEST(Masks, DiscontinuityIsASquareOfNineAroundAStep) {
   DisparityImage truth(30, 20, 5);
   for (int y = 0; y < 20; ++y)
      for (int x = 15; x < 30; ++x) truth.at(x, y) = 7;
   EXPECT_EQ(drawn(discontinuity_mask(truth), 10), std::string(30, '.')) << "a gap of 2 is none";
   for (int y = 0; y < 20; ++y)
      for (int x = 15; x < 30; ++x) truth.at(x, y) = 7.25F;
   EXPECT_EQ(drawn(discontinuity_mask(truth), 10), "..........##########..........") << "14 and 15, 4 on each side";
}

TEST(Masks, DiscontinuityDoesNotComeFromUnknownPixels) {
   DisparityImage truth(30, 20, 5);
   truth.at(15, 10) = kNone;
   for (int y = 0; y < 20; ++y) EXPECT_EQ(drawn(discontinuity_mask(truth), y), std::string(30, '.'));
   truth.at(16, 10) = 9;  // it and its seven known neighbours, columns 15 ... 17 and rows 9 ... 11
   EXPECT_EQ(drawn(discontinuity_mask(truth), 10), "...........###########........");
   EXPECT_EQ(drawn(discontinuity_mask(truth), 4), std::string(30, '.'));
   EXPECT_EQ(drawn(discontinuity_mask(truth), 5), "...........###########........");
}

// A ramp of g grey levels a pixel has the gradient 8 g / 8 = g: its square is compared with 4.
TEST(Masks, TexturelessIsAGradientBelowTwo) {
   for (const int slope : {1, 2, 3}) {
      GrayImage image(20, 8);
      for (int y = 0; y < 8; ++y)
         for (int x = 0; x < 20; ++x) image.at(x, y) = uint8_t(slope * x);
      EXPECT_EQ(drawn(textureless_mask(image), 4).substr(2, 16), std::string(16, slope == 1 ? '#' : '.')) << slope;
   }
   // An edge of 12 at column 10: the gradient is 6 in columns 9 and 10, the mean of 3 columns 12, 24, 24, 12.
   GrayImage edge(20, 8, 50);
   for (int y = 0; y < 8; ++y)
      for (int x = 10; x < 20; ++x) edge.at(x, y) = 62;
   EXPECT_EQ(drawn(textureless_mask(edge), 4), "########....########");
}

TEST(Masks, OfAnEvaluationLieInOneAnother) {
   DisparityImage left(40, 30, 2), right(40, 30, 2);
   left.at(20, 15) = kNone;
   right.at(22, 15) = 9;
   const GrayImage flat(40, 30, 90);
   const auto masks = evaluation_masks(flat, left, &right, Reference::left, 10);
   ASSERT_EQ(masks.size(), 4u);
   EXPECT_EQ(masks[0].name, "all");
   EXPECT_EQ(drawn(masks[0].mask, 15), "..........##########.#########..........");
   EXPECT_EQ(drawn(masks[0].mask, 9), std::string(40, '.'));
   EXPECT_EQ(drawn(masks[0].mask, 20), std::string(40, '.'));
   EXPECT_EQ(masks[1].name, "non_occluded");
   EXPECT_EQ(drawn(masks[1].mask, 15), "..........##########.###.#####..........");
   EXPECT_EQ(masks[2].name, "discontinuity");
   EXPECT_EQ(drawn(masks[2].mask, 15), std::string(40, '.'));
   EXPECT_EQ(masks[3].name, "textureless");
   EXPECT_EQ(masks[3].mask, masks[1].mask);
   EXPECT_EQ(evaluation_masks(flat, left, nullptr, Reference::left, 10).size(), 1u);
   const auto nothing = evaluation_masks(flat, left, &right, Reference::left, 15);
   EXPECT_EQ(nothing[0].mask, GrayImage(40, 30)) << "a border as high as the image";
}

}  // namespace
}  // namespace stereo::app
