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

Counts counts(const DisparityMap& map, const block_matching::Matching& parameters, const GrayImage& truth,
              const GrayImage& visible) {
   const TruthScore score = score_against_truth(map, map_geometry(parameters, truth.width), truth, visible);
   return {score.compared, score.bad, score.invalid};
}

std::ostream& operator<<(std::ostream& out, const Counts& c) {
   return out << c.compared << " compared, " << c.bad << " bad, " << c.invalid << " invalid";
}

TEST(Truth, CountsPixelsOffByMoreThanOne) {
   const GrayImage truth(20, 3, 7), visible(20, 3, 255);
   const block_matching::Matching parameters{.disparities = 10};
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
   const GrayImage truth(20, 3, 7);
   GrayImage visible(20, 3, 255);
   visible.at(4, 1) = 0;
   DisparityMap map(10, 3, 0);
   map.valid_at(4, 1) = 0;
   map.valid_at(5, 1) = 0;
   EXPECT_EQ(counts(map, block_matching::Matching{.disparities = 10}, truth, visible), (Counts{28, 28, 1}))
       << "hidden ones are not invalid";
}

TEST(Truth, KnowsSixteenths) {
   const GrayImage truth(20, 1, 7), visible(20, 1, 255);
   const block_matching::Matching parameters{.disparities = 10, .subpixel = true};
   DisparityMap map(10, 1, 7 * 16, true);
   map.at(0, 0) = 8 * 16;
   map.at(1, 0) = 8 * 16 + 1;
   map.at(2, 0) = 6 * 16 - 1;
   EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{10, 2, 0}));
}

TEST(Truth, StandsAtTheMapsFirstColumnAndCountsFromTheSmallestDisparity) {
   for (const auto& [reference, min_disparity] :
        {std::pair{Reference::left, 0}, {Reference::left, 3}, {Reference::right, -3}, {Reference::right, 2}}) {
      const block_matching::Matching parameters{
          .disparities = 10, .min_disparity = min_disparity, .reference = reference};
      GrayImage truth(30, 2), visible(30, 2, 255);
      for (int y = 0; y < 2; ++y)
         for (int x = 0; x < 30; ++x) truth.at(x, y) = uint8_t(2 * x + 20 * y + 10);
      DisparityMap map(map_width(30, parameters), 2);
      for (int y = 0; y < 2; ++y)
         for (int x = 0; x < map.width; ++x)
            map.at(x, y) = uint16_t(truth.at(map_first_column(parameters) + x, y) - min_disparity);
      const int pixels = 2 * map.width;
      EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{pixels, 0, 0})) << min_disparity;
      for (uint8_t& value : truth.pixels) value = uint8_t(value + 2);
      EXPECT_EQ(counts(map, parameters, truth, visible), (Counts{pixels, pixels, 0})) << min_disparity;
   }
}

}  // namespace
}  // namespace stereo::app
