// SPDX-License-Identifier: Apache-2.0
#include "definition/phase_correlation/reference_model.hpp"

#include <bit>

#include "definition/block_matching/matching_input.hpp"
#include "definition/mirror.hpp"
#include "definition/phase_correlation/matching_input.hpp"
#include "definition/postprocessing.hpp"

namespace stereo::phase_correlation {
namespace {

using Taps = std::array<int, 5>;
constexpr Taps kLow{0, 1, 2, 1, 0}, kEven{-1, 0, 2, 0, -1}, kOdd{-1, -2, 0, 2, 1};

/// The sum of s x s pixels.
template <class Image>
int box(const Image& image, int x, int y, int step) {
   int sum = 0;
   for (int j = 0; j < step; ++j)
      for (int i = 0; i < step; ++i) sum += image.at(x - i, y - j);
   return sum;
}

/// The product of a filter along x and one along y.
template <class Image>
int response(const Image& image, int x, int y, int step, const Taps& along_x, const Taps& along_y) {
   int sum = 0;
   for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i)
         sum +=
             along_x[std::size_t(i + 2)] * along_y[std::size_t(j + 2)] * box(image, x + i * step, y + j * step, step);
   return sum;
}

template <class Image>
std::array<int, 6> all_responses(const Image& image, int x, int y, int scale) {
   const int step = 1 << scale;
   const auto of = [&](const Taps& along_x, const Taps& along_y) {
      return response(image, x, y, step, along_x, along_y);
   };
   const int ee = of(kEven, kEven), oe = of(kOdd, kEven), eo = of(kEven, kOdd), oo = of(kOdd, kOdd);
   return {of(kEven, kLow), of(kOdd, kLow), ee - oo, oe + eo, ee + oo, oe - eo};
}

template <class Image>
CensusImage codes_of(const Image& image, int scales) {
   CensusImage codes{image.width, image.height, std::vector<uint64_t>(image.pixels.size())};
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
         for (int scale = 0; scale < scales; ++scale) {
            const int before = reach_before(scale), after = reach_after(scale);
            if (x < before || y < before || x + after >= image.width || y + after >= image.height) continue;
            const std::array<int, 6> parts = all_responses(image, x, y, scale);
            for (std::size_t bit = 0; bit < parts.size(); ++bit)
               if (parts[bit] > 0)
                  codes.bits[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] |=
                      uint64_t(1) << (6 * std::size_t(scale) + bit);
         }
   return codes;
}

template <class Image>
CostVolume costs_of(const Image& left, const Image& right, const Matching& matching) {
   const CensusImage l = codes_of(left, matching.phase_scales), r = codes_of(right, matching.phase_scales);
   const block_matching::Matching columns = matching.block_matching();
   const int first = block_matching::first_cost_column(columns);
   CostVolume costs(block_matching::cost_columns(left.width, columns), left.height, matching.disparities);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < costs.disparities; ++d) {
            const int right_x = first + x, left_x = right_x + matching.min_disparity + d;
            if (left_x < 0 || left_x >= left.width) continue;  // with full_width; of no candidate
            costs.at(x, y, d) = code_cost(r.at(right_x, y), l.at(left_x, y), matching.phase_scales);
         }
   return costs;
}

template <class Image>
DisparityMap match(const Image& left, const Image& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   if (matching.reference == Reference::left) {
      Matching of_mirror = matching;
      of_mirror.reference = Reference::right;
      return mirrored(match(mirrored(right), mirrored(left), of_mirror));
   }
   const CostVolume costs = costs_of(left, right, matching);
   const block_matching::Matching columns = matching.block_matching();
   const DisparityRange range{matching.min_disparity, matching.first_disparity, columns.last_searched()};
   const CostVolume sums = matching.full_width
                               ? full_width_sums(all_window_sums(costs, matching.window_px), matching.window_px, range)
                               : window_sums(costs, matching.window_px);
   const DisparityMap best = winners(sums, matching.ties);
   DisparityMap map = matching.subpixel ? subpixel_disparities(sums, best) : best;
   keep_checked(map, sums, best, sums, matching);
   map = post_processed(map, margins(sums, best, matching.margin_shift), matching);
   if (matching.median) map = median_filtered(map);
   return map;
}

}  // namespace

std::array<int, 6> responses(const GrayImage& image, int x, int y, int scale) {
   return all_responses(image, x, y, scale);
}
std::array<int, 6> responses(const DeepImage& image, int x, int y, int scale) {
   return all_responses(image, x, y, scale);
}

CensusImage phase_codes(const GrayImage& image, int scales) { return codes_of(image, scales); }
CensusImage phase_codes(const DeepImage& image, int scales) { return codes_of(image, scales); }

int code_cost(uint64_t a, uint64_t b, int scales) {
   int cost = 0;
   for (int scale = 0; scale < scales; ++scale) {
      const int weight = scales > 1 && scale == 0 ? 2 : 1;
      cost += weight * std::popcount((a ^ b) >> (6 * scale) & 63);
   }
   return cost;
}

CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}
CostVolume pixel_costs(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}

DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return match(left, right, matching);
}
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return match(left, right, matching);
}

}  // namespace stereo::phase_correlation
