// SPDX-License-Identifier: Apache-2.0
// The models of the example family. It is so simple that the definition is fast enough.
#pragma once

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "absolute_difference/config.hpp"
#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "definition/map_geometry.hpp"

namespace stereo::absolute_difference {

inline std::string describe(const Matching& matching) {
   return "absolute difference, valid from " + std::to_string(matching.least_difference) + " on";
}

inline MapGeometry map_geometry(const Matching& matching, int image_width) {
   return {Reference::left, 0, image_width, 256, 0, matching.least_difference > 0};
}

inline DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   if (const Sentence problem = matching.problem(); !problem.empty()) throw std::invalid_argument(problem.text);
   require_same_size<std::invalid_argument>("left", left, "right", right);
   DisparityMap map(left.width, left.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         map.at(x, y) = uint16_t(std::abs(left.at(x, y) - right.at(x, y)));
         map.valid_at(x, y) = map.at(x, y) >= matching.least_difference ? 1 : 0;
      }
   return map;
}

inline DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return match_reference(left, right, matching);
}

}  // namespace stereo::absolute_difference
