// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/semi_global/pixel_rows.hpp"

#include <algorithm>

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
PixelRows<Pixel>::PixelRows(const std::vector<Pixel>& left_planes, const std::vector<Pixel>& right_planes,
                            int image_width, int image_height, const Matching& matching, int room)
    : height(image_height),
      columns(block_matching::cost_columns(image_width, matching.window_costs())),
      planes(int(std::ssize(left_planes) / image_width / image_height)),
      left_stride(columns + matching.disparities - 1 + room),
      right_stride(columns) {
   const int first = block_matching::first_cost_column(matching.window_costs());
   copy_columns(left_planes, image_width, first + matching.min_disparity, columns + matching.disparities - 1, left,
                left_stride);
   copy_columns(right_planes, image_width, first, columns, right, right_stride);
}

template <class Image>
PixelRows<uint8_t> census_rows(const Image& left, const Image& right, const Matching& matching, int room, int threads) {
   const auto planes_of = [&](const Image& image) { return fast::census_planes(image, matching, threads); };
   return {planes_of(left), planes_of(right), left.width, left.height, matching, room};
}

template <class Pixel>
PixelRows<Pixel> pixel_rows(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching,
                            int room, int threads) {
   if (matching.prefilter == Prefilter::none)
      return {left.pixels, right.pixels, left.width, left.height, matching, room};
   const auto filtered = [&](const RasterImage<Pixel>& image) {
      return fast::prefilter_xsobel(image, matching.prefilter_cap, threads).pixels;
   };
   return {filtered(left), filtered(right), left.width, left.height, matching, room};
}

template struct PixelRows<uint8_t>;
template struct PixelRows<uint16_t>;
template PixelRows<uint8_t> census_rows(const GrayImage&, const GrayImage&, const Matching&, int, int);
template PixelRows<uint8_t> census_rows(const DeepImage&, const DeepImage&, const Matching&, int, int);
template PixelRows<uint8_t> pixel_rows(const GrayImage&, const GrayImage&, const Matching&, int, int);
template PixelRows<uint16_t> pixel_rows(const DeepImage&, const DeepImage&, const Matching&, int, int);

}  // namespace stereo::semi_global
