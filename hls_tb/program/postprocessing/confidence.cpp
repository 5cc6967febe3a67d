// SPDX-License-Identifier: Apache-2.0
#include "program/postprocessing/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "definition/mirror.hpp"

namespace stereo::app {
namespace {

/// Sums over any rectangle of a map: sums(x, y) are those above and left of (x, y).
class RectangleSums {
  public:
   template <class Value>
   RectangleSums(int width, int height, Value value)
       : stride_(std::size_t(width) + 1), sums_(stride_ * (std::size_t(height) + 1)) {
      for (int y = 0; y < height; ++y)
         for (int x = 0; x < width; ++x) at(x + 1, y + 1) = value(x, y) + at(x, y + 1) + at(x + 1, y) - at(x, y);
   }
   /// Columns left ... right-1, rows top ... bottom-1.
   int64_t of(int left, int top, int right, int bottom) const {
      return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
   }

  private:
   int64_t& at(int x, int y) { return sums_[std::size_t(y) * stride_ + std::size_t(x)]; }
   int64_t at(int x, int y) const { return sums_[std::size_t(y) * stride_ + std::size_t(x)]; }

   std::size_t stride_;
   std::vector<int64_t> sums_;
};

/// In sixteenths of a pixel.
int64_t sixteenths(const DisparityMap& map, int x, int y) { return int64_t(map.at(x, y)) * 16 / map.steps_per_pixel(); }

}  // namespace

GrayImage smoothness(const DisparityMap& map) {
   const auto value = [&](int x, int y) { return sixteenths(map, x, y); };
   const RectangleSums sums(map.width, map.height, value);
   const RectangleSums squares(map.width, map.height, [&](int x, int y) { return value(x, y) * value(x, y); });
   GrayImage smooth(map.width, map.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const int left = std::max(x - kConfidenceRadius, 0), right = std::min(x + kConfidenceRadius + 1, map.width);
         const int top = std::max(y - kConfidenceRadius, 0), bottom = std::min(y + kConfidenceRadius + 1, map.height);
         const int64_t n = int64_t(right - left) * (bottom - top), sum = sums.of(left, top, right, bottom);
         const int64_t none = kConfidenceVariance * n * n;
         const int64_t variance = n * squares.of(left, top, right, bottom) - sum * sum;  // n * n times as large
         smooth.at(x, y) = uint8_t(variance >= none ? 0 : kLargestConfidence * (none - variance) / none);
      }
   return smooth;
}

GrayImage confidence(const DisparityMap& map, const DisparityMap& other, const MapGeometry& geometry, int image_width) {
   const GrayImage smooth = smoothness(map), other_smooth = smoothness(other);
   const int toward_the_match = geometry.reference == Reference::left ? -1 : 1;
   const int other_first_column = image_width - geometry.first_column - map.width;  // it is the mirror image
   GrayImage result(map.width, map.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const int disparity = geometry.min_disparity + map.at(x, y) / map.steps_per_pixel();
         const int there = geometry.first_column + x + toward_the_match * disparity - other_first_column;
         if (there < 0 || there >= other.width || !map.valid_at(x, y) || !other.valid_at(there, y)) continue;
         if (std::abs(sixteenths(map, x, y) - sixteenths(other, there, y)) >= kConfidenceTolerance) continue;
         result.at(x, y) = std::min(smooth.at(x, y), other_smooth.at(there, y));
      }
   return result;
}

DisparityMap other_map(const std::function<DisparityMap(const ImagePair&)>& match, const ImagePair& pair) {
   return mirrored(match(mirrored(pair)));
}
DisparityMap other_map(const std::function<DisparityMap(const DeepPair&)>& match, const DeepPair& pair) {
   return mirrored(match(mirrored(pair)));
}

}  // namespace stereo::app
