// SPDX-License-Identifier: Apache-2.0
#include "models/reference_model.hpp"

#include <cstdlib>

namespace stereo {

CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, MatchingParameters parameters) {
   check_matching_input(left, right, parameters);
   CostVolume costs(left.width - parameters.disparities + 1, left.height, parameters.disparities);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < costs.disparities; ++d)
            costs.at(x, y, d) = std::abs(int(right.at(x, y)) - int(left.at(x + d, y)));
   return costs;
}

CostVolume column_sums(const CostVolume& costs, int window_px) {
   const int radius = window_px / 2;
   CostVolume sums(costs.width, costs.height, costs.disparities);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int row = y - radius; row <= y + radius; ++row) {
            if (row < 0 || row >= costs.height) continue;
            for (int d = 0; d < sums.disparities; ++d) sums.at(x, y, d) += costs.at(x, row, d);
         }
   return sums;
}

CostVolume window_sums(const CostVolume& costs, int window_px) {
   const int radius = window_px / 2;
   CostVolume sums(costs.width - 1, costs.height, costs.disparities);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int row = y - radius; row <= y + radius; ++row)
            for (int column = x - radius; column <= x + radius; ++column) {
               if (row < 0 || row >= costs.height || column < 0 || column >= costs.width) continue;
               for (int d = 0; d < sums.disparities; ++d) sums.at(x, y, d) += costs.at(column, row, d);
            }
   return sums;
}

GrayImage winners(const CostVolume& sums) {
   GrayImage map(sums.width, sums.height);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x) {
         int best = 0;
         for (int d = 1; d < sums.disparities; ++d)
            if (sums.at(x, y, d) < sums.at(x, y, best)) best = d;
         map.at(x, y) = uint8_t(best);
      }
   return map;
}

GrayImage match_reference(const GrayImage& left, const GrayImage& right, MatchingParameters parameters) {
   return winners(window_sums(pixel_costs(left, right, parameters), parameters.window_px));
}

}  // namespace stereo
