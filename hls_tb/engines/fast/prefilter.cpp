// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/prefilter.hpp"

#include <algorithm>

#include "engines/fast/bands.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

/// Columns 1 ... width-2 of a row; the rows beside it are above and below.
template <class Pixel>
STEREO_INTO_CLONES void filter(Pixel* __restrict filtered, const Pixel* __restrict above, const Pixel* __restrict row,
                               const Pixel* __restrict below, int width, int cap) {
   for (int x = 1; x < width - 1; ++x) {
      const int16_t slope =
          int16_t(above[x + 1] - above[x - 1] + 2 * (row[x + 1] - row[x - 1]) + below[x + 1] - below[x - 1]);
      filtered[x] = Pixel(std::min(std::max(int(slope), -cap), cap) + cap);
   }
}
STEREO_VECTOR_CLONES void filter_row(uint8_t* __restrict filtered, const uint8_t* __restrict above,
                                     const uint8_t* __restrict row, const uint8_t* __restrict below, int width,
                                     int cap) {
   filter(filtered, above, row, below, width, cap);
}
STEREO_VECTOR_CLONES void filter_row(uint16_t* __restrict filtered, const uint16_t* __restrict above,
                                     const uint16_t* __restrict row, const uint16_t* __restrict below, int width,
                                     int cap) {
   filter(filtered, above, row, below, width, cap);
}

template <class Pixel>
RasterImage<Pixel> filtered_image(const RasterImage<Pixel>& image, int cap, int threads) {
   RasterImage<Pixel> filtered(image.width, image.height, Pixel(cap));
   const int last = image.height - 1;
   for_each_band(image.height, threads, [&](int first, int end) {
      for (int y = first; y < end; ++y) {
         const int above = y > 0 ? y - 1 : std::min(1, last), below = y < last ? y + 1 : std::max(last - 1, 0);
         filter_row(filtered.row(y), image.row(above), image.row(y), image.row(below), image.width, cap);
      }
   });
   return filtered;
}

}  // namespace

GrayImage prefilter_xsobel(const GrayImage& image, int cap, int threads) { return filtered_image(image, cap, threads); }
DeepImage prefilter_xsobel(const DeepImage& image, int cap, int threads) { return filtered_image(image, cap, threads); }

}  // namespace stereo::fast
