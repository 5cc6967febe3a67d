// SPDX-License-Identifier: Apache-2.0
#include "engines/fast/dynamic_range/fast_model.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "definition/block_matching/models.hpp"
#include "definition/dynamic_range/matching_input.hpp"
#include "definition/dynamic_range/search_windows.hpp"
#include "definition/phase_correlation/models.hpp"
#include "definition/stages.hpp"
#include "engines/fast/bands.hpp"
#include "engines/fast/median.hpp"
#include "engines/fast/phase_correlation/phase_codes.hpp"
#include "engines/fast/postprocessing.hpp"

namespace stereo::dynamic_range {
namespace {

template <class Image>
DisparityMap fast_coarse_map(const Image& left, const Image& right, const Matching& matching, int threads) {
   const Image coarse_left = coarse_image(left, matching.coarse_disparities());
   const Image coarse_right = coarse_image(right, matching.coarse_disparities());
   return matching.codes == Codes::phase
              ? phase_correlation::match_fast(coarse_left, coarse_right, matching.coarse_phase(), threads)
              : block_matching::match_fast(coarse_left, coarse_right, matching.coarse_census(), threads);
}

/// The cost of two is the number of bits in which they differ.
template <class Image>
std::vector<uint64_t> weighted_codes(const Image& image, const Matching& matching) {
   return matching.codes == Codes::phase
              ? fast::weighted_phase_codes(image, matching.phase_scales)
              : census_transform(image, matching.census_width_px, matching.census_height_px, matching.census_pattern)
                    .bits;
}

/// One search window, row by row.
class Track {
  public:
   Track(std::span<const uint64_t> left, std::span<const uint64_t> right, int width, int height,
         const Blocks<int>& targets, const Matching& matching, int first_row)
       : left_(left),
         right_(right),
         width_(width),
         height_(height),
         lanes_(matching.window_disparities),
         cost_columns_(width - lanes_ + 1),
         before_(matching.window_px / 2),
         after_((matching.window_px - 1) / 2),
         column_sums_(std::size_t(cost_columns_) * std::size_t(lanes_)),
         sums_(column_sums_.size()) {
      for (int y = 0; y < height; y += Matching::kBlock) bases_.push_back(window_bases(targets, y, width, matching));
      for (int y = std::max(first_row - before_ - 1, 0); y < std::min(first_row + after_, height_); ++y) add_row(y, 1);
   }

   /// To be called for neighbouring rows, the first one being that of the constructor.
   void sum_row(int y) {
      if (y + after_ < height_) add_row(y + after_, 1);
      if (y - before_ - 1 >= 0) add_row(y - before_ - 1, -1);
      std::vector<int> running(std::size_t(lanes_), 0);
      for (int x = 0; x < after_ && x < cost_columns_; ++x) add_column(running, x, 1);
      for (int x = 0; x < cost_columns_ - 1; ++x) {
         if (x + after_ < cost_columns_) add_column(running, x + after_, 1);
         if (x - before_ - 1 >= 0) add_column(running, x - before_ - 1, -1);
         std::copy(running.begin(), running.end(), sums_.begin() + x * lanes_);
      }
   }

   std::span<const int> sums(int x) const {
      return std::span(sums_).subspan(std::size_t(x) * std::size_t(lanes_), std::size_t(lanes_));
   }
   int base(int x, int y) const { return bases_[std::size_t(y / Matching::kBlock)][std::size_t(x)]; }

  private:
   void add_row(int y, int sign) {
      const std::size_t row = std::size_t(y) * std::size_t(width_);
      for (int x = 0; x < cost_columns_; ++x) {
         const uint64_t code = right_[row + std::size_t(x)];
         const uint64_t* const others = &left_[row + std::size_t(x + base(x, y))];
         int* const sums = &column_sums_[std::size_t(x) * std::size_t(lanes_)];
         for (int i = 0; i < lanes_; ++i) sums[i] += sign * std::popcount(code ^ others[i]);
      }
   }
   void add_column(std::vector<int>& running, int x, int sign) const {
      const int* const column = &column_sums_[std::size_t(x) * std::size_t(lanes_)];
      for (int i = 0; i < lanes_; ++i) running[std::size_t(i)] += sign * column[i];
   }

   std::span<const uint64_t> left_, right_;
   int width_, height_, lanes_, cost_columns_, before_, after_;
   std::vector<std::vector<int>> bases_;  ///< [band][column]
   std::vector<int> column_sums_, sums_;
};

int in_sixteenths(std::span<const int> sums, int lane) {
   int offset = 0;
   if (lane > 0 && lane < int(sums.size()) - 1) {
      const int here = sums[std::size_t(lane)], u = sums[std::size_t(lane - 1)] - here,
                v = sums[std::size_t(lane + 1)] - here;
      if (std::max(u, v) > 0) offset = (u - v) * 128 / std::max(u, v);
   }
   return (256 * lane + offset + 15) >> 4;
}

uint16_t better(const Track& low, const Track& high, int x, int y, bool subpixel) {
   const std::span<const int> of_low = low.sums(x), of_high = high.sums(x);
   const auto best_low = std::min_element(of_low.begin(), of_low.end()),
              best_high = std::min_element(of_high.begin(), of_high.end());
   const bool takes_low = *best_high >= *best_low;
   const int base = (takes_low ? low : high).base(x, y);
   const int lane = takes_low ? int(best_low - of_low.begin()) : int(best_high - of_high.begin());
   return uint16_t(subpixel ? 16 * base + in_sixteenths(takes_low ? of_low : of_high, lane) : base + lane);
}

template <class Image>
DisparityMap match(const Image& left, const Image& right, const Matching& matching, int threads) {
   check_matching_input(left, right, matching);
   const Targets targets = search_targets(block_ranges(fast_coarse_map(left, right, matching, threads)), matching);
   const std::vector<uint64_t> l = weighted_codes(left, matching), r = weighted_codes(right, matching);
   DisparityMap map(left.width - matching.window_disparities, left.height, 0, matching.subpixel);
   fast::for_each_band(map.height, threads, [&](int first, int end) {
      Track low(l, r, left.width, left.height, targets.low, matching, first);
      Track high(l, r, left.width, left.height, targets.high, matching, first);
      for (int y = first; y < end; ++y) {
         low.sum_row(y);
         high.sum_row(y);
         for (int x = 0; x < map.width; ++x) map.at(x, y) = better(low, high, x, y, matching.subpixel);
      }
   });
   if (matching.has_confidence()) map.confidence.assign(map.valid.size(), 0);  // the windows tell no runner-up
   fast::post_process(map, Reference::right, matching, threads);
   return matching.median ? fast::median_3x3(map, threads) : map;
}

}  // namespace

DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}
DisparityMap match_fast(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}

}  // namespace stereo::dynamic_range
