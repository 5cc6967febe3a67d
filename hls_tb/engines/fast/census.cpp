// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/census.hpp"

#include <algorithm>

#include "engines/fast/bands.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

/// Appends a bit to each transform of a row: is the other pixel larger?
template <class Bits, class Pixel>
STEREO_INTO_CLONES void append(Bits* __restrict bits, const Pixel* __restrict centre, const Pixel* __restrict other,
                               int count) {
   for (int x = 0; x < count; ++x) {
      const Bits larger = Bits(other[x] > centre[x]);
      bits[x] = Bits(Bits(bits[x] << 1) | larger);
   }
}
STEREO_VECTOR_CLONES void append_bits(uint64_t* __restrict bits, const uint8_t* __restrict centre,
                                      const uint8_t* __restrict other, int count) {
   append(bits, centre, other, count);
}
STEREO_VECTOR_CLONES void append_bits(uint64_t* __restrict bits, const uint16_t* __restrict centre,
                                      const uint16_t* __restrict other, int count) {
   append(bits, centre, other, count);
}
STEREO_VECTOR_CLONES void append_bits(uint8_t* __restrict bits, const uint8_t* __restrict centre,
                                      const uint8_t* __restrict other, int count) {
   append(bits, centre, other, count);
}
STEREO_VECTOR_CLONES void append_bits(uint8_t* __restrict bits, const uint16_t* __restrict centre,
                                      const uint16_t* __restrict other, int count) {
   append(bits, centre, other, count);
}

/// Calls visit(y, row, dx, number) for each other pixel of the window around the pixels of row y, whose rows lie in the
/// image; `number` counts the pixels of the pattern.
template <class Visit>
void for_each_other(int height, const CensusWindow& window, int threads, const Visit& visit) {
   const int radius_x = window.census_width_px / 2, radius_y = window.census_height_px / 2;
   for_each_band(height, threads, [&](int first, int end) {
      for (int y = first; y < end; ++y) {
         int number = 0;
         for (int dy = -radius_y; dy <= radius_y; ++dy)
            for (int dx = -radius_x; dx <= radius_x; ++dx) {
               if (!has_census_bit(window.census_pattern, dx, dy)) continue;
               if (y + dy >= 0 && y + dy < height) visit(y, y + dy, dx, number);
               ++number;
            }
      }
   });
}

/// Appends the bits of one other pixel to a row of transforms. Beyond the image no pixel is larger than the centre: the
/// bit stays 0.
template <class Bits, class Pixel>
void append_to_row(Bits* bits, const RasterImage<Pixel>& image, int y, int row, int dx) {
   const int first = std::max(0, -dx), end = std::min(image.width, image.width - dx);
   for (int x = 0; x < std::min(first, image.width); ++x) bits[x] = Bits(bits[x] << 1);
   if (first < end) append_bits(bits + first, image.row(y) + first, image.row(row) + first + dx, end - first);
   for (int x = std::max(end, 0); x < image.width; ++x) bits[x] = Bits(bits[x] << 1);
}

template <class Pixel>
std::vector<uint64_t> transforms_of(const RasterImage<Pixel>& image, const CensusWindow& window, int threads) {
   std::vector<uint64_t> transforms(image.pixels.size());
   for_each_other(image.height, window, threads, [&](int y, int row, int dx, int) {
      append_to_row(transforms.data() + std::ptrdiff_t(y) * image.width, image, y, row, dx);
   });
   return transforms;
}

template <class Pixel>
std::vector<uint8_t> planes_of(const RasterImage<Pixel>& image, const CensusWindow& window, int threads) {
   const int planes = (census_bits(window.census_width_px, window.census_height_px, window.census_pattern) + 7) / 8;
   std::vector<uint8_t> transforms(image.pixels.size() * std::size_t(planes));
   for_each_other(image.height, window, threads, [&](int y, int row, int dx, int number) {
      append_to_row(transforms.data() + (std::ptrdiff_t(number / 8) * image.height + y) * image.width, image, y, row,
                    dx);
   });
   return transforms;
}

}  // namespace

std::vector<uint64_t> census(const GrayImage& image, const CensusWindow& window, int threads) {
   return transforms_of(image, window, threads);
}
std::vector<uint64_t> census(const DeepImage& image, const CensusWindow& window, int threads) {
   return transforms_of(image, window, threads);
}

std::vector<uint8_t> census_planes(const GrayImage& image, const CensusWindow& window, int threads) {
   return planes_of(image, window, threads);
}
std::vector<uint8_t> census_planes(const DeepImage& image, const CensusWindow& window, int threads) {
   return planes_of(image, window, threads);
}

}  // namespace stereo::fast
