// SPDX-License-Identifier: Apache-2.0
// The paths, all disparities of a pixel side by side in memory. Numbers that can be negative have a bias, so that lanes
// of 8 bits do where the penalties are small. Bytes may alias anything, so loops see no member of an object: the
// compiler would read it again for each byte that is written, and not vectorise.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "definition/semi_global/matching_input.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::semi_global {

/// Largest numbers of the paths: docs/algorithm.md has the bounds.
struct PathBounds {
   int largest_cost, lowest_path;  ///< K is -lowest_path ... largest_cost, A at most 2 largest_cost + P1
   int largest_arrived, largest_sum;
   int step_above, largest_step_above;  ///< from above, a penalty above P2 has the effect of P2

   explicit PathBounds(const Matching& matching) : largest_cost(largest_path_cost(matching)) {
      lowest_path = matching.p2 + std::max(0, largest_cost - matching.p1);
      largest_arrived = 2 * largest_cost + matching.p1;
      step_above = std::min(matching.p1_above(), matching.p2_above());
      largest_step_above = matching.p2_above() + step_above;
      largest_sum = 2 * (largest_cost + lowest_path) + largest_cost + matching.p2_above();
   }
   /// Unsigned lanes of so many bits hold them, and two larger numbers beside.
   bool fit(int bits) const {
      const int half = 1 << (bits - 1);
      return largest_arrived < half && lowest_path <= half && largest_sum < 2 * half - 2 &&
             largest_step_above < 2 * half - 2;
   }
};

/// The state of a row path behind one column, for all disparities. Fixed: the number of lanes, or 0 where it is known
/// only at run time.
template <class Lane, int Fixed>
class RowPathState {
  public:
   static constexpr Lane kBias = Lane(Lane(1) << (8 * sizeof(Lane) - 1)), kMost = std::numeric_limits<Lane>::max();

   RowPathState(const Matching& matching, int lanes)
       : matching_(matching), lanes_(lanes), look_back_(matching.look_back_columns()), first_(lanes), second_(lanes) {}

   STEREO_INTO_CLONES void start_row() {
      column_ = 0;
      since_ = 0;
   }

   /// Adds K + kBias of the next column, less `excess`, to the sums. relief: the fall of P2 on the way to it. The
   /// values of the column before are needed until the next ones are complete, so the two take turns.
   STEREO_INTO_CLONES void add_next(const Lane* __restrict costs, Lane smallest, int relief,
                                    const Lane* __restrict beyond, Lane excess, Lane* __restrict sums) {
      discount_[column_ % kHeld] = -relief;
      const Lane fresh = Lane(kBias - Lane(relief));
      const Lane g = Lane(smallest + next_start());
      const int lanes = Fixed > 0 ? Fixed : lanes_;
      State &from = column_ % 2 == 0 ? first_ : second_, &to = column_ % 2 == 0 ? second_ : first_;
      const Lane* const __restrict k = from.cost();
      const Lane* const __restrict a = from.arrived();
      Lane* const __restrict next_k = to.cost();
      Lane* const __restrict next_a = to.arrived();
      const Lane p1 = Lane(matching_.p1);
      Lane lowest = kMost;
      if (column_ == 0) {
         for (int d = 0; d < lanes; ++d) {
            const Lane change = Lane(costs[d] - g);
            next_k[d] = Lane(Lane(kBias + change) | beyond[d]);
            next_a[d] = Lane(Lane(kBias + p1) + change);
            sums[d] = Lane(sums[d] + Lane(next_k[d] - excess));
            lowest = std::min(lowest, next_k[d]);
         }
      } else {
         for (int d = 0; d < lanes; ++d) {
            const Lane change = Lane(costs[d] - g);
            const Lane stay = std::min(std::min(k[d], a[d]), fresh), step = std::min(k[d - 1], k[d + 1]);
            next_k[d] = Lane(Lane(stay + change) | beyond[d]);
            next_a[d] = Lane(Lane(step + p1) + change);
            sums[d] = Lane(sums[d] + Lane(next_k[d] - excess));
            lowest = std::min(lowest, next_k[d]);
         }
      }
      lowest_[column_ % kHeld] = int(lowest) - int(kBias);
      ++column_;
   }

  private:
   static constexpr int kHeld = 16;  ///< columns; more than look_back_ is at most

   /// Between values that never win.
   struct State {
      std::vector<Lane> costs, arrivals;

      explicit State(int lanes) : costs(std::size_t(lanes) + 2 * kBeside, kMost), arrivals(costs) {}
      STEREO_INTO_CLONES Lane* cost() { return costs.data() + kBeside; }
      STEREO_INTO_CLONES Lane* arrived() { return arrivals.data() + kBeside; }
      static constexpr int kBeside = 32;
   };

   /// q of this column.
   STEREO_INTO_CLONES int next_start() {
      int q = 0;
      if (column_ == 0) {
         q = matching_.p2;
      } else if (column_ >= look_back_) {
         since_ -= start_[(column_ - look_back_) % kHeld];
         int best = lowest_[(column_ - look_back_) % kHeld];
         if (matching_.has_relief())
            for (int i = column_ - look_back_ + 1; i <= column_; ++i) best = std::min(best, discount_[i % kHeld]);
         q = std::max(0, matching_.p2 + best - since_);
      }
      since_ += q;
      start_[column_ % kHeld] = q;
      return q;
   }

   const Matching& matching_;
   int lanes_, look_back_;
   State first_, second_;
   int column_ = 0;
   int since_ = 0;                               ///< the sum of the last look_back_ q
   int start_[kHeld] = {}, lowest_[kHeld] = {};  ///< [column % kHeld]: q, and the smallest K
   int discount_[kHeld] = {};                    ///< [column % kHeld]: f
};

/// The path from above: T of each column of the map, moved down a row at a time. Columns know nothing of each other.
template <class Lane, int Fixed>
class PathFromAbove {
  public:
   static constexpr Lane kMost = std::numeric_limits<Lane>::max();

   PathFromAbove(const Matching& matching, int columns, int lanes)
       : matching_(matching),
         lanes_(lanes),
         state_(std::size_t(columns) * std::size_t(lanes), Lane(matching.p2_above())),
         bounded_(std::size_t(columns) * std::size_t(lanes + kBeside) + kBeside, Lane(matching.p2_above())) {}

   /// total = sums + K of the path in map column x; kMost behind the last disparity.
   STEREO_INTO_CLONES void add(int x, const Lane* __restrict costs, const Lane* __restrict beyond,
                               const Lane* __restrict sums, Lane* __restrict total) {
      const int lanes = Fixed > 0 ? Fixed : lanes_;
      const Lane* const __restrict state = state_.data() + std::ptrdiff_t(x) * lanes;
      Lane* const __restrict bounded = bounded_.data() + std::ptrdiff_t(x) * (lanes + kBeside) + kBeside;
      Lane smallest = kMost;
      for (int d = 0; d < lanes; ++d) {
         const Lane path = Lane(Lane(state[d] + costs[d]) | beyond[d]);
         smallest = std::min(smallest, path);
      }
      const Lane p2 = Lane(matching_.p2_above());
      for (int d = 0; d < lanes; ++d) {
         const Lane path = Lane(Lane(state[d] + costs[d]) - smallest), all = Lane(path | beyond[d]);
         total[d] = Lane(Lane(sums[d] + path) | beyond[d]);
         bounded[d] = std::min(all, p2);
      }
   }

   /// Columns first ... end-1 have been added. Only now, since a vector that was written a moment ago cannot be read at
   /// another place without a long wait.
   STEREO_INTO_CLONES void next_row(int first, int end) {
      const int lanes = Fixed > 0 ? Fixed : lanes_;
      const Lane p1 = Lane(PathBounds(matching_).step_above);
      for (int x = first; x < end; ++x) {
         Lane* const __restrict state = state_.data() + std::ptrdiff_t(x) * lanes;
         const Lane* const __restrict bounded = bounded_.data() + std::ptrdiff_t(x) * (lanes + kBeside) + kBeside;
         for (int d = 0; d < lanes; ++d) {
            const Lane near = Lane(std::min(bounded[d - 1], bounded[d + 1]) + p1);
            state[d] = std::min(bounded[d], near);
         }
      }
   }

  private:
   static constexpr int kBeside = 32;
   const Matching& matching_;
   int lanes_;
   std::vector<Lane> state_;    ///< [x][d]: T
   std::vector<Lane> bounded_;  ///< [x][d]: min(K, P2), and beside each column values that never win
};

}  // namespace stereo::semi_global
