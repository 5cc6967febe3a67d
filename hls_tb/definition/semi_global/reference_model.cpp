// SPDX-License-Identifier: Apache-2.0
#include "definition/semi_global/reference_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "definition/block_matching/reference_model.hpp"
#include "definition/mirror.hpp"
#include "definition/postprocessing.hpp"
#include "definition/semi_global/matching_input.hpp"

namespace stereo::semi_global {
namespace {

/// The smaller of the values at d-1 and d+1; where one of them does not exist, the other.
int smaller_neighbour(const std::vector<int>& values, int d) {
   const int last = int(values.size()) - 1;
   if (d == 0) return values[1];
   if (d == last) return values[std::size_t(last) - 1];
   return std::min(values[std::size_t(d) - 1], values[std::size_t(d) + 1]);
}

/// One row path, column after column.
class RowPath {
  public:
   explicit RowPath(const Matching& matching)
       : matching_(matching),
         look_back_(matching.look_back_columns()),
         cost_(std::size_t(matching.disparities)),
         arrived_(cost_) {}

   /// K of the next column: c is its costs, relief the fall of P2 on the way to it.
   const std::vector<int>& next(const std::vector<int>& c, int relief) {
      const int smallest = *std::min_element(c.begin(), c.end());
      discount_.push_back(-relief);
      start_.push_back(next_start());
      const int g = smallest + start_.back();
      const bool is_first = start_.size() == 1;
      std::vector<int> cost(c), arrived(c);
      for (int d = 0; d < int(c.size()); ++d) {
         const std::size_t i = std::size_t(d);
         const int stay = is_first ? 0 : std::min({-relief, cost_[i], arrived_[i]});
         const int step = is_first ? 0 : smaller_neighbour(cost_, d);
         cost[i] = c[i] - g + stay;
         arrived[i] = c[i] - g + matching_.p1 + step;
      }
      cost_ = cost;
      arrived_ = arrived;
      lowest_.push_back(*std::min_element(cost.begin(), cost.end()));
      return cost_;
   }

  private:
   /// q(i)
   int next_start() const {
      const int i = int(start_.size());
      if (i == 0) return matching_.p2;
      if (i < look_back_) return 0;
      int since = 0;
      for (int j = i - look_back_ + 1; j < i; ++j) since += start_[std::size_t(j)];
      const int cheapest = *std::min_element(discount_.end() - look_back_, discount_.end());
      const int best = std::min(cheapest, lowest_[std::size_t(i - look_back_)]);
      return std::max(0, matching_.p2 + best - since);
   }

   const Matching& matching_;
   int look_back_;
   std::vector<int> cost_, arrived_;  ///< K and A of the last column
   std::vector<int> start_, lowest_;  ///< q and the smallest K of all columns so far
   std::vector<int> discount_;        ///< f of all columns so far
};

std::vector<int> column_of(const CostVolume& volume, int x, int y) {
   std::vector<int> values;
   for (int d = 0; d < volume.disparities; ++d) values.push_back(volume.at(x, y, d));
   return values;
}

DisparityRange range_of(const Matching& matching) {
   return {matching.min_disparity, matching.first_disparity, matching.window_costs().last_searched()};
}

/// Either kind of image.
template <class Image>
CostVolume costs_of(const Image& left, const Image& right, const Matching& matching) {
   const CostVolume pixels = block_matching::pixel_costs(left, right, matching.window_costs());
   CostVolume costs = all_window_sums(pixels, matching.window_px);
   if (matching.full_width) costs = full_width_sums(costs, matching.window_px, range_of(matching));
   const DisparityRange range = range_of(matching);
   for (int y = 0; y < costs.height; ++y)
      for (int x = 0; x < costs.width; ++x)
         for (int d = 0; d < costs.disparities; ++d) {
            int& value = costs.at(x, y, d);
            const bool is_beyond_border = matching.has_border_cost() && d >= range.first && d <= range.last;
            if (value != kNoCandidate) value = std::min(value >> matching.cost_shift, matching.cost_cap);
            else if (is_beyond_border) value = std::min(matching.border_cost, largest_path_cost(matching));
            else value = largest_path_cost(matching);
         }
   return costs;
}

/// With a border cost: all that is searched takes part, wherever it leads.
void keep_searched(CostVolume& sums, const DisparityRange& range) {
   for (int y = 0; y < sums.height; ++y)
      for (int x = 0; x < sums.width; ++x)
         for (int d = 0; d < sums.disparities; ++d)
            if (d < range.first || d > range.last) sums.at(x, y, d) = kNoCandidate;
}

/// 1 where the winner leads to a column of the map.
GrayImage partner_check(const DisparityMap& winners, const DisparityRange& range) {
   GrayImage passes(winners.width, winners.height);
   for (int y = 0; y < passes.height; ++y)
      for (int x = 0; x < passes.width; ++x) {
         const int partner = x + range.min + winners.at(x, y);
         passes.at(x, y) = partner >= 0 && partner < winners.width ? 1 : 0;
      }
   return passes;
}

template <class Image>
DisparityMap matched(const Image& left, const Image& right, const Matching& matching) {
   check_matching_input(left, right, matching);
   if (matching.reference == Reference::left)
      return mirrored(matched(mirrored(right), mirrored(left), mirrored(matching)));
   CostVolume sums = path_sums(costs_of(left, right, matching), reliefs(right, matching), matching);
   CostVolume candidates = sums;  // of the other image's pixels
   if (matching.full_width) keep_candidates(candidates, range_of(matching));
   if (matching.has_border_cost()) keep_searched(sums, range_of(matching));
   else sums = candidates;
   const DisparityMap best = winners(sums, matching.ties);
   DisparityMap map = matching.subpixel ? subpixel_disparities(sums, best) : best;
   if (matching.has_border_cost()) keep_passing(map, partner_check(best, range_of(matching)));
   keep_checked(map, sums, best, candidates, matching);
   map = post_processed(map, margins(sums, best, matching.margin_shift), matching);
   if (matching.median) map = median_filtered(map);
   return map;
}

}  // namespace

CostVolume path_costs(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   if (matching.pixel_bits > 8) return costs_of(widened(left), widened(right), matching);
   return costs_of(left, right, matching);
}
CostVolume path_costs(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return costs_of(left, right, matching);
}

CostVolume row_path(const CostVolume& costs, const DeepImage& relief, RowDirection direction,
                    const Matching& matching) {
   CostVolume path(costs.width, costs.height, costs.disparities);
   for (int y = 0; y < costs.height; ++y) {
      RowPath row(matching);
      for (int i = 0; i < costs.width; ++i) {
         const bool from_left = direction == RowDirection::from_left;
         const int x = from_left ? i : costs.width - 1 - i;
         const int fall = i == 0 ? 0 : relief.at(from_left ? x : x + 1, y);
         const std::vector<int>& cost = row.next(column_of(costs, x, y), fall);
         for (int d = 0; d < costs.disparities; ++d) path.at(x, y, d) = cost[std::size_t(d)];
      }
   }
   return path;
}

CostVolume path_from_above(const CostVolume& costs, const Matching& matching) {
   const int p1 = matching.p1_above(), p2 = matching.p2_above();
   CostVolume path(costs.width, costs.height, costs.disparities);
   for (int x = 0; x < costs.width; ++x) {
      std::vector<int> from_above(std::size_t(costs.disparities), p2);  // T(x,y,d)
      for (int y = 0; y < costs.height; ++y) {
         std::vector<int> total = column_of(costs, x, y);
         for (std::size_t d = 0; d < total.size(); ++d) total[d] += from_above[d];
         const int smallest = *std::min_element(total.begin(), total.end());
         std::vector<int> bounded;
         for (int d = 0; d < costs.disparities; ++d) {
            path.at(x, y, d) = total[std::size_t(d)] - smallest;
            bounded.push_back(std::min(path.at(x, y, d), p2));
         }
         for (int d = 0; d < costs.disparities; ++d)
            from_above[std::size_t(d)] = std::min(bounded[std::size_t(d)], smaller_neighbour(bounded, d) + p1);
      }
   }
   return path;
}

CostVolume path_sums(const CostVolume& costs, const DeepImage& relief, const Matching& matching) {
   CostVolume sums(costs.width, costs.height, costs.disparities);
   const auto add = [&sums](const CostVolume& path) {
      std::transform(path.values.begin(), path.values.end(), sums.values.begin(), sums.values.begin(), std::plus<>());
   };
   if (matching.path_left) add(row_path(costs, relief, RowDirection::from_left, matching));
   if (matching.path_right) add(row_path(costs, relief, RowDirection::from_right, matching));
   if (matching.path_above) add(path_from_above(costs, matching));
   return sums;
}

DisparityMap match_reference(const GrayImage& left, const GrayImage& right, const Matching& matching) {
   // What the prefilter gives may need the bits that the pixels do not.
   if (matching.pixel_bits > 8) return matched(widened(left), widened(right), matching);
   return matched(left, right, matching);
}
DisparityMap match_reference(const DeepImage& left, const DeepImage& right, const Matching& matching) {
   return matched(left, right, matching);
}

}  // namespace stereo::semi_global
