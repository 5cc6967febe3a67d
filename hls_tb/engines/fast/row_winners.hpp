// SPDX-License-Identifier: Apache-2.0
// The winners of a row and their checks, from the sums of all disparities of a pixel side by side in memory: what the
// fast models of the families share. Loops run over whole vectors; what stands behind the last disparity is the largest
// number and never wins.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "definition/disparity_map.hpp"
#include "engines/fast/vector_clones.hpp"
#include "support/matching_options.hpp"

namespace stereo::fast {

/// What one pixel of the map follows from.
template <class Sum>
struct PixelResult {
   Sum smallest;
   int winner;
};

/// The other image's best sums and their disparities, of one row. [X - first column]
template <class Sum>
struct OtherWinners {
   std::vector<Sum> best, disparity;

   explicit OtherWinners(int columns) : best(std::size_t(columns)), disparity(best) {}
   /// Every sum is better than this, and what stands behind the last disparity is not.
   void restart() { std::fill(best.begin(), best.end(), Sum(std::numeric_limits<Sum>::max() - 1)); }
};

/// 0, 1, 2 ...: disparities as wide as sums, since one vector then holds as many of both.
template <class Sum>
inline constexpr auto kPlaces = [] {
   std::array<Sum, 256> places{};
   for (std::size_t d = 0; d < places.size(); ++d) places[d] = Sum(d);
   return places;
}();

/// Of up to 256 disparities.
template <class Sum>
STEREO_INTO_CLONES PixelResult<Sum> find_winner(const Sum* sums, int lanes, Ties ties) {
   constexpr Sum kMost = std::numeric_limits<Sum>::max();
   const Sum* const places = kPlaces<Sum>.data();
   Sum smallest = kMost;
   for (int d = 0; d < lanes; ++d) smallest = std::min(smallest, sums[d]);
   // Masks and named numbers: the compiler makes branches of choices, and of the values of calls.
   Sum first = kMost, last = 0;
   if (ties == Ties::smallest) {
      for (int d = 0; d < lanes; ++d) {
         const Sum loses = Sum(-int(sums[d] != smallest)), place = Sum(places[d] | loses);
         first = std::min(first, place);
      }
   } else {
      for (int d = 0; d < lanes; ++d) {
         const Sum wins = Sum(-int(sums[d] == smallest)), place = Sum(places[d] & wins);
         last = std::max(last, place);
      }
   }
   return {smallest, int(ties == Ties::smallest ? first : last)};
}

/// No disparity but the winner and its neighbours has a sum up to `wanted`, which is not below the smallest one.
template <class Sum>
STEREO_INTO_CLONES bool is_unique(const Sum* sums, int disparities, int lanes, PixelResult<Sum> pixel,
                                  uint64_t wanted) {
   const Sum limit = Sum(std::min<uint64_t>(wanted, std::numeric_limits<Sum>::max() - 1));
   Sum close = 0;
   for (int d = 0; d < lanes; ++d) close = Sum(close + (sums[d] <= limit ? 1 : 0));
   int near = 0;
   for (int d = std::max(pixel.winner - 1, 0); d <= std::min(pixel.winner + 1, disparities - 1); ++d)
      near += sums[d] <= limit ? 1 : 0;
   return int(close) == near;
}

/// How far the nearest disparity but the winner and its neighbours is, divided by 2^shift, `largest` at most. A sum of
/// what is no candidate is the largest number.
template <class Sum>
STEREO_INTO_CLONES uint8_t margin_of(const Sum* sums, int disparities, PixelResult<Sum> pixel, int shift, int largest) {
   constexpr Sum kMost = std::numeric_limits<Sum>::max();
   Sum second = kMost;
   for (int d = 0; d < pixel.winner - 1; ++d) second = std::min(second, sums[d]);
   for (int d = pixel.winner + 2; d < disparities; ++d) second = std::min(second, sums[d]);
   if (second == kMost) return uint8_t(largest);
   return uint8_t(std::min<int64_t>((int64_t(second) - int64_t(pixel.smallest)) >> shift, largest));
}

/// In sixteenths of a pixel.
template <class Sum>
STEREO_INTO_CLONES uint16_t refined(const Sum* sums, int disparities, PixelResult<Sum> pixel) {
   const int d = pixel.winner;
   if (d == 0 || d == disparities - 1) return uint16_t(16 * d);
   const int64_t u = int64_t(sums[d - 1]) - pixel.smallest, v = int64_t(sums[d + 1]) - pixel.smallest;
   const int64_t larger = std::max(u, v), offset = larger == 0 ? 0 : (u - v) * 128 / larger;
   return uint16_t((256 * d + offset + 15) >> 4);
}

/// What a pixel of the map is by its sums. `close`: the largest sum with which a runner-up is too close to the winner.
template <class Sum, class Matching>
STEREO_INTO_CLONES void settle(DisparityMap& map, int x, int y, const Sum* sums, int lanes, PixelResult<Sum> pixel,
                               uint64_t close, const Matching& matching) {
   const int disparities = matching.disparities;
   map.at(x, y) = matching.subpixel ? refined(sums, disparities, pixel) : uint16_t(pixel.winner);
   if (matching.has_uniqueness_check() && !is_unique(sums, disparities, lanes, pixel, close)) map.valid_at(x, y) = 0;
   if (matching.has_confidence())
      map.confidence_at(x, y) = margin_of(sums, disparities, pixel, matching.margin_shift, matching.kLargestMargin);
}

/// Offers the sums of map column x to the pixels x+d of the other image. Columns come from left to right, so that each
/// pixel sees its largest disparity first.
template <class Sum>
STEREO_INTO_CLONES void offer(OtherWinners<Sum>& other, int x, const Sum* __restrict sums, int lanes, Ties ties) {
   Sum* const __restrict best = other.best.data() + x;
   Sum* const __restrict disparity = other.disparity.data() + x;
   const Sum smaller_wins = ties == Ties::smallest ? 1 : 0;  // among equal sums
   const Sum* const places = kPlaces<Sum>.data();
   for (int d = 0; d < lanes; ++d) {
      const bool better = sums[d] < Sum(best[d] + smaller_wins);
      disparity[d] = better ? places[d] : disparity[d];
      best[d] = better ? sums[d] : best[d];
   }
}

}  // namespace stereo::fast
