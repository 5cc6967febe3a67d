// SPDX-License-Identifier: Apache-2.0
// Tiny cases computed by hand, and what cannot be matched.
#include "definition/block_matching/reference_model.hpp"

#include <stdexcept>

#include "testing/by_hand.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::block_matching {
namespace {

using namespace test;

// W=4, H=2, D=2: cost columns 0 ... 2, output columns 0 and 1.
const GrayImage kLeft = image(4, 2, {10, 20, 30, 40, 5, 5, 9, 9});
const GrayImage kRight = image(4, 2, {20, 30, 30, 99, 5, 9, 5, 99});

TEST(ReferenceModel, CostsByHand) {
   EXPECT_TRUE(same_volume(volume(3, 2, 2, {10, 0, 10, 0, 0, 10, 0, 0, 4, 0, 4, 4}),
                           pixel_costs(kLeft, kRight, {DisparityCount{2}})));
}

TEST(ReferenceModel, ColumnSumsByHand) {
   const CostVolume costs = pixel_costs(kLeft, kRight, {DisparityCount{2}});
   EXPECT_TRUE(same_volume(volume(3, 2, 2, {10, 0, 14, 0, 4, 14, 10, 0, 14, 0, 4, 14}), column_sums(costs, 3)));
   EXPECT_TRUE(same_volume(costs, column_sums(costs, 1)));
}

TEST(ReferenceModel, WindowSumsByHand) {
   const CostVolume costs = pixel_costs(kLeft, kRight, {DisparityCount{2}});
   EXPECT_TRUE(same_volume(volume(2, 2, 2, {24, 0, 28, 14, 24, 0, 28, 14}), window_sums(costs, 3)));
   EXPECT_TRUE(same_volume(volume(2, 2, 2, {10, 0, 10, 0, 0, 0, 4, 0}), window_sums(costs, 1)));
}

TEST(ReferenceModel, MapByHand) {
   EXPECT_TRUE(
       same_map(map(2, 2, {1, 1, 1, 1}), match_reference(kLeft, kRight, {DisparityCount{2}, MatchingWindow{3}})));
   EXPECT_TRUE(
       same_map(map(2, 2, {1, 1, 0, 1}), match_reference(kLeft, kRight, {DisparityCount{2}, MatchingWindow{1}})))
       << "a tie goes to 0";
}

TEST(ReferenceModel, OneRow) {
   const GrayImage left = image(5, 1, {1, 2, 3, 4, 5}), right = image(5, 1, {3, 4, 5, 0, 0});
   EXPECT_TRUE(same_map(map(2, 1, {2, 2}),
                        match_reference(left, right, {DisparityCount{3}, MatchingWindow{3}})));
}

TEST(ReferenceModel, OneColumnOfOutputAndOneDisparity) {
   EXPECT_TRUE(same_map(DisparityMap(1, 7), match_reference(GrayImage(2, 7, 50), GrayImage(2, 7, 60),
                                                            {DisparityCount{1}, MatchingWindow{3}})));
}

TEST(ReferenceModel, FindsAKnownShift) {
   const ImagePair pair = shifted_pair(60, 9, 11, test_seed());
   EXPECT_TRUE(same_map(DisparityMap(40, 9, 11),
                        match_reference(pair.left, pair.right, {DisparityCount{20}, MatchingWindow{3}})));
}

TEST(ReferenceModel, RejectsWhatCannotBeMatched) {
   EXPECT_THROW(match_reference(GrayImage(9, 9), GrayImage(9, 8), {DisparityCount{4}, MatchingWindow{3}}),
                std::invalid_argument);
   EXPECT_THROW(match_reference(GrayImage(9, 9), GrayImage(9, 9), {DisparityCount{4}, MatchingWindow{0}}),
                std::invalid_argument);
   EXPECT_THROW(pixel_costs(GrayImage(9, 9), GrayImage(9, 9), {DisparityCount{9}, MatchingWindow{3}}),
                std::invalid_argument);
}

}  // namespace
}  // namespace stereo::block_matching
