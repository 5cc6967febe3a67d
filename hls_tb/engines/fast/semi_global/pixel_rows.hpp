// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "definition/gray_image.hpp"
#include "semi_global/matching.hpp"

namespace stereo::semi_global {

/// What is compared, in planes. Cost column x compares right[x] with left[x + d], whatever the smallest disparity.
template <class Pixel>
struct PixelRows {
   /// Of the images' planes, [plane][y][x], one behind the other.
   PixelRows(const std::vector<Pixel>& left_planes, const std::vector<Pixel>& right_planes, int image_width,
             int image_height, const Matching& matching, int room);

   const Pixel* left_row(int plane, int y) const { return row(left, left_stride, plane, y); }
   const Pixel* right_row(int plane, int y) const { return row(right, right_stride, plane, y); }

   int height, columns;  ///< the cost columns
   int planes;
   int left_stride, right_stride;
   std::vector<Pixel> left, right;  ///< [plane][y][x], and `room` columns of zeros behind each row

  private:
   const Pixel* row(const std::vector<Pixel>& pixels, int stride, int plane, int y) const {
      return pixels.data() + (std::ptrdiff_t(plane) * height + y) * stride;
   }
};

/// The census transforms, eight bits a plane. Either kind of image.
template <class Image>
PixelRows<uint8_t> census_rows(const Image& left, const Image& right, const Matching& matching, int room, int threads);

/// The grey values, or what the prefilter makes of them, in one plane.
template <class Pixel>
PixelRows<Pixel> pixel_rows(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching,
                            int room, int threads);

}  // namespace stereo::semi_global
