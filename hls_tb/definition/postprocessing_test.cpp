// SPDX-License-Identifier: Apache-2.0
// Cases computed by hand, with the right image as reference: background is on the right of what is near.
#include "definition/postprocessing.hpp"

#include <gtest/gtest.h>

#include "definition/mirror.hpp"
#include "testing/by_hand.hpp"
#include "testing/map_compare.hpp"

namespace stereo::test {
namespace {

DisparityMap row(std::vector<uint16_t> disparities, std::vector<uint8_t> valid) {
   DisparityMap result = map(int(disparities.size()), 1, disparities);
   result.valid = std::move(valid);
   return result;
}

TEST(PostProcessing, NeighboursAreThoseOfEverySecondColumnAndAlike) {
   DisparityMap flat(15, 7, 5);
   EXPECT_EQ(neighbours(flat).at(7, 3), 35);
   EXPECT_EQ(neighbours(flat).at(0, 0), 4 * 3);
   EXPECT_EQ(neighbours(flat).at(6, 1), 4 * 7);
   flat.at(7, 4) = 7;   // off by two
   flat.at(9, 3) = 6;   // off by one
   flat.at(8, 3) = 90;  // between the columns
   flat.valid_at(5, 1) = 0;
   EXPECT_EQ(neighbours(flat).at(7, 3), 33);
   EXPECT_EQ(neighbours(flat).at(5, 1), 0);
   EXPECT_EQ(neighbours(flat).at(7, 4), 1 + 1) << "itself, and the 6 at (9,3)";
}

TEST(PostProcessing, SixteenthsAreRounded) {
   DisparityMap pair(3, 1, 0, true);
   pair.disparity = {23, 0, 40};  // 1 and 3 whole pixels
   EXPECT_EQ(neighbours(pair).at(0, 0), 1);
   pair.disparity = {24, 0, 39};  // 2 and 2
   EXPECT_EQ(neighbours(pair).at(0, 0), 2);
}

TEST(PostProcessing, ConfidenceIsBoundedAndZeroWhereNotValid) {
   const DisparityMap flat(3, 1, 5);
   const PostProcessing options{.support_threshold = 2, .confidence = true, .margin_weight = 4, .support_weight = 3};
   const DisparityMap result = supported(flat, image(3, 1, {1, 9, 63}), options);
   EXPECT_EQ(result.valid, (std::vector<uint8_t>{1, 0, 1}));
   EXPECT_EQ(result.confidence, (std::vector<uint8_t>{4 + 6, 0, 255}));
}

TEST(PostProcessing, MarginsLeaveOutTheWinnerAndItsNeighbours) {
   const CostVolume sums = volume(1, 1, 5, {40, 21, 20, 22, 29});
   EXPECT_EQ(margins(sums, winners(sums), 0).at(0, 0), 9);
   EXPECT_EQ(margins(sums, winners(sums), 1).at(0, 0), 4);
   const CostVolume few = volume(1, 1, 5, {kNoCandidate, 21, 20, 22, kNoCandidate});
   EXPECT_EQ(margins(few, winners(few), 3).at(0, 0), 63) << "there is none";
}

/// 6 pixels between 9 and 5: the step hides 4, of the other 2 the near side gets one.
TEST(PostProcessing, BehindAStepIsTheBackground) {
   const DisparityMap filled = holes_filled(row({9, 0, 0, 0, 0, 0, 0, 5}, {1, 0, 0, 0, 0, 0, 0, 1}));
   EXPECT_EQ(filled.disparity, (std::vector<uint16_t>{9, 9, 5, 5, 5, 5, 5, 5}));
   EXPECT_EQ(filled.valid, (std::vector<uint8_t>{1, 0, 0, 0, 0, 0, 0, 1}));
   EXPECT_EQ(filled.filled, (std::vector<uint8_t>{0, 1, 1, 1, 1, 1, 1, 0}));
   const DisparityMap rising = holes_filled(row({5, 0, 0, 0, 9}, {1, 0, 0, 0, 1}));
   EXPECT_EQ(rising.disparity, (std::vector<uint16_t>{5, 5, 9, 9, 9})) << "halved: nothing is hidden there";
   const DisparityMap of_left = mirrored(holes_filled(mirrored(row({5, 0, 0, 0, 9}, {1, 0, 0, 0, 1}))));
   EXPECT_EQ(of_left.disparity, (std::vector<uint16_t>{5, 5, 5, 5, 9})) << "with the left image as reference";
}

TEST(PostProcessing, HolesAtTheEndsHaveOneSide) {
   const DisparityMap filled = holes_filled(row({1, 2, 7, 3, 4}, {0, 0, 1, 0, 0}));
   EXPECT_EQ(filled.disparity, (std::vector<uint16_t>{7, 7, 7, 7, 7}));
}

TEST(PostProcessing, RowsWithoutAnyValidPixelShowTheRowAbove) {
   DisparityMap rows = map(2, 4, {1, 2, 3, 4, 5, 6, 7, 8});
   rows.valid = {0, 0, 0, 1, 0, 0, 0, 0};
   const DisparityMap filled = holes_filled(rows);
   EXPECT_EQ(filled.disparity, (std::vector<uint16_t>{1, 2, 4, 4, 4, 4, 4, 4}));
   EXPECT_EQ(filled.filled, (std::vector<uint8_t>{0, 0, 1, 0, 1, 1, 1, 1})) << "in row 0 there is nothing to show";
}

}  // namespace
}  // namespace stereo::test
