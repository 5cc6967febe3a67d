// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/pixel_rows.hpp"

#include <algorithm>
#include <type_traits>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/census.hpp"
#include "engines/fast/prefilter.hpp"

namespace stereo::semi_global {
namespace {

/// Columns first ... first+count-1 of all rows, those of the image; it may end before them, or begin behind the first.
template <class Pixel>
void copy_columns(const std::vector<Pixel>& pixels, int width, int first, int count, std::vector<Pixel>& to,
                  int stride) {
   const std::ptrdiff_t rows = std::ptrdiff_t(pixels.size()) / width;
   to.resize(std::size_t(rows * stride));
   for (std::ptrdiff_t y = 0; y < rows; ++y)
      std::copy_n(pixels.begin() + y * width + std::max(first, 0), std::min(count, width - first) - std::max(-first, 0),
                  to.begin() + y * stride + std::max(-first, 0));
}

}  // namespace

template <class Pixel>
template <class Image>
PixelRows<Pixel>::PixelRows(const Image& left_image, const Image& right_image, const Matching& matching, int room,
                            int threads)
    : height(left_image.height),
      columns(block_matching::cost_columns(left_image.width, matching.window_costs())),
      left_stride(columns + matching.disparities - 1 + room),
      right_stride(columns) {
   const int width = left_image.width, first = block_matching::first_cost_column(matching.window_costs());
   const int first_left = first + matching.min_disparity, left_count = columns + matching.disparities - 1;
   const auto copy = [&](const std::vector<Pixel>& left_pixels, const std::vector<Pixel>& right_pixels) {
      copy_columns(left_pixels, width, first_left, left_count, left, left_stride);
      copy_columns(right_pixels, width, first, columns, right, right_stride);
   };
   if constexpr (sizeof(Pixel) == 1) {
      if (matching.cost == Cost::census) {
         const int census_width = matching.census_width_px, census_height = matching.census_height_px;
         planes = (census_width * census_height - 1 + 7) / 8;
         copy(fast::census_planes(left_image, census_width, census_height, threads),
              fast::census_planes(right_image, census_width, census_height, threads));
         return;
      }
   }
   if constexpr (std::is_same_v<decltype(left_image.pixels), std::vector<Pixel>>) {
      if (matching.prefilter == Prefilter::xsobel)
         copy(fast::prefilter_xsobel(left_image, matching.prefilter_cap, threads).pixels,
              fast::prefilter_xsobel(right_image, matching.prefilter_cap, threads).pixels);
      else copy(left_image.pixels, right_image.pixels);
   }
}

template PixelRows<uint8_t>::PixelRows(const GrayImage&, const GrayImage&, const Matching&, int, int);
template PixelRows<uint8_t>::PixelRows(const DeepImage&, const DeepImage&, const Matching&, int, int);
template PixelRows<uint16_t>::PixelRows(const DeepImage&, const DeepImage&, const Matching&, int, int);

}  // namespace stereo::semi_global
