// SPDX-License-Identifier: Apache-2.0
#include "definition/block_matching/reference_model.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>

#include "definition/block_matching/matching_input.hpp"
#include "definition/mirror.hpp"
#include "definition/postprocessing.hpp"

namespace stereo::block_matching {
namespace {

template <class Pixel>
CostVolume costs_of(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   const bool filters = matching.prefilter == Prefilter::xsobel, is_census = matching.cost == Cost::census;
   const RasterImage<Pixel> l = filters ? prefiltered(left, matching.prefilter_cap) : left;
   const RasterImage<Pixel> r = filters ? prefiltered(right, matching.prefilter_cap) : right;
   const int census_width = matching.census_width_px, census_height = matching.census_height_px;
   const auto bits_of = [&](const RasterImage<Pixel>& image) {
      return is_census ? census_transform(image, census_width, census_height, matching.census_pattern) : CensusImage();
   };
   const CensusImage left_bits = bits_of(l), right_bits = bits_of(r);

   const int first = first_cost_column(matching);
   CostVolume costs(cost_columns(left.width, matching), left.height, matching.disparities);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < costs.disparities; ++d) {
            const int right_x = first + x, left_x = right_x + matching.min_disparity + d;
            if (left_x < 0 || left_x >= left.width) continue;  // with full_width; of no candidate
            const int difference = std::abs(int(r.at(right_x, y)) - int(l.at(left_x, y)));
            costs.at(x, y, d) = is_census ? std::popcount(right_bits.at(right_x, y) ^ left_bits.at(left_x, y))
                                : matching.cost == Cost::ssd ? difference * difference
                                                             : difference;
         }
   return costs;
}

template <class Pixel>
GrayImage has_texture(const RasterImage<Pixel>& filtered, const Matching& matching) {
   const int columns = cost_columns(filtered.width, matching), first = first_cost_column(matching);
   const int first_centre = matching.full_width ? rows_above(matching) : 0;
   GrayImage passes(map_width(filtered.width, matching), filtered.height);
   for (int y = 0; y < passes.height; ++y)
      for (int x = 0; x < passes.width; ++x) {
         int64_t texture = 0;
         const int centre = first_centre + x;
         for (int row = y - rows_above(matching); row <= y + rows_below(matching); ++row)
            for (int column = centre - rows_above(matching); column <= centre + rows_below(matching); ++column) {
               if (row < 0 || row >= filtered.height || column < 0 || column >= columns) continue;
               texture += std::abs(filtered.at(first + column, row) - matching.prefilter_cap);
            }
         passes.at(x, y) = texture >= matching.texture_threshold ? 1 : 0;
      }
   return passes;
}

template <class Pixel>
DisparityMap match(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   if (matching.reference == Reference::left) {
      Matching of_mirror = matching;
      of_mirror.reference = Reference::right;
      return mirrored(match(mirrored(right), mirrored(left), of_mirror));
   }
   const CostVolume costs = costs_of(left, right, matching);
   const DisparityRange range{matching.min_disparity, matching.first_disparity, matching.last_searched()};
   const CostVolume sums = matching.full_width
                               ? full_width_sums(all_window_sums(costs, matching.window_px), matching.window_px, range)
                               : window_sums(costs, matching.window_px);
   const DisparityMap best = winners(sums, matching.ties);
   DisparityMap map = matching.subpixel ? subpixel_disparities(sums, best) : best;
   keep_checked(map, sums, best, sums, matching);
   if (matching.has_texture_check())
      keep_passing(map, has_texture(prefiltered(right, matching.prefilter_cap), matching));
   map = post_processed(map, margins(sums, best, matching.margin_shift), matching);
   if (matching.median) map = median_filtered(map);
   return map;
}

}  // namespace

CostVolume pixel_costs(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}
CostVolume pixel_costs(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}

GrayImage texture_check(const GrayImage& filtered, const Matching& matching) { return has_texture(filtered, matching); }
GrayImage texture_check(const DeepImage& filtered, const Matching& matching) { return has_texture(filtered, matching); }

DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   // What the prefilter gives may need the bits that the pixels do not.
   if (matching.pixel_bits > 8) return match(widened(left), widened(right), matching);
   return match(left, right, matching);
}
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return match(left, right, matching);
}

}  // namespace stereo::block_matching
