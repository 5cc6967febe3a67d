// SPDX-License-Identifier: Apache-2.0
// The stages that families share, from docs/algorithm.md, one function a stage, for tests: plain loops and nothing
// shared with hls/ but the names of the options.
//
// Every stage takes the right image as reference: for a left one, give it the mirrored pair (definition/mirror.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "definition/disparity_map.hpp"
#include "definition/gray_image.hpp"
#include "support/matching_options.hpp"

namespace stereo {

/// With full_width: the sum of what is no candidate.
inline constexpr int kNoCandidate = std::numeric_limits<int>::max();

/// A value for every (x, y, d).
struct CostVolume {
   int width = 0;
   int height = 0;
   int disparities = 0;
   std::vector<int> values;

   CostVolume() = default;
   CostVolume(int width_px, int height_px, int disparity_range)
       : width(width_px),
         height(height_px),
         disparities(disparity_range),
         values(std::size_t(width_px) * std::size_t(height_px) * std::size_t(disparity_range)) {}

   int& at(int x, int y, int d) { return values[index(x, y, d)]; }
   int at(int x, int y, int d) const { return values[index(x, y, d)]; }

  private:
   std::size_t index(int x, int y, int d) const {
      return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(disparities) + std::size_t(d);
   }
};

/// Census transforms, one for each pixel: bit i is the i-th other pixel of the pattern in raster order.
struct CensusImage {
   int width = 0;
   int height = 0;
   std::vector<uint64_t> bits;

   uint64_t at(int x, int y) const { return bits[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// 1. f(x,y) = 0 ... 2*cap. In an image of one row, that row stands above and below itself.
GrayImage prefiltered(const GrayImage& image, int cap);
DeepImage prefiltered(const DeepImage& image, int cap);

/// 2. Pixels outside the image count as 0.
CensusImage census_transform(const GrayImage& image, int census_width_px, int census_height_px,
                             CensusPattern pattern = CensusPattern::all);
CensusImage census_transform(const DeepImage& image, int census_width_px, int census_height_px,
                             CensusPattern pattern = CensusPattern::all);

/// Sum of c over the rows y-B/2 ... y+(B-1)/2 of one column; rows outside the image count 0. Same size as c.
CostVolume column_sums(const CostVolume& costs, int window_px);

/// 3. S(x,y,d): sum of c over the window around (x,y); cost columns and rows outside count 0. As many columns as c.
CostVolume all_window_sums(const CostVolume& costs, int window_px);

/// The same for the columns of the map of block matching: one column less than c.
CostVolume window_sums(const CostVolume& costs, int window_px);

/// Disparities of which only first ... last are searched; d leads min + d columns to the right.
struct DisparityRange {
   int min, first, last;
};
/// 8. With full_width: what is not searched, or leads to none of the columns, is no candidate.
void keep_candidates(CostVolume& sums, const DisparityRange& range);
/// The columns of `sums` whose windows lie in the image. `sums` has all columns of the image. With candidates only.
CostVolume full_width_sums(const CostVolume& sums, int window_px, const DisparityRange& range);

/// 4. d*, in pixels, all valid but those without a candidate.
DisparityMap winners(const CostVolume& sums, Ties ties = Ties::smallest);

/// 5. D'(X), in pixels: column i is X = first_cost_column() + min_disparity + i of the other image. S's width + D-1
/// columns.
DisparityMap other_winners(const CostVolume& sums, Ties ties = Ties::smallest);

// 5. The checks: 1 where the pixel passes, else 0. `winners` are those of the same sums.
GrayImage left_right_check(const DisparityMap& winners, const DisparityMap& other_winners, int threshold);
GrayImage uniqueness_check(const CostVolume& sums, const DisparityMap& winners, int percent);
/// Semi-global matching's: no disparity but the winner and its neighbours comes closer than `distance`.
GrayImage distance_check(const CostVolume& sums, const DisparityMap& winners, int distance);

/// Pixels that do not pass a check are not valid.
void keep_passing(DisparityMap& map, const GrayImage& passes);

/// The checks that are on, of those that families share. `of_other`: the sums that have the other image's winners.
template <class Matching>
void keep_checked(DisparityMap& map, const CostVolume& sums, const DisparityMap& winners, const CostVolume& of_other,
                  const Matching& matching) {
   if (matching.has_left_right_check())
      keep_passing(map,
                   left_right_check(winners, other_winners(of_other, matching.ties), matching.left_right_threshold));
   if (!matching.has_uniqueness_check()) return;
   if constexpr (requires { matching.uniqueness_distance; })
      keep_passing(map, distance_check(sums, winners, matching.uniqueness_distance));
   else keep_passing(map, uniqueness_check(sums, winners, matching.uniqueness_percent));
}

/// 6. Sixteenths of a pixel, validity as in `winners`.
DisparityMap subpixel_disparities(const CostVolume& sums, const DisparityMap& winners);

/// 7. Disparities only; validity and unit stay.
DisparityMap median_filtered(const DisparityMap& map);

}  // namespace stereo
