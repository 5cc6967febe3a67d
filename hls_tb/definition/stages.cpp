// SPDX-License-Identifier: Apache-2.0
#include "definition/stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace stereo {
namespace {

template <class Pixel>
bool inside(const RasterImage<Pixel>& image, int x, int y) {
   return x >= 0 && x < image.width && y >= 0 && y < image.height;
}

/// S of one pixel, for all d.
int smallest_sum(const CostVolume& sums, int x, int y) {
   int smallest = sums.at(x, y, 0);
   for (int d = 1; d < sums.disparities; ++d) smallest = std::min(smallest, sums.at(x, y, d));
   return smallest;
}

template <class Pixel>
RasterImage<Pixel> filtered_pixels(const RasterImage<Pixel>& image, int cap) {
   const auto slope = [&](int x, int y) {
      if (y < 0) y = std::min(1, image.height - 1);
      if (y >= image.height) y = std::max(image.height - 2, 0);
      return int(image.at(x + 1, y)) - int(image.at(x - 1, y));
   };
   RasterImage<Pixel> filtered(image.width, image.height, Pixel(cap));
   for (int y = 0; y < image.height; ++y)
      for (int x = 1; x < image.width - 1; ++x) {
         const int value = slope(x, y - 1) + 2 * slope(x, y) + slope(x, y + 1);
         filtered.at(x, y) = Pixel(std::clamp(value, -cap, cap) + cap);
      }
   return filtered;
}

template <class Pixel>
CensusImage transforms(const RasterImage<Pixel>& image, int census_width_px, int census_height_px,
                       CensusPattern pattern) {
   const auto is_compared = [pattern](int dx, int dy) {
      if (pattern == CensusPattern::even_columns) return dx % 2 == 0;
      if (pattern == CensusPattern::sparse) return dx % 2 == 0 && dy % 2 == 0;
      return pattern == CensusPattern::all || (dx % 2 == 0) == (dy % 2 == 0);
   };
   CensusImage census{image.width, image.height, {}};
   for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
         uint64_t bits = 0;
         int place = 0;
         for (int row = y - census_height_px / 2; row <= y + census_height_px / 2; ++row)
            for (int column = x - census_width_px / 2; column <= x + census_width_px / 2; ++column) {
               if ((row == y && column == x) || !is_compared(column - x, row - y)) continue;
               const int other = inside(image, column, row) ? image.at(column, row) : 0;
               if (other > image.at(x, y)) bits |= uint64_t(1) << place;
               ++place;
            }
         census.bits.push_back(bits);
      }
   return census;
}

}  // namespace

GrayImage prefiltered(const GrayImage& image, int cap) { return filtered_pixels(image, cap); }
DeepImage prefiltered(const DeepImage& image, int cap) { return filtered_pixels(image, cap); }

CensusImage census_transform(const GrayImage& image, int census_width_px, int census_height_px, CensusPattern pattern) {
   return transforms(image, census_width_px, census_height_px, pattern);
}
CensusImage census_transform(const DeepImage& image, int census_width_px, int census_height_px, CensusPattern pattern) {
   return transforms(image, census_width_px, census_height_px, pattern);
}

CostVolume column_sums(const CostVolume& costs, int window_px) {
   const int above = window_px / 2, below = (window_px - 1) / 2;
   CostVolume sums(costs.width, costs.height, costs.disparities);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int row = std::max(y - above, 0); row <= y + std::min(below, costs.height - 1 - y); ++row)
            for (int d = 0; d < sums.disparities; ++d) sums.at(x, y, d) += costs.at(x, row, d);
   return sums;
}

CostVolume all_window_sums(const CostVolume& costs, int window_px) {
   const int before = window_px / 2, after = (window_px - 1) / 2;
   const CostVolume columns = column_sums(costs, window_px);
   CostVolume sums(costs.width, costs.height, costs.disparities);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int column = std::max(x - before, 0); column <= x + std::min(after, costs.width - 1 - x); ++column)
            for (int d = 0; d < sums.disparities; ++d) sums.at(x, y, d) += columns.at(column, y, d);
   return sums;
}

CostVolume window_sums(const CostVolume& costs, int window_px) {
   const CostVolume all = all_window_sums(costs, window_px);
   CostVolume sums(costs.width - 1, costs.height, costs.disparities);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int d = 0; d < sums.disparities; ++d) sums.at(x, y, d) = all.at(x, y, d);
   return sums;
}

void keep_candidates(CostVolume& sums, const DisparityRange& range) {
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int d = 0; d < sums.disparities; ++d) {
            const int other = x + range.min + d;
            if (d < range.first || d > range.last || other < 0 || other >= sums.width) sums.at(x, y, d) = kNoCandidate;
         }
}

CostVolume full_width_sums(const CostVolume& sums, int window_px, const DisparityRange& range) {
   CostVolume searched(sums.width - window_px + 1, sums.height, sums.disparities);
   for (int y = 0; y < searched.height; ++y)
      for (int x = 0; x < searched.width; ++x)
         for (int d = 0; d < searched.disparities; ++d) searched.at(x, y, d) = sums.at(window_px / 2 + x, y, d);
   keep_candidates(searched, range);
   return searched;
}

DisparityMap winners(const CostVolume& sums, Ties ties) {
   DisparityMap map(sums.width, sums.height);
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x) {
         const int smallest = smallest_sum(sums, x, y);
         int d = ties == Ties::smallest ? 0 : sums.disparities - 1;
         while (sums.at(x, y, d) != smallest) d += ties == Ties::smallest ? 1 : -1;
         map.at(x, y) = uint16_t(d);
         map.valid_at(x, y) = smallest == kNoCandidate ? 0 : 1;
      }
   return map;
}

DisparityMap other_winners(const CostVolume& sums, Ties ties) {
   // With full_width some pixels of the other image have no candidate; no winner leads to them.
   DisparityMap map(sums.width + sums.disparities - 1, sums.height);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         int best = -1;
         for (int d = 0; d < sums.disparities; ++d) {
            if (x - d < 0 || x - d >= sums.width || sums.at(x - d, y, d) == kNoCandidate) continue;
            const int sum = sums.at(x - d, y, d), smallest = best < 0 ? sum : sums.at(x - best, y, best);
            if (best < 0 || sum < smallest || (sum == smallest && ties == Ties::largest)) best = d;
         }
         map.at(x, y) = uint16_t(std::max(best, 0));
      }
   return map;
}

GrayImage left_right_check(const DisparityMap& winners, const DisparityMap& other_winners, int threshold) {
   GrayImage passes(winners.width, winners.height);
   for (int y = 0; y < passes.height; ++y)
      for (int x = 0; x < passes.width; ++x) {
         const int d = winners.at(x, y), other = other_winners.at(x + d, y);
         passes.at(x, y) = std::abs(other - d) <= threshold ? 1 : 0;
      }
   return passes;
}

GrayImage uniqueness_check(const CostVolume& sums, const DisparityMap& winners, int percent) {
   GrayImage passes(sums.width, sums.height, 1);
   for (int y = 0; y < passes.height; ++y)
      for (int x = 0; x < passes.width; ++x) {
         const int winner = winners.at(x, y);
         const int64_t smallest = sums.at(x, y, winner), limit = smallest + percent * smallest / 100;
         for (int d = 0; d < sums.disparities; ++d)
            if (std::abs(d - winner) > 1 && sums.at(x, y, d) != kNoCandidate && sums.at(x, y, d) <= limit)
               passes.at(x, y) = 0;
      }
   return passes;
}

GrayImage distance_check(const CostVolume& sums, const DisparityMap& winners, int distance) {
   GrayImage passes(sums.width, sums.height, 1);
   for (int y = 0; y < passes.height; ++y)
      for (int x = 0; x < passes.width; ++x) {
         const int winner = winners.at(x, y), smallest = sums.at(x, y, winner);
         for (int d = 0; d < sums.disparities; ++d)
            if (std::abs(d - winner) > 1 && sums.at(x, y, d) != kNoCandidate && sums.at(x, y, d) - smallest < distance)
               passes.at(x, y) = 0;
      }
   return passes;
}

void keep_passing(DisparityMap& map, const GrayImage& passes) {
   for (std::size_t i = 0; i < map.valid.size(); ++i) map.valid[i] = map.valid[i] && passes.pixels[i] ? 1 : 0;
}

DisparityMap subpixel_disparities(const CostVolume& sums, const DisparityMap& winners) {
   DisparityMap map = winners;
   map.subpixel = true;
   const int last = sums.disparities - 1;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const int d = winners.at(x, y);
         int64_t offset = 0;  // in 256ths of a pixel; at an end of the range both neighbours are the same
         const auto is_searched = [&](int e) { return e >= 0 && e <= last && sums.at(x, y, e) != kNoCandidate; };
         if (is_searched(d - 1) && is_searched(d) && is_searched(d + 1)) {
            const int64_t u = int64_t(sums.at(x, y, d - 1)) - sums.at(x, y, d);
            const int64_t v = int64_t(sums.at(x, y, d + 1)) - sums.at(x, y, d);
            if (std::max(u, v) != 0) offset = (u - v) * 128 / std::max(u, v);
         }
         map.at(x, y) = uint16_t((256 * d + offset + 15) >> 4);
      }
   return map;
}

DisparityMap median_filtered(const DisparityMap& map) {
   DisparityMap filtered = map;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         std::array<uint16_t, 9> around{};
         std::size_t count = 0;
         for (int row = y - 1; row <= y + 1; ++row)
            for (int column = x - 1; column <= x + 1; ++column)
               around[count++] = map.at(std::clamp(column, 0, map.width - 1), std::clamp(row, 0, map.height - 1));
         std::sort(around.begin(), around.end());
         filtered.at(x, y) = around[4];
      }
   return filtered;
}

}  // namespace stereo
