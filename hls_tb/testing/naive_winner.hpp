// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "support/matching_options.hpp"

namespace stereo::test {

/// docs/algorithm.md, 4. to 6.: what is asked of the costs of one window.
struct NaiveWinner {
   int index = -1;
   int cost = 0;
   int second = -1;             ///< smallest cost that is not the winner's or beside it; -1: there is none
   int below = -1, above = -1;  ///< costs beside the winner; -1: beyond the range

   NaiveWinner() = default;
   NaiveWinner(const std::vector<int>& costs, Ties ties) : cost(*std::min_element(costs.begin(), costs.end())) {
      const int count = int(costs.size());
      for (int d = 0; d < count; ++d)
         if (costs[std::size_t(d)] == cost && (index < 0 || ties == Ties::largest)) index = d;
      for (int d = 0; d < count; ++d)
         if (std::abs(d - index) > 1 && (second < 0 || costs[std::size_t(d)] < second)) second = costs[std::size_t(d)];
      if (index > 0) below = costs[std::size_t(index - 1)];
      if (index < count - 1) above = costs[std::size_t(index + 1)];
   }
};

/// Calls check(costs) for all costs 0 ... levels-1 of `count` disparities.
template <class Check>
void for_all_costs(int count, int levels, Check check) {
   std::vector<int> costs(std::size_t(count), 0);
   while (true) {
      check(costs);
      std::size_t i = 0;
      while (i < costs.size() && ++costs[i] == levels) costs[i++] = 0;
      if (i == costs.size()) return;
   }
}

}  // namespace stereo::test
