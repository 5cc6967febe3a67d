// SPDX-License-Identifier: Apache-2.0
#include "definition/dynamic_range/reference_model.hpp"

#include <bit>

#include "definition/dynamic_range/matching_input.hpp"
#include "definition/phase_correlation/reference_model.hpp"
#include "definition/postprocessing.hpp"

namespace stereo::dynamic_range {
namespace {

/// What one search window gives: sums, their winners, and where they stand.
struct Track {
   CostVolume sums;
   DisparityMap best;     ///< lanes
   DisparityMap refined;  ///< lanes, in sixteenths with subpixel
   Blocks<int> bases;     ///< of each pixel of the map
};

/// Y6, Y7. A lane keeps its meaning within a sum: each pixel of the window is compared from its own base on.
Track follow(const CensusImage& left, const CensusImage& right, const Blocks<int>& targets, const Matching& matching) {
   const int lanes = matching.window_disparities;
   CostVolume costs(right.width - lanes + 1, right.height, lanes);
   Track track;
   track.bases = Blocks<int>(costs.width, costs.height);
   for (int y = 0; y < costs.height; ++y) {
      const std::vector<int> bases = window_bases(targets, y, right.width, matching);
      for (int x = 0; x < costs.width; ++x) {
         const int base = bases[std::size_t(x)];
         track.bases.at(x, y) = base;
         for (int i = 0; i < lanes; ++i)
            costs.at(x, y, i) = code_cost(right.at(x, y), left.at(x + base + i, y), matching);
      }
   }
   track.sums = window_sums(costs, matching.window_px);
   track.best = winners(track.sums);
   track.refined = matching.subpixel ? subpixel_disparities(track.sums, track.best) : track.best;
   return track;
}

template <class Image>
CensusImage any_codes(const Image& image, const Matching& matching) {
   return matching.codes == Codes::phase
              ? phase_correlation::phase_codes(image, matching.phase_scales)
              : census_transform(image, matching.census_width_px, matching.census_height_px, matching.census_pattern);
}

template <class Image>
DisparityMap with_targets(const Image& left, const Image& right, const Targets& targets, const Matching& matching) {
   const CensusImage l = any_codes(left, matching), r = any_codes(right, matching);
   const Track low = follow(l, r, targets.low, matching), high = follow(l, r, targets.high, matching);
   DisparityMap map(low.best.width, low.best.height, 0, matching.subpixel);
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         const bool far = high.sums.at(x, y, high.best.at(x, y)) >= low.sums.at(x, y, low.best.at(x, y));
         const Track& track = far ? low : high;
         map.at(x, y) = uint16_t(map.steps_per_pixel() * track.bases.at(x, y) + track.refined.at(x, y));
      }
   const GrayImage no_margins(map.width, map.height);
   map = post_processed(map, no_margins, matching);
   return matching.median ? median_filtered(map) : map;
}

template <class Image>
DisparityMap match(const Image& left, const Image& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   return with_targets(left, right, search_targets(block_ranges(coarse_map(left, right, matching)), matching),
                       matching);
}

}  // namespace

CensusImage codes_of(const GrayImage& image, const Matching& matching) { return any_codes(image, matching); }
CensusImage codes_of(const DeepImage& image, const Matching& matching) { return any_codes(image, matching); }

int code_cost(uint64_t a, uint64_t b, const Matching& matching) {
   return matching.codes == Codes::phase ? phase_correlation::code_cost(a, b, matching.phase_scales)
                                         : std::popcount(a ^ b);
}

DisparityMap match_with_targets(const DeepImage& left, const DeepImage& right, const Targets& targets,
                                const Matching& matching) {
   check_matching_input(left, right, matching);
   return with_targets(left, right, targets, matching);
}

DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   return match(left, right, matching);
}
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return match(left, right, matching);
}

}  // namespace stereo::dynamic_range
