// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/truth.hpp"

#include <gtest/gtest.h>

#include "definition/block_matching/models.hpp"

namespace stereo::app {
namespace {

struct Counts {
   int compared, bad, invalid;
   bool operator==(const Counts&) const = default;
};

Counts counts(const DisparityMap& map, const block_matching::Matching& parameters, const DisparityImage& truth,
              const GrayImage& visible) {
   const TruthScore score = score_against_truth(map, map_geometry(parameters, truth.width), truth, visible);
   return {score.compared, score.bad, score.invalid};
}

std::ostream& operator<<(std::ostream& out, const Counts& c) {
   return out << c.compared << " compared, " << c.bad << " bad, " << c.invalid << " invalid";
}

TEST(Truth, CountsPixelsOffByMoreThanOne) {
   const DisparityImage truth(20, 3, 7);
   const GrayImage visible(20, 3, 255);
   const block_matching::Matching parameters{DisparityCount{10}};
   DisparityMap map(10, 3, 7);
   EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{30, 0, 0}));
   map.at(0, 0) = 8;
   map.at(9, 2) = 6;
   EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{30, 0, 0}));
   map.at(0, 0) = 9;
   map.at(9, 2) = 5;
   EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{30, 2, 0}));
}

TEST(Truth, LeavesOutWhatIsHiddenOrInvalid) {
   const DisparityImage truth(20, 3, 7);
   GrayImage visible(20, 3, 255);
   visible.at(4, 1) = 0;
   DisparityMap map(10, 3, 0);
   map.valid_at(4, 1) = 0;
   map.valid_at(5, 1) = 0;
   EXPECT_EQ(counts(map, block_matching::Matching{DisparityCount{10}}, truth, visible), (Counts{28, 28, 1}))
       << "hidden ones are not invalid";
}

TEST(Truth, KnowsSixteenths) {
   const DisparityImage truth(20, 1, 7);
   const GrayImage visible(20, 1, 255);
   const block_matching::Matching parameters{DisparityCount{10}, SubpixelSteps{true}};
   DisparityMap map(10, 1, 7 * 16, true);
   map.at(0, 0) = 8 * 16;
   map.at(1, 0) = 8 * 16 + 1;
   map.at(2, 0) = 6 * 16 - 1;
   EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{10, 2, 0}));
}

TEST(Truth, StandsAtTheMapsFirstColumnAndCountsFromTheSmallestDisparity) {
   for (const auto& [reference, min_disparity] :
        {std::pair{Reference::left, 0}, {Reference::left, 3}, {Reference::right, -3}, {Reference::right, 2}}) {
      const block_matching::Matching parameters{DisparityCount{10}, SmallestDisparity{min_disparity},
                                                ReferenceImage{reference}};
      DisparityImage truth(30, 2);
      const GrayImage visible(30, 2, 255);
      for (int y = 0; y < 2; ++y)
         for (int x = 0; x < 30; ++x) truth.at(x, y) = float(2 * x + 20 * y + 10);
      DisparityMap map(map_width(30, parameters), 2);
      for (int y = 0; y < 2; ++y)
         for (int x = 0; x < map.width; ++x)
            map.at(x, y) = uint16_t(int(truth.at(map_first_column(parameters) + x, y)) - min_disparity);
      const int pixels = 2 * map.width;
      EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{pixels, 0, 0})) << min_disparity;
      for (float& value : truth.px) value += 2;
      EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{pixels, pixels, 0})) << min_disparity;
   }
}

TEST(Truth, WhatIsNotKnownDoesNotCount) {
   DisparityImage truth(20, 3, 7);
   truth.at(4, 1) = kNoDisparity;
   const DisparityMap map(10, 3, 7);
   EXPECT_EQ(counts(map, block_matching::Matching{DisparityCount{10}}, truth, GrayImage(20, 3, 255)),
             (Counts{29, 0, 0}));
}

TEST(Truth, OutsideOfTheRangeIsRemarkedFromHalfOn) {
   DisparityImage truth(4, 1, 20);
   truth.at(3, 0) = kNoDisparity;
   truth.at(0, 0) = truth.at(1, 0) = 10.5F;
   EXPECT_EQ(range_remark("tiny", truth, {0, 11}), "") << "half a pixel above the last one";
   EXPECT_EQ(range_remark("tiny", truth, {0, 21}), "");
   EXPECT_EQ(
       range_remark("tiny", truth, {0, 10}),
       "tiny searches disparities of 0 ... 9 px, but 100 % of the ground truth, 10.5 ... 20 px, lies outside; check "
       "the scale of the truth");
   EXPECT_NE(range_remark("tiny", truth, {12, 5}), "") << "below";
   EXPECT_EQ(range_remark("tiny", DisparityImage(4, 1), {0, 10}), "") << "nothing is known";
}

TEST(Truth, NearlyAllBadIsRemarked) {
   EXPECT_EQ(bad_remark("tiny", 89, 100), "");
   EXPECT_EQ(bad_remark("tiny", 0, 0), "");
   EXPECT_EQ(bad_remark("tiny", 0, 5), "");
   EXPECT_EQ(bad_remark("tiny", 959, 1000),
             "95 % of the disparities that tiny found are off by more than 1 px; check that the truth and its scale "
             "belong to these images");
}

}  // namespace
}  // namespace stereo::app
