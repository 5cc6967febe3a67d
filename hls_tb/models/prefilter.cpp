// SPDX-License-Identifier: Apache-2.0
#include "models/prefilter.hpp"

#include <algorithm>
#include <cstdlib>

#include "models/vector_clones.hpp"

namespace stereo::fast {
namespace {

/// Columns 1 ... width-2 of a row; the rows beside it are above and below.
STEREO_VECTOR_CLONES void filter_row(uint8_t* __restrict filtered, const uint8_t* __restrict above,
                                     const uint8_t* __restrict row, const uint8_t* __restrict below, int width,
                                     int cap) {
   for (int x = 1; x < width - 1; ++x) {
      const int16_t slope =
          int16_t(above[x + 1] - above[x - 1] + 2 * (row[x + 1] - row[x - 1]) + below[x + 1] - below[x - 1]);
      filtered[x] = uint8_t(std::min(std::max(int(slope), -cap), cap) + cap);
   }
}

}  // namespace

GrayImage prefilter_xsobel(const GrayImage& image, int cap) {
   GrayImage filtered(image.width, image.height, uint8_t(cap));
   const int last = image.height - 1;
   for (int y = 0; y <= last; ++y) {
      const int above = y > 0 ? y - 1 : std::min(1, last), below = y < last ? y + 1 : std::max(last - 1, 0);
      filter_row(filtered.row(y), image.row(above), image.row(y), image.row(below), image.width, cap);
   }
   return filtered;
}

void check_texture(const GrayImage& filtered, const MatchingParameters& parameters, DisparityMap& map) {
   const int first = first_cost_column(parameters), count = cost_columns(filtered.width, parameters);
   const int above = std::min(parameters.rows_above(), filtered.height - 1);
   const int below = std::min(parameters.rows_below(), filtered.height - 1);
   const int before = std::min(parameters.rows_above(), count - 1),
             after = std::min(parameters.rows_below(), count - 1);
   std::vector<int> columns(static_cast<std::size_t>(count));
   const auto add_row = [&](int y, int sign) {
      if (y < 0 || y >= filtered.height) return;
      const uint8_t* const row = filtered.row(y) + first;
      for (int x = 0; x < count; ++x) columns[std::size_t(x)] += sign * std::abs(row[x] - parameters.prefilter_cap);
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
         if (texture < parameters.texture_threshold) map.valid_at(x, y) = 0;
      }
   }
}

}  // namespace stereo::fast
