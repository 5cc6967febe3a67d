// SPDX-License-Identifier: Apache-2.0
#include "definition/postprocessing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stereo {
namespace {

/// The disparity in whole pixels, rounded.
int whole(const DisparityMap& map, int x, int y) { return map.subpixel ? (map.at(x, y) + 8) / 16 : map.at(x, y); }

/// The nearest valid column left of x (step -1) or right of it (step 1); -1 where there is none.
int valid_column(const DisparityMap& map, int x, int y, int step) {
   for (int column = x + step; column >= 0 && column < map.width; column += step)
      if (map.valid_at(column, y)) return column;
   return -1;
}

/// What a pixel shows between two valid columns.
int between(const DisparityMap& map, int x, int y, int left, int right) {
   const int near = map.at(left, y), far = map.at(right, y);  // with the right image as reference
   const int hole = right - left - 1;
   const int rest = near >= far ? std::max(0, hole - (near - far) / map.steps_per_pixel()) : hole;
   return x > left + rest / 2 ? far : near;
}

}  // namespace

GrayImage margins(const CostVolume& sums, const DisparityMap& winners, int shift) {
   GrayImage image(sums.width, sums.height);
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
         const int winner = winners.at(x, y);
         int margin = PostProcessing::kLargestMargin;
         for (int d = 0; d < sums.disparities; ++d)
            if (std::abs(d - winner) > 1 && sums.at(x, y, d) != kNoCandidate)
               margin = std::min(margin, (sums.at(x, y, d) - sums.at(x, y, winner)) >> shift);
         image.at(x, y) = uint8_t(margin);
      }
   return image;
}

GrayImage neighbours(const DisparityMap& map) {
   GrayImage count(map.width, map.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (!map.valid_at(x, y)) continue;
         for (int row = y - 2; row <= y + 2; ++row)
            for (int column = x - 6; column <= x + 6; column += 2) {
               if (row < 0 || row >= map.height || column < 0 || column >= map.width) continue;
               if (map.valid_at(column, row) && std::abs(whole(map, column, row) - whole(map, x, y)) <= 1)
                  ++count.at(x, y);
            }
      }
   return count;
}

DisparityMap supported(const DisparityMap& map, const GrayImage& margins, const PostProcessing& options) {
   const GrayImage count = neighbours(map);
   DisparityMap result = map;
   if (options.has_confidence()) result.confidence.assign(map.valid.size(), 0);
   for (std::size_t i = 0; i < map.valid.size(); ++i) {
      result.valid[i] = map.valid[i] && count.pixels[i] >= options.support_threshold ? 1 : 0;
      if (options.has_confidence() && result.valid[i])
         result.confidence[i] = uint8_t(
             std::min(255, options.margin_weight * margins.pixels[i] + options.support_weight * count.pixels[i]));
   }
   return result;
}

DisparityMap holes_filled(const DisparityMap& map) {
   DisparityMap result = map;
   result.filled.assign(map.valid.size(), 0);
   bool has_values = false;  // some row so far has a valid pixel
   for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) has_values = has_values || map.valid_at(x, y);
      for (int x = 0; x < map.width; ++x) {
         if (map.valid_at(x, y)) continue;
         const int left = valid_column(map, x, y, -1), right = valid_column(map, x, y, 1);
         if (left >= 0 && right >= 0) result.at(x, y) = uint16_t(between(map, x, y, left, right));
         else if (left >= 0) result.at(x, y) = map.at(left, y);
         else if (right >= 0) result.at(x, y) = map.at(right, y);
         else if (y > 0) result.at(x, y) = result.at(x, y - 1);
         result.filled_at(x, y) = has_values ? 1 : 0;
      }
   }
   return result;
}

DisparityMap post_processed(const DisparityMap& map, const GrayImage& margins, const PostProcessing& options) {
   DisparityMap result = map;
   if (options.has_support_filter()) result = supported(result, margins, options);
   if (options.fill_holes) result = holes_filled(result);
   return result;
}

}  // namespace stereo
