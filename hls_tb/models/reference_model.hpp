// SPDX-License-Identifier: Apache-2.0
// The definition of the result, one function a stage, for tests: plain loops and nothing shared with hls/.
#pragma once

#include "models/matching.hpp"

namespace stereo {

/// A value for every (x, y, d).
struct CostVolume {
   int width = 0;
   int height = 0;
   int disparities = 0;
   std::vector<int> values;

   CostVolume() = default;
   CostVolume(int width_px, int height_px, int disparity_range)
       : width(width_px),
         height(height_px),
         disparities(disparity_range),
         values(std::size_t(width_px) * std::size_t(height_px) * std::size_t(disparity_range)) {}

   int& at(int x, int y, int d) { return values[index(x, y, d)]; }
   int at(int x, int y, int d) const { return values[index(x, y, d)]; }

  private:
   std::size_t index(int x, int y, int d) const {
      return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(disparities) + std::size_t(d);
   }
};

/// c(x,y,d) = |R(x,y) - L(x+d,y)| for 0 <= x <= W-D: a volume of (W-D+1) x H x D.
CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, MatchingParameters parameters);

/// Sum of c over the rows y-r ... y+r of one column; rows outside the image count 0. Same size as c.
CostVolume column_sums(const CostVolume& costs, int window_px);

/// S(x,y,d): sum of c over the window centred on (x,y); cost columns and rows outside count 0. (W-D) x H x D.
CostVolume window_sums(const CostVolume& costs, int window_px);

/// The smallest d with the smallest sum.
GrayImage winners(const CostVolume& sums);

/// All of it: the disparity map, W-D wide. Throws std::invalid_argument as check_matching_input does.
GrayImage match_reference(const GrayImage& left, const GrayImage& right, MatchingParameters parameters);

}  // namespace stereo
