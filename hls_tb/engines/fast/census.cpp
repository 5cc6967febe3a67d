// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/census.hpp"

#include <algorithm>

#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

/// Appends a bit to each transform of a row: is the other pixel larger?
STEREO_VECTOR_CLONES void append_bits(uint64_t* __restrict bits, const uint8_t* __restrict centre,
                                      const uint8_t* __restrict other, int count) {
   for (int x = 0; x < count; ++x) bits[x] = bits[x] << 1 | (other[x] > centre[x] ? 1u : 0u);
}

}  // namespace

std::vector<uint64_t> census(const GrayImage& image, int census_width_px, int census_height_px) {
   const int radius_x = census_width_px / 2, radius_y = census_height_px / 2;
   std::vector<uint64_t> transforms(image.pixels.size());
   for (int y = 0; y < image.height; ++y)
      for (int row = std::max(y - radius_y, 0); row <= std::min(y + radius_y, image.height - 1); ++row)
         for (int dx = -radius_x; dx <= radius_x; ++dx) {
            if (row == y && dx == 0) continue;
            // Beyond the image no pixel is larger than the centre: the bit stays 0.
            const int first = std::max(0, -dx), end = std::min(image.width, image.width - dx);
            uint64_t* const bits = transforms.data() + std::ptrdiff_t(y) * image.width;
            for (int x = 0; x < std::min(first, image.width); ++x) bits[x] <<= 1;
            if (first < end) append_bits(bits + first, image.row(y) + first, image.row(row) + first + dx, end - first);
            for (int x = std::max(end, 0); x < image.width; ++x) bits[x] <<= 1;
         }
   return transforms;
}

}  // namespace stereo::fast
