// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/truth.hpp"

#include <cstdlib>

namespace stereo::app {

TruthScore score_against_truth(const DisparityMap& map, const MapGeometry& geometry, const GrayImage& truth,
                               const GrayImage& visible) {
   const int first = geometry.first_column, steps = map.steps_per_pixel();
   TruthScore result;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (visible.at(first + x, y) == 0) continue;
         if (!map.valid_at(x, y)) {
            ++result.invalid;
            continue;
         }
         const int found = map.at(x, y) + steps * geometry.min_disparity, wanted = steps * truth.at(first + x, y);
         ++result.compared;
         result.bad += std::abs(found - wanted) > steps * kBadPixelTolerance ? 1 : 0;
      }
   return result;
}

}  // namespace stereo::app
