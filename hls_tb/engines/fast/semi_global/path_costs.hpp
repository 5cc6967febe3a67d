// SPDX-License-Identifier: Apache-2.0
// The costs of the paths, row after row: window costs as running sums of running column sums, all disparities of a
// pixel side by side in memory. Loops over d have no branches and no calls, so that the compiler vectorises them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "definition/block_matching/matching_input.hpp"
#include "definition/semi_global/matching_input.hpp"
#include "engines/fast/semi_global/pixel_rows.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::semi_global {

/// Eight bytes at any address.
using Bytes8 [[gnu::may_alias, gnu::aligned(1)]] = uint64_t;

/// The bits of up to three bytes in which left and right differ, for eight disparities in each word.
template <int Planes>
STEREO_INTO_CLONES Bytes8 hamming_distances(const uint8_t* const* left, const uint64_t* right, int at) {
   constexpr uint64_t kPairs = 0x5555555555555555, kNibbles = 0x3333333333333333, kBytes = 0x0f0f0f0f0f0f0f0f;
   uint64_t nibbles = 0;
   for (int plane = 0; plane < Planes; ++plane) {
      const uint64_t x = *reinterpret_cast<const Bytes8*>(left[plane] + at) ^ right[plane];
      const uint64_t pairs = x - ((x >> 1) & kPairs);
      nibbles += (pairs & kNibbles) + ((pairs >> 2) & kNibbles);
   }
   return (nibbles & kBytes) + ((nibbles >> 4) & kBytes);
}

template <int Planes>
STEREO_INTO_CLONES void add_hamming_distances(uint8_t* __restrict costs, const uint8_t* const* left,
                                              const uint64_t* right, int lanes, bool first) {
   for (int d = 0; d < lanes; d += 8) {
      const Bytes8 before = first ? 0 : *reinterpret_cast<Bytes8*>(costs + d);
      *reinterpret_cast<Bytes8*>(costs + d) = before + hamming_distances<Planes>(left, right, d);
   }
}

/// Costs of the single pixels of one row. costs: [x][d].
STEREO_INTO_CLONES void census_row(const PixelRows<uint8_t>& pixels, int y, int lanes, uint8_t* costs) {
   constexpr int kAtOnce = 3;
   for (int first = 0; first < pixels.planes; first += kAtOnce) {
      const int count = std::min(kAtOnce, pixels.planes - first);
      const uint8_t *left[kAtOnce] = {}, *right[kAtOnce] = {};
      for (int plane = 0; plane < count; ++plane) {
         left[plane] = pixels.left_row(first + plane, y);
         right[plane] = pixels.right_row(first + plane, y);
      }
      for (int x = 0; x < pixels.columns; ++x) {
         uint64_t bytes[kAtOnce] = {};
         const uint8_t* at[kAtOnce] = {};
         for (int plane = 0; plane < count; ++plane) {
            bytes[plane] = right[plane][x] * 0x0101010101010101u;
            at[plane] = left[plane] + x;
         }
         uint8_t* const to = costs + std::ptrdiff_t(x) * lanes;
         if (count == 3) add_hamming_distances<3>(to, at, bytes, lanes, first == 0);
         else if (count == 2) add_hamming_distances<2>(to, at, bytes, lanes, first == 0);
         else add_hamming_distances<1>(to, at, bytes, lanes, first == 0);
      }
   }
}

/// A PixelCost that is wider than a pixel holds squares.
template <class Pixel, class PixelCost>
STEREO_INTO_CLONES void difference_row(const PixelRows<Pixel>& pixels, int y, int lanes, PixelCost* costs) {
   for (int x = 0; x < pixels.columns; ++x) {
      const Pixel* const __restrict left = pixels.left_row(0, y) + x;
      const Pixel right = pixels.right_row(0, y)[x];
      PixelCost* const __restrict to = costs + std::ptrdiff_t(x) * lanes;
      if constexpr (sizeof(PixelCost) > sizeof(Pixel))
         for (int d = 0; d < lanes; ++d) to[d] = PixelCost((left[d] - right) * (left[d] - right));
      else
         for (int d = 0; d < lanes; ++d) to[d] = PixelCost(std::max(left[d], right) - std::min(left[d], right));
   }
}

/// Window costs of row after row. Pixel: as in PixelRows. PixelCost, Sum: types that hold the cost of a pixel and of a
/// window. Fixed: the number of lanes, or 0 where it is known only at run time.
template <class Pixel, class PixelCost, class Sum, int Fixed>
class WindowCosts {
  public:
   STEREO_INTO_CLONES WindowCosts(const PixelRows<Pixel>& pixels, const Matching& matching, int lanes)
       : pixels_(pixels),
         matching_(matching),
         lanes_(lanes),
         above_(std::min(matching.window_px / 2, pixels.height)),
         below_(std::min((matching.window_px - 1) / 2, pixels.height)),
         before_(std::min(matching.window_px / 2, pixels.columns)),
         after_(std::min((matching.window_px - 1) / 2, pixels.columns)),
         kept_(above_ + below_ + 2),
         row_size_(std::size_t(pixels.columns) * std::size_t(lanes)),
         rows_(row_size_ * std::size_t(kept_)),
         columns_(row_size_),
         window_(std::size_t(lanes)) {}

   /// The next row will be y.
   STEREO_INTO_CLONES void go_to(int y) {
      if (y == row_) return;
      row_ = y;
      oldest_ = std::max(y - above_, 0);
      std::fill(columns_.begin(), columns_.end(), Sum(0));
      for (int taken = oldest_; taken < y + below_; ++taken) take_in(taken);
   }

   /// The costs that the paths see in the next row, and the smallest of each column.
   template <class Lane>
   STEREO_INTO_CLONES void next_row(Lane* costs, Lane* smallest) {
      take_in(row_ + below_);
      if (row_ - above_ - 1 >= oldest_) take_out(row_ - above_ - 1);
      ++row_;
      std::fill(window_.begin(), window_.end(), Sum(0));
      for (int x = 0; x < after_; ++x) add(column(x));
      if (matching_.full_width) return next_full_row(costs, smallest);
      for (int x = 0; x < pixels_.columns; ++x) {
         if (x + after_ < pixels_.columns) add(column(x + after_));
         if (x - before_ > 0) remove(column(x - before_ - 1));
         smallest[x] = scaled(costs + std::ptrdiff_t(x) * lanes_);
      }
   }

  private:
   /// The map has the windows that lie in the image; what is no candidate has the largest cost, or the border cost.
   template <class Lane>
   STEREO_INTO_CLONES void next_full_row(Lane* costs, Lane* smallest) {
      const int width = pixels_.columns - matching_.window_px + 1;
      const Lane largest = Lane(largest_path_cost(matching_));
      const Lane border = Lane(matching_.has_border_cost() ? std::min(matching_.border_cost, int(largest)) : largest);
      const int first_searched = matching_.first_disparity, last_searched = matching_.window_costs().last_searched();
      for (int x = -before_; x < width; ++x) {
         add(column(x + before_ + after_));
         if (x > 0) remove(column(x - 1));
         if (x < 0) continue;
         Lane* const to = costs + std::ptrdiff_t(x) * lanes_;
         scaled(to);
         const auto [first, last] = block_matching::searched_range(x, width, matching_.window_costs());
         for (int d = 0; d < matching_.disparities; ++d)
            if (d < first || d > last) to[d] = d < first_searched || d > last_searched ? largest : border;
         smallest[x] = *std::min_element(to, to + matching_.disparities);
      }
   }

   STEREO_INTO_CLONES PixelCost* row(int y) { return rows_.data() + row_size_ * std::size_t(y % kept_); }
   STEREO_INTO_CLONES const Sum* column(int x) const { return columns_.data() + std::ptrdiff_t(x) * lanes_; }

   STEREO_INTO_CLONES void take_in(int y) {
      if (y >= pixels_.height) return;
      PixelCost* const __restrict from = row(y);
      if constexpr (sizeof(PixelCost) == 1) {
         if (matching_.cost == Cost::census) census_row(pixels_, y, Fixed > 0 ? Fixed : lanes_, from);
         else difference_row(pixels_, y, lanes_, from);
      } else {
         difference_row(pixels_, y, lanes_, from);
      }
      Sum* const __restrict to = columns_.data();
      const std::size_t size = row_size_;
      for (std::size_t i = 0; i < size; ++i) to[i] = Sum(to[i] + from[i]);
   }
   STEREO_INTO_CLONES void take_out(int y) {
      const PixelCost* const __restrict from = row(y);
      Sum* const __restrict to = columns_.data();
      const std::size_t size = row_size_;
      for (std::size_t i = 0; i < size; ++i) to[i] = Sum(to[i] - from[i]);
   }
   STEREO_INTO_CLONES void add(const Sum* __restrict from) {
      Sum* const __restrict to = window_.data();
      const int lanes = Fixed > 0 ? Fixed : lanes_;
      for (int d = 0; d < lanes; ++d) to[d] = Sum(to[d] + from[d]);
   }
   STEREO_INTO_CLONES void remove(const Sum* __restrict from) {
      Sum* const __restrict to = window_.data();
      const int lanes = Fixed > 0 ? Fixed : lanes_;
      for (int d = 0; d < lanes; ++d) to[d] = Sum(to[d] - from[d]);
   }
   /// The window's costs as a path sees them; gives the smallest.
   template <class Lane>
   STEREO_INTO_CLONES Lane scaled(Lane* __restrict costs) const {
      const Sum* const __restrict from = window_.data();
      const Sum cap = Sum(std::min<uint32_t>(uint32_t(matching_.cost_cap), std::numeric_limits<Sum>::max()));
      const int shift = matching_.cost_shift, lanes = Fixed > 0 ? Fixed : lanes_, disparities = matching_.disparities;
      Lane smallest = std::numeric_limits<Lane>::max();
      for (int d = 0; d < lanes; ++d) {
         const Sum shifted = Sum(from[d] >> shift);
         costs[d] = Lane(std::min(shifted, cap));
      }
      for (int d = 0; d < disparities; ++d) smallest = std::min(smallest, costs[d]);
      return smallest;
   }

   const PixelRows<Pixel>& pixels_;
   const Matching& matching_;
   int lanes_, above_, below_, before_, after_;
   int kept_;  ///< rows of pixel costs
   std::size_t row_size_;
   std::vector<PixelCost> rows_;  ///< [y % kept][x][d]
   std::vector<Sum> columns_;     ///< [x][d]: sums over the window's rows
   std::vector<Sum> window_;      ///< [d]
   int row_ = -1;                 ///< the next one; none yet
   int oldest_ = 0;               ///< the first row that has been taken in
};

}  // namespace stereo::semi_global
