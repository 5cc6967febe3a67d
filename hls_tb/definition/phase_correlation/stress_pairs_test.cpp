// SPDX-License-Identifier: Apache-2.0
#include "definition/phase_correlation/stress_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "definition/phase_correlation/reference_model.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using namespace phase_correlation;
using Responses = std::array<int, 6>;

/// The largest that each filter of a scale can give.
Responses largest(int scale, int top) {
   const int side = reach_before(scale) + 1 + reach_after(scale);
   DeepImage impulse(side, side);
   Responses sums{};
   for (uint16_t& pixel : impulse.pixels) {
      pixel = 1;
      const Responses weights = responses(impulse, reach_before(scale), reach_before(scale), scale);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += std::max(weights[i], 0) * top;
      pixel = 0;
   }
   return sums;
}

TEST(PhaseStressPairs, EachFilterIsAtBothItsEndsInBothImages) {
   for (const auto& [scales, bits, width, height] :
        {std::array{2, 8, 40, 18}, std::array{3, 8, 40, 26}, std::array{1, 10, 23, 9}}) {
      Matching matching{DisparityCount{6}};
      matching.phase_scales = scales;
      matching.pixel_bits = bits;
      Random random(test_seed());
      const std::vector<DeepPair> pairs = own_stress_pairs(matching, width, height, random);
      for (int scale = 0; scale < scales; ++scale) {
         const Responses most = largest(scale, (1 << bits) - 1);
         for (const auto image : {&DeepPair::left, &DeepPair::right}) {
            Responses high{}, low{};
            for (const DeepPair& pair : pairs)
               for (int y = reach_before(scale); y + reach_after(scale) < height; ++y)
                  for (int x = reach_before(scale); x + reach_after(scale) < width; ++x) {
                     const Responses here = responses(pair.*image, x, y, scale);
                     for (std::size_t i = 0; i < here.size(); ++i) {
                        high[i] = std::max(high[i], here[i]);
                        low[i] = std::min(low[i], here[i]);
                     }
                  }
            for (std::size_t i = 0; i < high.size(); ++i) {
               EXPECT_EQ(high[i], most[i]) << "scale " << scale << ", response " << i;
               EXPECT_EQ(low[i], -most[i]) << "scale " << scale << ", response " << i;
            }
         }
      }
   }
}

/// The largest cost beside that of the winner, `side` disparities away, less the winner's.
int steepest(const std::vector<DeepPair>& pairs, const Matching& matching, int side) {
   int most = 0;
   for (const DeepPair& pair : pairs) {
      const CostVolume sums = window_sums(pixel_costs(pair.left, pair.right, matching), matching.window_px);
      const DisparityMap best = winners(sums);
      for (int y = 0; y < sums.height; ++y)
         for (int x = 0; x < sums.width; ++x) {
            const int d = best.at(x, y) - matching.min_disparity, beside = d + side;
            if (beside >= 0 && beside < sums.disparities)
               most = std::max(most, sums.at(x, y, beside) - sums.at(x, y, d));
         }
   }
   return most;
}

TEST(PhaseStressPairs, CostsBesideTheWinnerAreNearTheLargest) {
   for (const int scales : {1, 2, 3})
      for (const int window : {5, 9}) {
         Matching matching{DisparityCount{12}};
         matching.phase_scales = scales;
         matching.window_px = window;
         Random random(test_seed());
         const std::vector<DeepPair> pairs = own_stress_pairs(matching, 48, 30, random);
         const int largest = code_cost(0, ~uint64_t(0), scales) * window * window;
         for (const int side : {-1, 1})
            EXPECT_GT(steepest(pairs, matching, side), largest * 3 / 5) << scales << " scales, window " << window;
      }
}

TEST(PhaseStressPairs, AreNoneWhereNoFilterFits) {
   Random random(1);
   EXPECT_TRUE(own_stress_pairs(Matching{DisparityCount{6}}, 4, 40, random).empty());
}

}  // namespace
}  // namespace stereo::test
