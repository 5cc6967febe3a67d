// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/block_matching/texture.hpp"

#include <algorithm>
#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"

namespace stereo::block_matching {

void check_texture(const GrayImage& filtered, const Matching& matching, DisparityMap& map) {
   const int first = first_cost_column(matching), count = cost_columns(filtered.width, matching);
   const int above = std::min(rows_above(matching), filtered.height - 1);
   const int below = std::min(rows_below(matching), filtered.height - 1);
   const int before = std::min(rows_above(matching), count - 1), after = std::min(rows_below(matching), count - 1);
   std::vector<int> columns(static_cast<std::size_t>(count));
   const auto add_row = [&](int y, int sign) {
      if (y < 0 || y >= filtered.height) return;
      const uint8_t* const row = filtered.row(y) + first;
      for (int x = 0; x < count; ++x) columns[std::size_t(x)] += sign * std::abs(row[x] - matching.prefilter_cap);
   };
   for (int y = -below; y < map.height; ++y) {
      add_row(y + below, 1);
      add_row(y - above - 1, -1);
      if (y < 0) continue;
      int texture = 0;
      for (int x = 0; x < after; ++x) texture += columns[std::size_t(x)];
      for (int x = 0; x < map.width; ++x) {
         if (x + after < count) texture += columns[std::size_t(x + after)];
         if (x - before > 0) texture -= columns[std::size_t(x - before - 1)];
         if (texture < matching.texture_threshold) map.valid_at(x, y) = 0;
      }
   }
}

}  // namespace stereo::block_matching
