// SPDX-License-Identifier: Apache-2.0
#include "definition/trellis/reference_model.hpp"

#include <algorithm>

#include "definition/mirror.hpp"
#include "definition/postprocessing.hpp"
#include "definition/semi_global/matching_input.hpp"
#include "definition/semi_global/reference_model.hpp"
#include "definition/trellis/matching_input.hpp"

namespace stereo::trellis {

namespace {

/// Either kind of image.
template <class Image>
CostVolume costs_of(const Image& left, const Image& right, const Matching& matching) {
   const CostVolume mirror = semi_global::path_costs(stereo::mirrored(right), stereo::mirrored(left),
                                                     semi_global::mirrored(matching.path_costs()));
   CostVolume costs(mirror.width, mirror.height, mirror.disparities);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < costs.disparities; ++d) costs.at(x, y, d) = mirror.at(costs.width - 1 - x, y, d);
   return costs;
}

}  // namespace

CostVolume left_costs(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   if (matching.pixel_bits > 8) return costs_of(widened(left), widened(right), matching);
   return costs_of(left, right, matching);
}
CostVolume left_costs(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}

Row forward(const CostVolume& costs, int y, const Matching& matching) {
   const int states = costs.disparities;
   Row row;
   std::vector<int> dropped, far;  // P of the column before, and whether its drop was a far one
   for (int x = 0; x < costs.width; ++x) {
      std::vector<int> path, decision, next_dropped, next_far;
      for (int d = 0; d < states; ++d) {
         const int c = costs.at(x, y, d);
         if (x == 0) {
            path.push_back(c);
            decision.push_back(0);
            next_dropped.push_back(c + matching.drop_cost);
            next_far.push_back(0);
            continue;
         }
         const std::vector<int>& before = row.path.back();
         const auto e = [&before](int state) { return before[std::size_t(state)]; };
         const int near = e(std::min(d + 1, states - 1));
         const int beyond = d + matching.far_drop < states ? e(d + matching.far_drop) : near;
         next_far.push_back(beyond < near);
         next_dropped.push_back(std::min(near, beyond) + matching.drop_cost + c);

         const int p = dropped[std::size_t(d)];
         int best = std::min(e(d), p) + c;
         int code = e(d) <= p ? 0 : 1 + far[std::size_t(d)];
         if (d > 0 && e(d - 1) + matching.occlusion_cost < best) {
            best = e(d - 1) + matching.occlusion_cost;
            code = 3;
         }
         path.push_back(best);
         decision.push_back(code);
      }
      row.path.push_back(path);
      row.decision.push_back(decision);
      dropped = next_dropped;
      far = next_far;
   }
   return row;
}

std::vector<int> traced_back(const Row& row, const Matching& matching) {
   const std::vector<int>& last = row.path.back();
   int state = int(std::min_element(last.begin(), last.end()) - last.begin());
   int falls = 0;  // the drop that is under way
   std::vector<int> disparities(row.path.size());
   for (std::size_t x = row.path.size(); x-- > 0;) {
      const int decision = falls == 0 ? row.decision[x][std::size_t(state)] : 0;
      disparities[x] = decision == 3 ? kNoPartner : state;
      if (falls == 1) state += 1;
      if (falls == 2) state += matching.far_drop;
      if (decision == 3) state -= 1;
      falls = decision == 1 || decision == 2 ? decision : 0;
   }
   return disparities;
}

std::vector<int> filled(std::vector<int> disparities) {
   int left = 0;
   for (int& disparity : disparities) {
      if (disparity == kNoPartner) disparity = left;
      left = disparity;
   }
   return disparities;
}

namespace {

template <class Image>
DisparityMap matched(const Image& left, const Image& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   const CostVolume costs = left_costs(left, right, matching);
   DisparityMap map(costs.width, costs.height);
   for (int y = 0; y < map.height; ++y) {
      const std::vector<int> found = traced_back(forward(costs, y, matching), matching), shown = filled(found);
      for (int x = 0; x < map.width; ++x) {
         map.at(x, y) = uint16_t(shown[std::size_t(x)]);
         map.valid_at(x, y) = matching.mark_occluded && found[std::size_t(x)] == kNoPartner ? 0 : 1;
      }
   }
   const GrayImage no_margins(map.width, map.height);
   map = mirrored(post_processed(mirrored(map), no_margins, matching));  // its reference is the right image
   return matching.median ? median_filtered(map) : map;
}

}  // namespace

DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   // What the prefilter gives may need the bits that the pixels do not.
   if (matching.pixel_bits > 8) return matched(widened(left), widened(right), matching);
   return matched(left, right, matching);
}
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return matched(left, right, matching);
}

}  // namespace stereo::trellis
