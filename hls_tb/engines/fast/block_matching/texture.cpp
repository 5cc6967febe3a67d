// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/block_matching/texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/bands.hpp"

namespace stereo::block_matching {

namespace {

template <class Pixel>
void check(const RasterImage<Pixel>& filtered, const Matching& matching, DisparityMap& map, int threads) {
   const int first = first_cost_column(matching), count = cost_columns(filtered.width, matching);
   const int above = std::min(rows_above(matching), filtered.height - 1);
   const int below = std::min(rows_below(matching), filtered.height - 1);
   const int before = std::min(rows_above(matching), count - 1), after = std::min(rows_below(matching), count - 1);
   const int first_centre = matching.full_width ? rows_above(matching) : 0;  // of the map's first column
   const auto check_rows = [&](int first_row, int end_row) {
      std::vector<int> columns(static_cast<std::size_t>(count));
      const int oldest = std::max(first_row - above, 0);  // the first row that a window of this band sees
      const auto add_row = [&](int y, int sign) {
         if (y < oldest || y >= filtered.height) return;
         const Pixel* const row = filtered.row(y) + first;
         for (int x = 0; x < count; ++x) columns[std::size_t(x)] += sign * std::abs(row[x] - matching.prefilter_cap);
      };
      for (int y = oldest - below; y < end_row; ++y) {
         add_row(y + below, 1);
         add_row(y - above - 1, -1);
         if (y < first_row) continue;
         int texture = 0;
         for (int x = 0; x < after; ++x) texture += columns[std::size_t(x)];
         for (int x = 0; x < first_centre + map.width; ++x) {
            if (x + after < count) texture += columns[std::size_t(x + after)];
            if (x - before > 0) texture -= columns[std::size_t(x - before - 1)];
            if (x >= first_centre && texture < matching.texture_threshold) map.valid_at(x - first_centre, y) = 0;
         }
      }
   };
   fast::for_each_band(map.height, threads, check_rows);
}

}  // namespace

void check_texture(const GrayImage& filtered, const Matching& matching, DisparityMap& map, int threads) {
   check(filtered, matching, map, threads);
}
void check_texture(const DeepImage& filtered, const Matching& matching, DisparityMap& map, int threads) {
   check(filtered, matching, map, threads);
}

}  // namespace stereo::block_matching
