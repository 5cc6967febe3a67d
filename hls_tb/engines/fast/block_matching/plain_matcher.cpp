// SPDX-License-Identifier: Apache-2.0
// Running column sums for every disparity, updated by one row in and one row out. Each loop over x is free of branches
// and calls, so that the compiler vectorises it; 3x3 and 5x5 windows fit 16-bit lanes.
#include "engines/fast/block_matching/plain_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/bands.hpp"
#include "engines/fast/block_matching/aligned_rows.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::block_matching {
namespace {

using Sum = uint16_t;
using Pair = AlignedPair<uint8_t>;

/// Loops run over whole vectors of this many columns: the compiler's code for a rest would cost as much as the body.
constexpr int kLanes = 32;

/// So many disparities are compared with each other before the smallest of them meets the best so far. In these
/// comparisons the disparity stands in the lowest bits of its cost, so that one minimum finds both.
constexpr int kGroup = 8;

/// |R(x) - L(x+d)|, given pointers to the pixels of one row.
struct RowCosts {
   const uint8_t* left;
   const uint8_t* right;
   Sum operator[](int x) const { return Sum(std::abs(left[x] - right[x])); }
};

/// Column sums of one disparity move down by a row.
STEREO_INTO_CLONES void exchange_rows(Sum* __restrict columns, int count, RowCosts in, RowCosts out) {
   for (int x = 0; x < count; ++x) columns[x] = Sum(columns[x] + in[x] - out[x]);
}

/// Compares windows of `Window` columns. rows[i]: the columns of disparity first + i.
template <int Window>
STEREO_INTO_CLONES void keep_smallest(Sum* __restrict best, Sum* __restrict winner, const Sum* const (&rows)[kGroup],
                                      int count, Sum first) {
   for (int x = 0; x < count; ++x) {
      Sum key = std::numeric_limits<Sum>::max();
      for (int i = 0; i < kGroup; ++i) {
         Sum total = rows[i][x];
         for (int j = 1; j < Window; ++j) total = Sum(total + rows[i][x + j]);
         key = std::min(key, Sum(total * kGroup + i));
      }
      const Sum disparity = Sum(first + key % kGroup), before = best[x], now = winner[x];
      const Sum after = std::min(Sum(key / kGroup), before);
      winner[x] = after == before ? now : disparity;
      best[x] = after;
   }
}

/// The side of the matching window is Window, odd.
template <int Window>
STEREO_INTO_CLONES void match_rows(const Pair& pair, int disparities, DisparityMap& map, int first_row, int end_row) {
   static_assert(kGroup * (255 * Window * Window + 1) <= std::numeric_limits<Sum>::max());
   // A window beyond the image adds nothing but zeros.
   constexpr int kRadius = Window / 2;
   const int count = (pair.columns + kLanes - 1) / kLanes * kLanes;
   const int stride = count + 2 * kRadius;  // with zeros on both sides
   const int beyond = std::min(kRadius, count - pair.columns);
   std::vector<Sum> sums(std::size_t(stride) * std::size_t(disparities));
   std::vector<Sum> best(static_cast<std::size_t>(count)), winner(best);

   const int oldest = std::max(first_row - kRadius, 0), none = -1;  // the first row that a window of this band sees
   for (int y = oldest - kRadius; y < end_row; ++y) {  // rows above the band only take in what lies below them
      const int row_out = y - kRadius - 1 < oldest ? none : y - kRadius - 1;
      std::fill(best.begin(), best.end(), std::numeric_limits<Sum>::max());
      for (int first = 0; first < disparities; first += kGroup) {
         const Sum* rows[kGroup];
         for (int i = 0; i < kGroup; ++i) {
            const int d = std::min(first + i, disparities - 1);  // a copy of the last one loses to it
            Sum* const padded = sums.data() + std::ptrdiff_t(d) * stride;
            Sum* const columns = padded + kRadius;
            const auto row = [&](int number) { return RowCosts{pair.left.row(number) + d, pair.right.row(number)}; };
            if (d == first + i) exchange_rows(columns, count, row(y + kRadius), row(row_out));
            std::fill_n(columns + pair.columns, beyond, Sum(0));
            rows[i] = padded;
         }
         keep_smallest<Window>(best.data(), winner.data(), rows, count, Sum(first));
      }
      if (y >= first_row) std::copy_n(winner.begin(), map.width, map.disparity.begin() + std::ptrdiff_t(y) * map.width);
   }
}

STEREO_VECTOR_CLONES void match_3x3(const Pair& pair, int disparities, DisparityMap& map, int first, int end) {
   match_rows<3>(pair, disparities, map, first, end);
}

STEREO_VECTOR_CLONES void match_5x5(const Pair& pair, int disparities, DisparityMap& map, int first, int end) {
   match_rows<5>(pair, disparities, map, first, end);
}

}  // namespace

bool is_plain(const Matching& matching) {
   return (matching.window_px == 3 || matching.window_px == 5) && matching.cost == Cost::sad &&
          matching.ties == Ties::smallest && !matching.has_left_right_check() && !matching.has_uniqueness_check() &&
          !matching.subpixel && !matching.full_width && !matching.has_confidence();
}

DisparityMap match_plain(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   const Pair pair(left.pixels, right.pixels, left.width, matching, kLanes);
   DisparityMap map(map_width(left.width, matching), left.height);
   const auto match = matching.window_px == 3 ? match_3x3 : match_5x5;
   fast::for_each_band(map.height, threads,
                       [&](int first, int end) { match(pair, matching.disparities, map, first, end); });
   return map;
}

}  // namespace stereo::block_matching
