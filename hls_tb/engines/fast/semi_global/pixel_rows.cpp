// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/pixel_rows.hpp"

#include <algorithm>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/census.hpp"
#include "engines/fast/prefilter.hpp"

namespace stereo::semi_global {
namespace {

/// Columns first ... first+count-1 of the image's bytes number `plane`.
template <class Pixel>
void copy_plane(const std::vector<Pixel>& pixels, int width, int first, int count, int plane, uint8_t* to, int stride) {
   const int height = int(pixels.size()) / width;
   for (int y = 0; y < height; ++y)
      std::transform(pixels.begin() + std::ptrdiff_t(y) * width + first,
                     pixels.begin() + std::ptrdiff_t(y) * width + first + count, to + std::ptrdiff_t(y) * stride,
                     [plane](Pixel pixel) { return uint8_t(pixel >> (8 * plane)); });
}

}  // namespace

PixelRows::PixelRows(const GrayImage& left_image, const GrayImage& right_image, const Matching& matching, int room)
    : height(left_image.height),
      columns(block_matching::cost_columns(left_image.width, matching.window_costs())),
      left_stride(columns + matching.disparities - 1 + room),
      right_stride(columns) {
   const int width = left_image.width, first = block_matching::first_cost_column(matching.window_costs());
   const int first_left = first + matching.min_disparity, left_count = columns + matching.disparities - 1;
   const auto copy = [&](const auto& left_pixels, const auto& right_pixels) {
      left.resize(std::size_t(planes) * std::size_t(height) * std::size_t(left_stride));
      right.resize(std::size_t(planes) * std::size_t(height) * std::size_t(right_stride));
      for (int plane = 0; plane < planes; ++plane) {
         const std::ptrdiff_t rows = std::ptrdiff_t(plane) * height;
         copy_plane(left_pixels, width, first_left, left_count, plane, left.data() + rows * left_stride, left_stride);
         copy_plane(right_pixels, width, first, columns, plane, right.data() + rows * right_stride, right_stride);
      }
   };
   if (matching.cost == Cost::census) {
      const int census_width = matching.census_width_px, census_height = matching.census_height_px;
      planes = (census_width * census_height - 1 + 7) / 8;
      copy(fast::census(left_image, census_width, census_height),
           fast::census(right_image, census_width, census_height));
   } else if (matching.prefilter == Prefilter::xsobel) {
      copy(fast::prefilter_xsobel(left_image, matching.prefilter_cap).pixels,
           fast::prefilter_xsobel(right_image, matching.prefilter_cap).pixels);
   } else {
      copy(left_image.pixels, right_image.pixels);
   }
}

}  // namespace stereo::semi_global
