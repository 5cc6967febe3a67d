// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "definition/gray_image.hpp"
#include "semi_global/matching.hpp"

namespace stereo::semi_global {

/// What is compared, in planes: the grey values or filtered pixels in one plane, or the census transforms, eight bits a
/// plane. Cost column x compares right[x] with left[x + d], whatever the smallest disparity. Pixel: bytes, which always
/// hold census transforms, or 16 bits for grey values of more than 8.
template <class Pixel>
struct PixelRows {
   template <class Image>
   PixelRows(const Image& left_image, const Image& right_image, const Matching& matching, int room, int threads);

   const Pixel* left_row(int plane, int y) const { return row(left, left_stride, plane, y); }
   const Pixel* right_row(int plane, int y) const { return row(right, right_stride, plane, y); }

   int height, columns;  ///< the cost columns
   int planes = 1;
   int left_stride, right_stride;
   std::vector<Pixel> left, right;  ///< [plane][y][x], and `room` columns of zeros behind each row

  private:
   const Pixel* row(const std::vector<Pixel>& pixels, int stride, int plane, int y) const {
      return pixels.data() + (std::ptrdiff_t(plane) * height + y) * stride;
   }
};

}  // namespace stereo::semi_global
