// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "definition/block_matching/matching_input.hpp"

namespace stereo::block_matching {

/// Columns first ... first+count-1 of an image and room for whole vectors behind them; 0 where the image has none. The
/// first one may lie outside the image.
template <class Pixel>
class AlignedRows {
  public:
   AlignedRows(const std::vector<Pixel>& pixels, int width, int first, int count, int room)
       : height_(int(pixels.size()) / width), stride_(count + room), black_(std::size_t(stride_)) {
      pixels_.resize(std::size_t(stride_) * std::size_t(height_));
      for (int y = 0; y < height_; ++y)
         std::copy_n(pixels.begin() + std::ptrdiff_t(y) * width + std::max(first, 0),
                     std::min(count, width - first) - std::max(-first, 0),
                     pixels_.begin() + std::ptrdiff_t(y) * stride_ + std::max(-first, 0));
   }

   int height() const { return height_; }
   /// Zeros above and below the image.
   const Pixel* row(int y) const {
      return y >= 0 && y < height_ ? pixels_.data() + std::ptrdiff_t(y) * stride_ : black_.data();
   }

  private:
   int height_, stride_;
   std::vector<Pixel> pixels_, black_;
};

/// Cost column x compares right.row(y)[x] with left.row(y)[x + d], whatever the smallest disparity.
template <class Pixel>
struct AlignedPair {
   /// Both images of `width`; `room` columns behind the last one that a disparity below D reaches.
   AlignedPair(const std::vector<Pixel>& left_pixels, const std::vector<Pixel>& right_pixels, int width,
               const Matching& matching, int room)
       : columns(cost_columns(width, matching)),
         left(left_pixels, width, first_cost_column(matching) + matching.min_disparity,
              columns + matching.disparities - 1, room),
         right(right_pixels, width, first_cost_column(matching), columns, room) {}

   int columns;
   AlignedRows<Pixel> left, right;
};

}  // namespace stereo::block_matching
