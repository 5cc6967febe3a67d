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
/// image; `number` counts the pixels of the window.
template <class Visit>
void for_each_other(int height, int census_width_px, int census_height_px, int threads, const Visit& visit) {
   const int radius_x = census_width_px / 2, radius_y = census_height_px / 2;
   for_each_band(height, threads, [&](int first, int end) {
      for (int y = first; y < end; ++y)
         for (int dy = -radius_y; dy <= radius_y; ++dy)
            for (int dx = -radius_x; dx <= radius_x; ++dx) {
               const int place = (dy + radius_y) * census_width_px + dx + radius_x;
               const int number = place - (dy > 0 || (dy == 0 && dx > 0) ? 1 : 0);
               if ((dy != 0 || dx != 0) && y + dy >= 0 && y + dy < height) visit(y, y + dy, dx, number);
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
std::vector<uint64_t> transforms_of(const RasterImage<Pixel>& image, int census_width_px, int census_height_px,
                                    int threads) {
   std::vector<uint64_t> transforms(image.pixels.size());
   for_each_other(image.height, census_width_px, census_height_px, threads, [&](int y, int row, int dx, int) {
      append_to_row(transforms.data() + std::ptrdiff_t(y) * image.width, image, y, row, dx);
   });
   return transforms;
}

template <class Pixel>
std::vector<uint8_t> planes_of(const RasterImage<Pixel>& image, int census_width_px, int census_height_px,
                               int threads) {
   const int planes = (census_width_px * census_height_px - 1 + 7) / 8;
   std::vector<uint8_t> transforms(image.pixels.size() * std::size_t(planes));
   for_each_other(image.height, census_width_px, census_height_px, threads, [&](int y, int row, int dx, int number) {
      append_to_row(transforms.data() + (std::ptrdiff_t(number / 8) * image.height + y) * image.width, image, y, row,
                    dx);
   });
   return transforms;
}

}  // namespace

std::vector<uint64_t> census(const GrayImage& image, int census_width_px, int census_height_px, int threads) {
   return transforms_of(image, census_width_px, census_height_px, threads);
}
std::vector<uint64_t> census(const DeepImage& image, int census_width_px, int census_height_px, int threads) {
   return transforms_of(image, census_width_px, census_height_px, threads);
}

std::vector<uint8_t> census_planes(const GrayImage& image, int census_width_px, int census_height_px, int threads) {
   return planes_of(image, census_width_px, census_height_px, threads);
}
std::vector<uint8_t> census_planes(const DeepImage& image, int census_width_px, int census_height_px, int threads) {
   return planes_of(image, census_width_px, census_height_px, threads);
}

}  // namespace stereo::fast
