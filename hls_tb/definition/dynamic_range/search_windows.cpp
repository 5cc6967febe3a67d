// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/search_windows.hpp"

#include <algorithm>
#include <cmath>

#include "definition/block_matching/reference_model.hpp"
#include "definition/phase_correlation/reference_model.hpp"

namespace stereo::dynamic_range {
namespace {

constexpr int kCoarseBlock = Matching::kBlock / Matching::kCoarse;

/// A coarse pixel counts if its own disparity is consistent, and that of two neighbours too.
bool counts(const DisparityMap& coarse, int x, int y, const NeighbourAgreement& agreement) {
   const auto agrees = [&](int u, int v, const Agreement& may) {
      if (u < 0 || v < 0 || u >= coarse.width || v >= coarse.height || !coarse.valid_at(u, v)) return false;
      const int difference = coarse.at(u, v) - coarse.at(x, y);
      return difference >= may.lowest && difference <= may.highest;
   };
   const int neighbours = agrees(x - 1, y, agreement.left) + agrees(x + 1, y, agreement.right) +
                          agrees(x, y - 1, agreement.above) + agrees(x, y + 1, agreement.below);
   return coarse.valid_at(x, y) && neighbours >= 2;
}

void join(std::optional<Range>& all, const Range& one) {
   all = all ? Range{std::min(all->low, one.low), std::max(all->high, one.high)} : one;
}

/// Y1, of either kind of image.
template <class Pixel>
RasterImage<Pixel> means(const RasterImage<Pixel>& image, int more_columns) {
   constexpr int kSide = Matching::kCoarse;
   RasterImage<Pixel> coarse(image.width / kSide + more_columns, image.height / kSide);
   for (int y = 0; y < coarse.height; ++y)
      for (int x = 0; x < coarse.width; ++x) {
         const int column = std::min(x, image.width / kSide - 1);
         int sum = 0;
         for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i) sum += image.at(kSide * column + i, kSide * y + j);
         coarse.at(x, y) = Pixel((sum + kSide * kSide / 2) / (kSide * kSide));
      }
   return coarse;
}

/// Y2, likewise.
template <class Image>
DisparityMap whole_range(const Image& left, const Image& right, const Matching& matching) {
   const Image coarse_left = means(left, matching.coarse_disparities());
   const Image coarse_right = means(right, matching.coarse_disparities());
   return matching.codes == Codes::phase
              ? phase_correlation::match_reference(coarse_left, coarse_right, matching.coarse_phase())
              : block_matching::match_reference(coarse_left, coarse_right, matching.coarse_census());
}

}  // namespace

GrayImage coarse_image(const GrayImage& image, int more_columns) { return means(image, more_columns); }
DeepImage coarse_image(const DeepImage& image, int more_columns) { return means(image, more_columns); }

DisparityMap coarse_map(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return whole_range(left, right, matching);
}
DisparityMap coarse_map(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return whole_range(left, right, matching);
}

Blocks<std::optional<Range>> block_ranges(const DisparityMap& coarse, const NeighbourAgreement& agreement) {
   Blocks<std::optional<Range>> ranges(coarse.width / kCoarseBlock, coarse.height / kCoarseBlock);
   for (int y = 0; y < coarse.height; ++y)
      for (int x = 0; x < coarse.width; ++x) {
         if (x / kCoarseBlock >= ranges.width || y / kCoarseBlock >= ranges.height) continue;
         const int first = Matching::kCoarse * coarse.at(x, y), last = first + Matching::kCoarse - 1;
         if (counts(coarse, x, y, agreement)) join(ranges.at(x / kCoarseBlock, y / kCoarseBlock), {first, last});
      }
   return ranges;
}

Targets search_targets(const Blocks<std::optional<Range>>& ranges, const Matching& matching) {
   constexpr int kSteps = Matching::kBlock;
   const int last = matching.last_base(), size = matching.window_disparities;
   Targets targets{Blocks<int>(ranges.width, ranges.height), Blocks<int>(ranges.width, ranges.height)};
   for (int band = 0; band < ranges.height; ++band) {
      int low = 0, high = std::min(size, last);
      for (int column = ranges.width - 1; column >= 0; --column) {
         std::optional<Range> around;
         for (int v = std::max(band - 1, 0); v <= std::min(band + 1, ranges.height - 1); ++v)
            for (int u = std::max(column - 1, 0); u <= std::min(column + 1, ranges.width - 1); ++u)
               if (ranges.at(u, v)) join(around, *ranges.at(u, v));
         if (around) {
            int below = std::clamp(around->low - Matching::kMargin, 0, last);
            int above = std::clamp(around->high + Matching::kMargin + 1 - size, 0, last);
            // So that a window that falls by 1 or rises by 3 a column arrives in time.
            if (column < ranges.width - 1) {
               below = std::min(below, low + kSteps * Matching::kFall);
               above = std::max(above, high - kSteps * Matching::kRise);
            }
            low = below;
            high = above;
         }
         targets.low.at(column, band) = low;
         targets.high.at(column, band) = high;
      }
   }
   return targets;
}

std::vector<int> window_bases(const Blocks<int>& targets, int y, int image_width, const Matching& matching) {
   const int band = std::min(y / Matching::kBlock, targets.height - 1);
   const int last_column = image_width - matching.window_disparities;
   std::vector<int> bases;
   for (int x = 0; x <= last_column; ++x) {
      const int goal = std::min(targets.at(std::min(x / Matching::kBlock, targets.width - 1), band), last_column - x);
      const int base = x == 0 ? goal : bases.back();
      if (x == 0) bases.push_back(goal);
      else if (goal >= base + Matching::kRise) bases.push_back(base + Matching::kRise);
      else if (goal < base) bases.push_back(base - Matching::kFall);
      else bases.push_back(base);
   }
   return bases;
}

}  // namespace stereo::dynamic_range
