// SPDX-License-Identifier: Apache-2.0
#include "scene/stress_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "testing/seed.hpp"

namespace stereo::test {
namespace {

constexpr StressShape kShape{.width = 40, .height = 12, .first_disparity = 0, .disparities = 8};
constexpr int kPairs = 60;  // of a class: what one of them may lack, they have together

std::vector<DeepPair> pairs(StressClass kind, const StressShape& shape) {
   Random random(test_seed());
   std::vector<DeepPair> made;
   for (int i = 0; i < kPairs; ++i) made.push_back(stress_pair(kind, shape, random));
   return made;
}

/// Whether six pixels side by side match at a disparity and at no other one of the range.
bool matches_only_at(const DeepPair& pair, const StressShape& shape, int disparity, int x, int y) {
   const auto is_match = [&](int d) {
      for (int i = x; i < x + 6; ++i)
         if (i + d < 0 || i + d >= shape.width || pair.left.at(i + d, y) != pair.right.at(i, y)) return false;
      return true;
   };
   for (int d = shape.first_disparity; d < shape.first_disparity + shape.disparities; ++d)
      if (is_match(d) != (d == disparity)) return false;
   return true;
}

/// The disparities that are the only match somewhere.
std::set<int> only_matches(const std::vector<DeepPair>& made, const StressShape& shape) {
   std::set<int> found;
   for (const DeepPair& pair : made)
      for (int y = 0; y < shape.height; ++y)
         for (int x = 0; x + 6 <= shape.width; ++x)
            for (int d = shape.first_disparity; d < shape.first_disparity + shape.disparities; ++d)
               if (matches_only_at(pair, shape, d, x, y)) found.insert(d);
   return found;
}

TEST(StressPairs, AllClassesOfAllShapesStayInTheirRange) {
   for (const StressShape& shape :
        {kShape, StressShape{1, 1, 0, 1}, StressShape{2, 1, 0, 2, 10}, StressShape{1, 9, -3, 5, 12},
         StressShape{311, 3, 40, 256}, StressShape{33, 7, -8, 8, 12}}) {
      Random random(test_seed());
      for (const StressClass kind : kAllStressClasses) {
         const DeepPair pair = stress_pair(kind, shape, random);
         for (const DeepImage* image : {&pair.left, &pair.right}) {
            ASSERT_EQ(image->width, shape.width);
            ASSERT_EQ(image->height, shape.height);
            EXPECT_LT(*std::ranges::max_element(image->pixels), 1 << shape.pixel_bits);
         }
      }
   }
}

TEST(StressPairs, StepsMatchAtEachDisparityOfTheRange) {
   for (const int first : {0, -3, 5}) {
      StressShape shape = kShape;
      shape.first_disparity = first;
      for (const StressClass kind : {StressClass::steps, StressClass::stairs, StressClass::tiles}) {
         const std::set<int> found = only_matches(pairs(kind, shape), shape);
         EXPECT_EQ(int(found.size()), shape.disparities) << "class " << int(kind) << ", from " << first;
      }
      const std::set<int> ends = only_matches(pairs(StressClass::edges, shape), shape);
      EXPECT_TRUE(ends.contains(first) && ends.contains(first + shape.disparities - 1));
   }
}

TEST(StressPairs, BlocksHaveWholeWindowsOfTheLargestDifference) {
   int most = 0;
   for (const DeepPair& pair : pairs(StressClass::blocks, kShape))
      for (int y = 0; y + 3 <= kShape.height; ++y)
         for (int x = 0; x + 3 <= kShape.width; ++x) {
            int sum = 0;
            for (int i = 0; i < 9; ++i)
               sum += std::abs(pair.left.at(x + i % 3, y + i / 3) - pair.right.at(x + i % 3, y + i / 3));
            most = std::max(most, sum);
         }
   EXPECT_EQ(most, 9 * 255);
}

TEST(StressPairs, OpposedImagesDifferAllOverByLargeDifferences) {
   int largest = 0;
   for (const DeepPair& pair : pairs(StressClass::opposed, kShape)) {
      int large = 0;
      for (std::size_t i = 0; i < pair.left.pixels.size(); ++i) {
         large += std::abs(pair.left.pixels[i] - pair.right.pixels[i]) >= 255 * 3 / 4;
         largest += std::abs(pair.left.pixels[i] - pair.right.pixels[i]) == 255;
      }
      EXPECT_GE(large, 40 * 12 - 1);
   }
   EXPECT_GT(largest, kPairs / 4 * 40 * 12) << "a part of them without noise";
}

TEST(StressPairs, OneImageRisesWhereTheOtherFalls) {
   for (const DeepPair& pair : pairs(StressClass::slopes, kShape))
      for (int y = 0; y < kShape.height; ++y)
         for (int x = 1; x < kShape.width; ++x) {
            const int left = pair.left.at(x, y) - pair.left.at(x - 1, y);
            const int right = pair.right.at(x, y) - pair.right.at(x - 1, y);
            ASSERT_EQ(left, -right);
            ASSERT_NE(left, 0);
         }
}

TEST(StressPairs, RoughSlopesHaveLargeCostsThatDiffer) {
   // Of a census of neighbours: where the left image rises, the right one falls, but for a part of the pixels.
   int opposite = 0, all = 0, ragged = 0;
   for (const DeepPair& pair : pairs(StressClass::rough, kShape)) {
      int of_pair = 0, count = 0;
      for (int y = 0; y < kShape.height; ++y)
         for (int x = 1; x < kShape.width; ++x, ++count)
            of_pair += (pair.left.at(x, y) > pair.left.at(x - 1, y)) != (pair.right.at(x, y) > pair.right.at(x - 1, y));
      opposite += of_pair;
      all += count;
      ragged += of_pair < count * 9 / 10;
   }
   EXPECT_GT(double(opposite) / all, 0.6) << "0.5 of noise";
   EXPECT_LT(double(opposite) / all, 0.95) << "1 of slopes without noise";
   EXPECT_GT(ragged, kPairs / 4);
}

TEST(StressPairs, TilesDifferMuchBesideTheirDisparity) {
   double beside = 0;
   int all = 0;
   for (const DeepPair& pair : pairs(StressClass::tiles, kShape))
      for (int y = 0; y < kShape.height; ++y)
         for (int x = 1; x < kShape.width; ++x, ++all)
            beside += std::abs(int(pair.right.at(x, y)) - int(pair.right.at(x - 1, y)));
   EXPECT_GT(beside / all, 100) << "85 of noise";
}

TEST(StressPairs, BandsDifferByAllTwoColumnsBesideTheirDisparity) {
   for (const DeepPair& pair : pairs(StressClass::bands, kShape)) {
      std::set<int> matches, opposites;
      for (int d = kShape.first_disparity; d < kShape.first_disparity + kShape.disparities; ++d) {
         int sum = 0, all = 0;
         for (int y = 0; y < kShape.height; ++y)
            for (int x = std::max(0, -d); x < std::min(kShape.width, kShape.width - d); ++x, all += 255)
               sum += std::abs(int(pair.left.at(x + d, y)) - int(pair.right.at(x, y)));
         if (sum == 0) matches.insert(d);
         if (sum > all * 4 / 5) opposites.insert(d);
      }
      ASSERT_FALSE(matches.empty());
      EXPECT_TRUE(opposites.contains(*matches.begin() + 2) || opposites.contains(*matches.begin() - 2));
   }
}

TEST(StressPairs, EnlargedPairsAreOfBlocksOfAboutOneLevel) {
   int most = 0;
   for (const DeepPair& pair : pairs(StressClass::enlarged, kShape)) {
      for (const DeepImage* image : {&pair.left, &pair.right})
         for (int y = 0; y < kShape.height; ++y)
            for (int x = 0; x < kShape.width; ++x)
               EXPECT_LE(std::abs(image->at(x, y) - image->at(x / 4 * 4, y / 4 * 4)), 255 / 16);
      for (int x = 4; x < kShape.width; x += 4)
         most = std::max(most, std::abs(pair.left.at(x, 0) - pair.left.at(x - 4, 0)));
   }
   EXPECT_GT(most, 200) << "from block to block";
}

TEST(StressPairs, FewLevelsAndPeriodsTie) {
   for (const StressClass kind : {StressClass::few_levels, StressClass::periodic, StressClass::constant}) {
      int ties = 0;
      for (const DeepPair& pair : pairs(kind, kShape))
         for (int y = 0; y < kShape.height; ++y)
            for (int x = 0; x + 8 + 7 < kShape.width; ++x) {
               int matches = 0;
               for (int d = 0; d < 8; ++d)
                  matches += pair.left.at(x + d, y) == pair.right.at(x, y) &&
                             pair.left.at(x + d + 1, y) == pair.right.at(x + 1, y);
               ties += matches > 1;
            }
      EXPECT_GT(ties, 500) << "class " << int(kind);
   }
}

TEST(StressPairs, ASeedIsASetOfPairs) {
   for (const StressClass kind : kAllStressClasses) {
      Random one(5), again(5), other(6);
      const DeepPair first = stress_pair(kind, kShape, one), second = stress_pair(kind, kShape, again);
      EXPECT_EQ(first.left, second.left);
      EXPECT_EQ(first.right, second.right);
      bool differs = false;
      for (int i = 0; i < 5; ++i) differs |= stress_pair(kind, kShape, other).left != first.left;
      EXPECT_TRUE(differs) << "class " << int(kind);
   }
}

}  // namespace
}  // namespace stereo::test
