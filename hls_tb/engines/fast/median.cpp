// SPDX-License-Identifier: Apache-2.0
// Columns of three are sorted once and shared by three pixels. The median of nine is then the middle one of: the
// largest of the three minima, the middle one of the three middles, the smallest of the three maxima.
#include "engines/fast/median.hpp"

#include <algorithm>

#include "engines/fast/bands.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

STEREO_INTO_CLONES uint16_t middle(uint16_t a, uint16_t b, uint16_t c) {
   return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

struct SortedColumns {
   std::vector<uint16_t> low, mid, high;  ///< [x + 1]
};

STEREO_VECTOR_CLONES void sort_columns(SortedColumns& sorted, const uint16_t* __restrict above,
                                       const uint16_t* __restrict row, const uint16_t* __restrict below, int width) {
   uint16_t* const __restrict low = sorted.low.data() + 1;
   uint16_t* const __restrict mid = sorted.mid.data() + 1;
   uint16_t* const __restrict high = sorted.high.data() + 1;
   for (int x = 0; x < width; ++x) {
      low[x] = std::min(std::min(above[x], row[x]), below[x]);
      mid[x] = middle(above[x], row[x], below[x]);
      high[x] = std::max(std::max(above[x], row[x]), below[x]);
   }
   for (uint16_t* const values : {low, mid, high}) {
      values[-1] = values[0];
      values[width] = values[width - 1];
   }
}

STEREO_VECTOR_CLONES void take_medians(uint16_t* __restrict medians, const SortedColumns& sorted, int width) {
   const uint16_t* const __restrict low = sorted.low.data();
   const uint16_t* const __restrict mid = sorted.mid.data();
   const uint16_t* const __restrict high = sorted.high.data();
   for (int x = 0; x < width; ++x)
      medians[x] = middle(std::max(std::max(low[x], low[x + 1]), low[x + 2]), middle(mid[x], mid[x + 1], mid[x + 2]),
                          std::min(std::min(high[x], high[x + 1]), high[x + 2]));
}

}  // namespace

DisparityMap median_3x3(const DisparityMap& map, int threads) {
   DisparityMap filtered = map;
   const auto row = [&](int y) {
      return map.disparity.data() + std::ptrdiff_t(std::clamp(y, 0, map.height - 1)) * map.width;
   };
   for_each_band(map.height, threads, [&](int first, int end) {
      const std::vector<uint16_t> blank(std::size_t(map.width) + 2);
      SortedColumns sorted{blank, blank, blank};
      for (int y = first; y < end; ++y) {
         sort_columns(sorted, row(y - 1), row(y), row(y + 1), map.width);
         take_medians(&filtered.at(0, y), sorted, map.width);
      }
   });
   return filtered;
}

}  // namespace stereo::fast
