// SPDX-License-Identifier: Apache-2.0
// Each option of the reference model, in cases computed by hand.
#include <cmath>
#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"
#include "definition/block_matching/reference_model.hpp"
#include "definition/mirror.hpp"
#include "scene/random.hpp"
#include "testing/by_hand.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::block_matching {
namespace {

using namespace test;

const GrayImage kLeft = image(4, 1, {10, 20, 30, 40});
const GrayImage kRight = image(4, 1, {20, 30, 30, 99});

TEST(ReferenceOptions, PrefilterByHand) {
   const GrayImage steps = image(4, 3, {0, 10, 20, 0, 0, 0, 0, 0, 5, 5, 5, 5});
   EXPECT_TRUE(same_map(image(4, 3, {31, 62, 11, 31, 31, 51, 21, 31, 31, 31, 31, 31}), prefiltered(steps, 31)));
   EXPECT_TRUE(same_map(image(4, 3, {5, 10, 0, 5, 5, 10, 0, 5, 5, 5, 5, 5}), prefiltered(steps, 5)));
}

TEST(ReferenceOptions, PrefilterMirrorsAtTheUpperAndLowerBorder) {
   EXPECT_TRUE(
       same_map(image(4, 2, {31, 45, 25, 31, 31, 45, 25, 31}), prefiltered(image(4, 2, {0, 0, 0, 0, 0, 3, 7, 0}), 31)));
   EXPECT_TRUE(same_map(image(3, 1, {63, 99, 63}), prefiltered(image(3, 1, {0, 5, 9}), 63)));
   EXPECT_TRUE(same_map(image(2, 2, {9, 9, 9, 9}), prefiltered(image(2, 2, {0, 255, 255, 0}), 9)));
}

TEST(ReferenceOptions, CensusByHand) {
   const CensusImage census = census_transform(image(3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}), 3, 3);
   EXPECT_EQ(census.at(1, 1), 0xf0u);
   EXPECT_EQ(census.at(0, 0), 0xd0u) << "pixels outside count as 0";
   EXPECT_EQ(census.at(2, 2), 0u);
   GrayImage last(5, 3, 7);
   last.at(4, 2) = 8;
   EXPECT_EQ(census_transform(last, 5, 3).at(2, 1), uint64_t(1) << 13);
   EXPECT_EQ(census_transform(GrayImage(9, 7, 7), 9, 7).at(4, 3), 0u) << "equal pixels are not larger";
   GrayImage hole(9, 7, 7);
   hole.at(4, 3) = 6;
   EXPECT_EQ(census_transform(hole, 9, 7).at(4, 3), (uint64_t(1) << 62) - 1);
}

TEST(ReferenceOptions, CensusPatternsByHand) {
   const GrayImage around = image(3, 3, {9, 9, 9, 9, 5, 9, 9, 9, 9});
   const auto bits = [&around](CensusPattern pattern) { return census_transform(around, 3, 3, pattern).at(1, 1); };
   EXPECT_EQ(bits(CensusPattern::all), 0xffu);
   EXPECT_EQ(bits(CensusPattern::even_columns), 3u) << "above and below";
   EXPECT_EQ(bits(CensusPattern::checkerboard), 0xfu) << "the corners";
   EXPECT_EQ(bits(CensusPattern::sparse), 0u) << "no other pixel is left";
   GrayImage hole(9, 7, 7);
   hole.at(4, 3) = 6;
   const auto count = [&hole](int width, int height, CensusPattern pattern) {
      const int ones = std::popcount(census_transform(hole, width, height, pattern).at(4, 3));
      EXPECT_EQ(ones, census_bits(width, height, pattern));
      return ones;
   };
   EXPECT_EQ(count(9, 7, CensusPattern::even_columns), 34);
   EXPECT_EQ(count(9, 7, CensusPattern::checkerboard), 30);
   EXPECT_EQ(count(9, 7, CensusPattern::sparse), 14);
   EXPECT_EQ(count(9, 5, CensusPattern::sparse), 14);
   EXPECT_EQ(count(7, 5, CensusPattern::checkerboard), 16);
   // A pixel that the pattern leaves out changes nothing.
   GrayImage left_out = hole;
   left_out.at(3, 3) = 0;
   EXPECT_EQ(census_transform(left_out, 9, 7, CensusPattern::even_columns).at(4, 3),
             census_transform(hole, 9, 7, CensusPattern::even_columns).at(4, 3));
}

TEST(ReferenceOptions, SquaredDifferencesByHand) {
   EXPECT_TRUE(same_volume(volume(3, 1, 2, {100, 0, 100, 0, 0, 100}),
                           pixel_costs(kLeft, kRight, {DisparityCount{2}, Comparison{Cost::ssd}})));
}

TEST(ReferenceOptions, CensusCostsByHand) {
   // Bits 3 and 4: the pixels to the left and to the right are larger.
   const GrayImage left = image(3, 1, {0, 5, 0}), right = image(3, 1, {5, 0, 5});
   const block_matching::Matching parameters{DisparityCount{1}, Comparison{Cost::census},
                                             CensusWindow{.census_width_px = 3, .census_height_px = 3}};
   EXPECT_TRUE(same_volume(volume(3, 1, 1, {1, 2, 1}), pixel_costs(left, right, parameters)));
}

TEST(ReferenceOptions, PrefilteredCostsByHand) {
   // Filtered: 31 39 51 31 and 31 62 31 31, of the slopes 2, 5 and 20, 0, four times each.
   const GrayImage left = image(4, 1, {0, 1, 2, 6}), right = image(4, 1, {0, 0, 20, 0});
   const block_matching::Matching parameters{DisparityCount{1}, Prefiltering{.prefilter = Prefilter::xsobel}};
   EXPECT_TRUE(same_volume(volume(4, 1, 1, {0, 62 - 39, 51 - 31, 0}), pixel_costs(left, right, parameters)));
}

TEST(ReferenceOptions, SmallestDisparityByHand) {
   const auto costs = [](int min_disparity) {
      return pixel_costs(kLeft, kRight, {DisparityCount{2}, SmallestDisparity{min_disparity}});
   };
   EXPECT_TRUE(same_volume(volume(2, 1, 2, {0, 10, 0, 10}), costs(1)));
   EXPECT_TRUE(same_volume(volume(3, 1, 2, {20, 10, 10, 0, 69, 59}), costs(-1)));
   EXPECT_TRUE(same_volume(volume(2, 1, 2, {20, 10, 79, 69}), costs(-2)));
}

TEST(ReferenceOptions, EvenWindowsReachFurtherUpAndToTheLeft) {
   const CostVolume column = volume(1, 3, 1, {1, 10, 100}), row = volume(3, 1, 1, {1, 10, 100});
   EXPECT_TRUE(same_volume(volume(1, 3, 1, {1, 11, 110}), column_sums(column, 2)));
   EXPECT_TRUE(same_volume(volume(1, 3, 1, {11, 111, 111}), column_sums(column, 4)));
   EXPECT_TRUE(same_volume(volume(2, 1, 1, {1, 11}), window_sums(row, 2)));
   EXPECT_TRUE(same_volume(volume(2, 1, 1, {11, 111}), window_sums(row, 4)));
}

TEST(ReferenceOptions, TiesByHand) {
   EXPECT_TRUE(same_map(map(1, 1, {1}), winners(volume(1, 1, 4, {7, 5, 5, 6}), Ties::smallest)));
   EXPECT_TRUE(same_map(map(1, 1, {2}), winners(volume(1, 1, 4, {7, 5, 5, 6}), Ties::largest)));
}

TEST(ReferenceOptions, LeftRightCheckByHand) {
   const CostVolume sums = volume(2, 1, 2, {5, 3, 4, 9});
   const DisparityMap best = winners(sums), other = other_winners(sums);
   EXPECT_TRUE(same_map(map(2, 1, {1, 0}), best));
   EXPECT_TRUE(same_map(map(3, 1, {0, 1, 1}), other)) << "at the ends there is one disparity only";
   EXPECT_TRUE(same_map(image(2, 1, {1, 0}), left_right_check(best, other, 0)));
   EXPECT_TRUE(same_map(image(2, 1, {1, 1}), left_right_check(best, other, 1)));
   const CostVolume ties = volume(2, 1, 2, {5, 4, 4, 9});
   EXPECT_TRUE(same_map(map(3, 1, {0, 0, 1}), other_winners(ties, Ties::smallest)));
   EXPECT_TRUE(same_map(map(3, 1, {0, 1, 1}), other_winners(ties, Ties::largest)));
}

TEST(ReferenceOptions, UniquenessByHand) {
   const auto passes = [](std::vector<int> sums, int percent) {
      const CostVolume one = volume(1, 1, 4, std::move(sums));
      return int(uniqueness_check(one, winners(one), percent).at(0, 0));
   };
   EXPECT_EQ(passes({100, 101, 115, 200}, 14), 1) << "the neighbour does not count";
   EXPECT_EQ(passes({100, 101, 115, 200}, 15), 0);
   EXPECT_EQ(passes({200, 115, 101, 100}, 15), 0) << "on the other side";
   EXPECT_EQ(passes({99, 300, 100, 300}, 1), 1) << "99 / 100 is rounded down";
   EXPECT_EQ(passes({0, 5, 0, 5}, 1), 0);
   EXPECT_EQ(passes({0, 5, 1, 5}, 100), 1);
}

TEST(ReferenceOptions, TextureByHand) {
   const auto passes = [](std::vector<uint8_t> filtered, int window, int threshold) {
      const block_matching::Matching parameters{DisparityCount{2}, MatchingWindow{window},
                                                Prefiltering{.prefilter = Prefilter::xsobel},
                                                TextureThreshold{threshold}};
      return texture_check(image(4, 1, std::move(filtered)), parameters);
   };
   EXPECT_TRUE(same_map(image(2, 1, {1, 1}), passes({31, 41, 21, 31}, 3, 10)));
   EXPECT_TRUE(same_map(image(2, 1, {0, 1}), passes({31, 41, 21, 31}, 3, 11)));
   EXPECT_TRUE(same_map(image(2, 1, {0, 0}), passes({31, 41, 21, 31}, 3, 21)));
   EXPECT_TRUE(same_map(image(2, 1, {0, 0}), passes({31, 41, 21, 0}, 5, 21))) << "column 3 is no cost column";
   EXPECT_TRUE(same_map(image(2, 1, {0, 1}), passes({31, 41, 21, 31}, 2, 10))) << "an even window";
}

TEST(ReferenceOptions, SubpixelByHand) {
   const auto sixteenths = [](std::vector<int> sums, uint16_t winner) {
      const DisparityMap result = subpixel_disparities(volume(1, 1, 3, std::move(sums)), map(1, 1, {winner}));
      EXPECT_TRUE(result.subpixel);
      return int(result.at(0, 0));
   };
   EXPECT_EQ(sixteenths({6, 2, 4}, 1), 20);  // (256 + 64 + 15) / 16
   EXPECT_EQ(sixteenths({4, 2, 6}, 1), 12);  // (256 - 64 + 15) / 16
   EXPECT_EQ(sixteenths({3, 0, 1}, 1), 22);  // (256 + 85 + 15) / 16
   EXPECT_EQ(sixteenths({1, 0, 3}, 1), 11);  // (256 - 85 + 15) / 16
   EXPECT_EQ(sixteenths({2, 2, 5}, 1), 8);
   EXPECT_EQ(sixteenths({5, 2, 2}, 1), 24);
   EXPECT_EQ(sixteenths({2, 2, 2}, 1), 16);
   EXPECT_EQ(sixteenths({1, 2, 9}, 0), 0) << "at an end";
   EXPECT_EQ(sixteenths({9, 2, 1}, 2), 32) << "at the other end";
}

TEST(ReferenceOptions, MedianByHand) {
   DisparityMap disparities = map(3, 3, {9, 1, 2, 3, 4, 5, 6, 7, 8});
   disparities.valid_at(1, 1) = 0;
   const DisparityMap filtered = median_filtered(disparities);
   EXPECT_EQ(filtered.at(1, 1), 5);
   EXPECT_EQ(filtered.at(0, 0), 4) << "the border repeats";
   EXPECT_EQ(filtered.at(2, 2), 7);
   EXPECT_EQ(filtered.valid, disparities.valid);
   EXPECT_TRUE(same_map(map(1, 1, {3}), median_filtered(map(1, 1, {3}))));
}

TEST(ReferenceOptions, LeftReferenceByHand) {
   const GrayImage right = image(4, 1, {20, 30, 0, 40});
   const block_matching::Matching parameters{DisparityCount{2}, MatchingWindow{1}, ReferenceImage{Reference::left}};
   EXPECT_EQ(map_first_column(parameters), 2);
   EXPECT_TRUE(same_map(map(2, 1, {1, 0}), match_reference(kLeft, right, parameters)));
}

/// The winner at (x, y) of the left image, written for the left image from the start.
int left_winner(const ImagePair& pair, const block_matching::Matching& p, int x, int y) {
   const auto is_cost_column = [&](int column) {
      const int nearest = column - p.min_disparity, farthest = nearest - p.disparities + 1;
      return column >= 0 && column < pair.left.width && farthest >= 0 && nearest < pair.left.width;
   };
   int best = 0, best_sum = -1;
   for (int d = 0; d < p.disparities; ++d) {
      int sum = 0;
      for (int row = y - p.window_px / 2; row <= y + (p.window_px - 1) / 2; ++row)
         for (int column = x - (p.window_px - 1) / 2; column <= x + p.window_px / 2; ++column)
            if (row >= 0 && row < pair.left.height && is_cost_column(column))
               sum += std::abs(pair.left.at(column, row) - pair.right.at(column - p.min_disparity - d, row));
      if (best_sum < 0 || sum < best_sum) {
         best = d;
         best_sum = sum;
      }
   }
   return best;
}

TEST(ReferenceOptions, LeftReferenceIsTheMirrorImageAlsoForEvenWindows) {
   for (const int window : {1, 2, 3, 4, 5})
      for (const int min_disparity : {-9, -2, 0, 3}) {
         const block_matching::Matching parameters{DisparityCount{6}, MatchingWindow{window},
                                                   SmallestDisparity{min_disparity}, ReferenceImage{Reference::left}};
         const ImagePair pair = random_pair(24, 7, test_seed() + uint64_t(window), 6);
         const DisparityMap got = match_reference(pair.left, pair.right, parameters);
         DisparityMap expected(map_width(24, parameters), 7);
         for (int y = 0; y < 7; ++y)
            for (int x = 0; x < expected.width; ++x)
               expected.at(x, y) = uint16_t(left_winner(pair, parameters, map_first_column(parameters) + x, y));
         EXPECT_TRUE(same_map(expected, got)) << "B=" << window << " m=" << min_disparity;
      }
}

TEST(ReferenceOptions, ChecksOnlyTakeValidity) {
   const ImagePair pair = random_pair(40, 12, test_seed(), 8);
   block_matching::Matching parameters{DisparityCount{8}, MatchingWindow{5},
                                       Prefiltering{.prefilter = Prefilter::xsobel}};
   const DisparityMap without = match_reference(pair.left, pair.right, parameters);
   parameters.left_right_threshold = 1;
   parameters.uniqueness_percent = 5;
   parameters.texture_threshold = 500;
   const DisparityMap with = match_reference(pair.left, pair.right, parameters);
   EXPECT_EQ(with.disparity, without.disparity);
   EXPECT_EQ(without.valid, std::vector<uint8_t>(without.valid.size(), 1));
   EXPECT_NE(with.valid, without.valid);
   EXPECT_NE(with.valid, std::vector<uint8_t>(with.valid.size(), 0));
}

TEST(ReferenceOptions, FindsAKnownShiftWithEveryCostAndReference) {
   for (const Cost cost : {Cost::sad, Cost::ssd, Cost::census})
      for (const Reference reference : {Reference::right, Reference::left})
         for (const int min_disparity : {0, 5, -4}) {
            const block_matching::Matching parameters{
                DisparityCount{12},        MatchingWindow{3}, SmallestDisparity{min_disparity},
                ReferenceImage{reference}, Comparison{cost},  LeftRightThreshold{0}};
            const ImagePair pair = shifted_pair(60, 9, 7, test_seed());
            const DisparityMap got = match_reference(pair.left, pair.right, parameters);
            // Census windows and costs that reach beyond the shifted part may be wrong: look inside.
            int wrong = 0, looked_at = 0;
            for (int x = 5; x < got.width - 12; ++x, ++looked_at)
               wrong += got.at(x, 4) != 7 - min_disparity || !got.valid_at(x, 4) ? 1 : 0;
            EXPECT_GT(looked_at, 10);
            EXPECT_EQ(wrong, 0) << int(cost) << ' ' << int(reference) << ' ' << min_disparity;
         }
}

TEST(ReferenceOptions, FullWidthByHand) {
   // Windows of 2x2: of column x, the columns x-1 and x of the only row. Columns 1 ... 3 of the map.
   const GrayImage left = image(4, 1, {10, 20, 30, 40}), right = image(4, 1, {20, 30, 30, 99});
   const Matching matching{DisparityCount{2}, MatchingWindow{2}, FullWidth{.full_width = true}};
   const CostVolume sums = full_width_sums(all_window_sums(pixel_costs(left, right, matching), 2), 2, {0, 0, 1});
   EXPECT_TRUE(same_volume(volume(3, 1, 2, {20, 0, 10, 10, 59, kNoCandidate}), sums));
   EXPECT_TRUE(same_map(map(3, 1, {1, 0, 0}), match_reference(left, right, matching)));
   Matching later = matching;
   later.min_disparity = 1;  // the last column has no candidate
   DisparityMap expected = map(3, 1, {0, 0, 0});
   expected.valid_at(2, 0) = 0;
   EXPECT_TRUE(same_map(expected, match_reference(left, right, later)));
   later.ties = Ties::largest;
   expected.at(2, 0) = 1;
   EXPECT_TRUE(same_map(expected, match_reference(left, right, later)));
   EXPECT_TRUE(later.has_check());
   EXPECT_FALSE(matching.has_check());
}

TEST(ReferenceOptions, APartOfTheRangeIsARangeOfItsOwn) {
   Random random(test_seed());
   int invalid = 0;
   for (int i = 0; i < 60; ++i) {
      Matching whole{DisparityCount{2 + random.below(9)}, MatchingWindow{2 + random.below(4)},
                     FullWidth{.full_width = true}};
      whole.min_disparity = random.below(13) - 8;
      whole.reference = random.percent(50) ? Reference::left : Reference::right;
      whole.ties = random.percent(50) ? Ties::largest : Ties::smallest;
      whole.subpixel = random.percent(50);
      if (random.percent(50)) whole.left_right_threshold = random.below(2);
      if (random.percent(50)) whole.uniqueness_percent = random.below(60);
      whole.first_disparity = random.below(whole.disparities);
      whole.last_disparity = whole.first_disparity + random.below(whole.disparities - whole.first_disparity);
      Matching part = whole;
      part.disparities = whole.last_disparity - whole.first_disparity + 1;
      part.min_disparity += whole.first_disparity;
      part.first_disparity = 0;
      part.last_disparity = -1;
      part.left_right_threshold = std::min(whole.left_right_threshold, part.disparities - 1);
      const int levels = 2 + random.below(20);
      const ImagePair pair = random_pair(24, 6, random.bits(), levels);
      const DisparityMap of_whole = match_reference(pair.left, pair.right, whole);
      const DisparityMap of_part = match_reference(pair.left, pair.right, part);
      const int step = whole.subpixel ? 16 : 1;
      for (int y = 0; y < of_whole.height; ++y)
         for (int x = 0; x < of_whole.width; ++x) {
            ASSERT_EQ(of_whole.valid_at(x, y), of_part.valid_at(x, y)) << "x=" << x << " y=" << y;
            if (!of_whole.valid_at(x, y)) ++invalid;
            else
               ASSERT_EQ(of_whole.at(x, y), of_part.at(x, y) + step * whole.first_disparity) << "x=" << x << " y=" << y;
         }
   }
   EXPECT_GT(invalid, 0);
}

TEST(ReferenceOptions, FullWidthIsTheSameWhereAllDisparitiesFit) {
   Random random(test_seed());
   for (int i = 0; i < 40; ++i) {
      Matching matching{DisparityCount{2 + random.below(6)}, MatchingWindow{2 + random.below(4)}};
      matching.min_disparity = random.below(9) - 4;
      matching.reference = random.percent(50) ? Reference::left : Reference::right;
      matching.subpixel = random.percent(50);
      const int levels = 2 + random.below(20);
      const ImagePair pair = random_pair(24, 7, random.bits(), levels);
      const DisparityMap inner = match_reference(pair.left, pair.right, matching);
      const int inner_first = map_first_column(matching);
      matching.full_width = true;
      const DisparityMap full = match_reference(pair.left, pair.right, matching);
      const int first = map_first_column(matching);
      ASSERT_EQ(full.width, 24 - matching.window_px + 1);
      for (int y = 0; y < full.height; ++y)
         for (int x = matching.window_px; x < inner.width - matching.window_px; ++x)
            ASSERT_EQ(full.at(inner_first + x - first, y), inner.at(x, y)) << "x=" << x << " y=" << y;
   }
}

}  // namespace
}  // namespace stereo::block_matching
