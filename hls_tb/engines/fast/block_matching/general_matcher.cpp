// SPDX-License-Identifier: Apache-2.0
// Window sums as running sums of running column sums, for all disparities of a pixel side by side in memory: each loop
// over d is free of branches and calls, so that the compiler vectorises it. The time does not depend on the window.
#include "engines/fast/block_matching/general_matcher.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "definition/block_matching/matching_input.hpp"
#include "engines/fast/bands.hpp"
#include "engines/fast/block_matching/aligned_rows.hpp"
#include "engines/fast/census.hpp"
#include "engines/fast/row_winners.hpp"
#include "engines/fast/vector_clones.hpp"

namespace stereo::block_matching {
namespace {

using fast::OtherWinners;
using fast::PixelResult;

/// Loops run over whole vectors of this many disparities; what stands behind the last disparity never wins.
constexpr int kLanes = 16;

struct AbsoluteDifference {
   static int cost(int left, int right) { return std::abs(left - right); }
};
struct SquaredDifference {
   static int cost(int left, int right) { return (left - right) * (left - right); }
};
struct HammingDistance {
   static int cost(uint64_t left, uint64_t right) { return std::popcount(left ^ right); }
};

/// The pixels that one cost column compares in one row.
template <class Pixel>
struct Compared {
   const Pixel* left;  ///< [d]
   Pixel right;
};

/// Column sums of one cost column move down by a row.
template <class Difference, class Sum, class Pixel>
STEREO_INTO_CLONES void exchange_rows(Sum* __restrict column, Compared<Pixel> in, Compared<Pixel> out, int lanes) {
   for (int d = 0; d < lanes; ++d)
      column[d] =
          Sum(column[d] + Sum(Difference::cost(in.left[d], in.right)) - Sum(Difference::cost(out.left[d], out.right)));
}

template <class Sum>
STEREO_INTO_CLONES void add_column(Sum* __restrict sums, const Sum* __restrict column, int lanes) {
   for (int d = 0; d < lanes; ++d) sums[d] = Sum(sums[d] + column[d]);
}
template <class Sum>
STEREO_INTO_CLONES void remove_column(Sum* __restrict sums, const Sum* __restrict column, int lanes) {
   for (int d = 0; d < lanes; ++d) sums[d] = Sum(sums[d] - column[d]);
}

template <class Difference, class Sum, class Pixel>
struct Matcher {
   Matcher(const AlignedPair<Pixel>& aligned, const Matching& options, int padded, DisparityMap& result)
       : pair(aligned),
         matching(options),
         lanes(padded),
         before(std::min(rows_above(options), aligned.columns - 1)),
         after(std::min(rows_below(options), aligned.columns - 1)),
         columns(std::size_t(aligned.columns) * std::size_t(padded)),
         sums(std::size_t(padded)),
         searched(options.full_width ? std::size_t(padded) : 0),
         winners(std::size_t(result.width)),
         other(aligned.columns + padded),
         map(result) {}

   STEREO_INTO_CLONES Sum* column(int x) { return columns.data() + std::ptrdiff_t(x) * lanes; }

   STEREO_INTO_CLONES void move_window_down(int row_in, int row_out) {
      const auto compared = [&](int x, int y) { return Compared<Pixel>{pair.left.row(y) + x, pair.right.row(y)[x]}; };
      for (int x = 0; x < pair.columns; ++x)
         exchange_rows<Difference>(column(x), compared(x, row_in), compared(x, row_out), lanes);
   }

   STEREO_INTO_CLONES void match_row(int y) {
      other.restart();
      std::fill(sums.begin(), sums.end(), Sum(0));
      for (int x = 0; x < after; ++x) add_column(sums.data(), column(x), lanes);
      const int first_centre = matching.full_width ? rows_above(matching) : 0;  // of the map's first column
      for (int centre = 0; centre < first_centre + map.width; ++centre) {
         if (centre + after < pair.columns) add_column(sums.data(), column(centre + after), lanes);
         if (centre - before > 0) remove_column(sums.data(), column(centre - before - 1), lanes);
         std::fill(sums.begin() + matching.disparities, sums.end(), std::numeric_limits<Sum>::max());
         const int x = centre - first_centre;
         if (x < 0) continue;
         if (matching.full_width) match_part(x, y);
         else match_pixel(x, y, sums);
      }
      if (matching.has_left_right_check()) check_left_right(y);
   }

   /// With full_width: only those candidates are searched that lead to a window in the other image.
   STEREO_INTO_CLONES void match_part(int x, int y) {
      const SearchedRange of_x = searched_range(x, map.width, matching);
      std::fill(searched.begin(), searched.end(), std::numeric_limits<Sum>::max());
      if (of_x.last < of_x.first) {
         const int d = matching.ties == Ties::smallest ? 0 : matching.disparities - 1;
         winners[std::size_t(x)] = d;
         map.at(x, y) = uint16_t(matching.subpixel ? 16 * d : d);
         map.valid_at(x, y) = 0;
         return;
      }
      std::copy(sums.begin() + of_x.first, sums.begin() + of_x.last + 1, searched.begin() + of_x.first);
      match_pixel(x, y, searched);
      const int winner = winners[std::size_t(x)];
      if (matching.subpixel && (winner == of_x.first || winner == of_x.last)) map.at(x, y) = uint16_t(16 * winner);
   }

   STEREO_INTO_CLONES void match_pixel(int x, int y, const std::vector<Sum>& of_pixel) {
      if (matching.has_left_right_check()) fast::offer(other, x, of_pixel.data(), lanes, matching.ties);
      const PixelResult<Sum> pixel = fast::find_winner(of_pixel.data(), lanes, matching.ties);
      winners[std::size_t(x)] = pixel.winner;
      fast::settle(map, x, y, of_pixel.data(), lanes, pixel, close_sum(pixel.smallest), matching);
   }

   /// The largest sum that is too close to the smallest one.
   STEREO_INTO_CLONES uint64_t close_sum(uint64_t smallest) const {
      return smallest + uint64_t(matching.uniqueness_percent) * smallest / 100;
   }

   STEREO_INTO_CLONES void check_left_right(int y) {
      for (int x = 0; x < map.width; ++x) {
         const int winner = winners[std::size_t(x)], back = int(other.disparity[std::size_t(x + winner)]);
         if (std::abs(back - winner) > matching.left_right_threshold) map.valid_at(x, y) = 0;
      }
   }

   const AlignedPair<Pixel>& pair;
   const Matching& matching;
   int lanes, before, after;   ///< columns of the window before and after its centre's
   std::vector<Sum> columns;   ///< [x][d]: sums over the window's rows
   std::vector<Sum> sums;      ///< [d]: sums over the window
   std::vector<Sum> searched;  ///< [d]: those of candidates, with full_width
   std::vector<int> winners;   ///< [x]: of this row
   OtherWinners<Sum> other;
   DisparityMap& map;
};

template <class Difference, class Sum, class Pixel>
STEREO_INTO_CLONES void match_rows(const AlignedPair<Pixel>& pair, const Matching& matching, DisparityMap& map,
                                   int first, int end) {
   const int lanes = (matching.disparities + kLanes - 1) / kLanes * kLanes;
   Matcher<Difference, Sum, Pixel> matcher(pair, matching, lanes, map);
   const int above = std::min(rows_above(matching), map.height - 1);
   const int below = std::min(rows_below(matching), map.height - 1);
   const int oldest = std::max(first - above, 0), none = -1;  // the first row that a window of this band sees
   for (int y = oldest - below; y < end; ++y) {               // rows above the band only take in what lies below them
      const int row_out = y - above - 1;
      matcher.move_window_down(y + below, row_out < oldest ? none : row_out);
      if (y >= first) matcher.match_row(y);
   }
}

using Bytes = AlignedPair<uint8_t>;
using Shorts = AlignedPair<uint16_t>;
using Words = AlignedPair<uint64_t>;

STEREO_VECTOR_CLONES void match_sad_16(const Bytes& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<AbsoluteDifference, uint16_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_sad_32(const Bytes& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<AbsoluteDifference, uint32_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_ssd_32(const Bytes& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<SquaredDifference, uint32_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_sad_16(const Shorts& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<AbsoluteDifference, uint16_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_sad_32(const Shorts& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<AbsoluteDifference, uint32_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_ssd_32(const Shorts& pair, const Matching& matching, DisparityMap& map, int first,
                                       int end) {
   match_rows<SquaredDifference, uint32_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_census_16(const Words& pair, const Matching& matching, DisparityMap& map, int first,
                                          int end) {
   match_rows<HammingDistance, uint16_t>(pair, matching, map, first, end);
}
STEREO_VECTOR_CLONES void match_census_32(const Words& pair, const Matching& matching, DisparityMap& map, int first,
                                          int end) {
   match_rows<HammingDistance, uint32_t>(pair, matching, map, first, end);
}

/// Every window sum, and one more for OtherWinners, is below the largest 16-bit number.
bool fits_16_bits(int width, int height, const Matching& matching) {
   const int64_t columns = std::min(matching.window_px, cost_columns(width, matching));
   return columns * std::min(matching.window_px, height) * largest_pixel_cost(matching) <
          std::numeric_limits<uint16_t>::max() - 1;
}

/// `match`: of the bands of a map.
template <class Pair, class Match>
DisparityMap match_bands(const Pair& pair, const Matching& matching, int width, int height, int threads, Match match) {
   DisparityMap map(map_width(width, matching), height, 0, matching.subpixel);
   if (matching.has_confidence()) map.confidence.assign(map.valid.size(), 0);
   fast::for_each_band(height, threads, [&](int first, int end) { match(pair, matching, map, first, end); });
   return map;
}

}  // namespace

DisparityMap match_codes(const std::vector<uint64_t>& left, const std::vector<uint64_t>& right, int width,
                         const Matching& matching, int threads) {
   const int height = int(left.size()) / width;
   const Words pair(left, right, width, matching, kLanes);
   return match_bands(pair, matching, width, height, threads,
                      fits_16_bits(width, height, matching) ? match_census_16 : match_census_32);
}

namespace {

template <class Pixel>
DisparityMap match(const RasterImage<Pixel>& left, const RasterImage<Pixel>& right, const Matching& matching,
                   int threads) {
   if (matching.cost == Cost::census) {
      return match_codes(fast::census(left, matching, threads), fast::census(right, matching, threads), left.width,
                         matching, threads);
   }
   using Pair = AlignedPair<Pixel>;
   using Rows = void (*)(const Pair&, const Matching&, DisparityMap&, int, int);
   const Rows sad_16 = match_sad_16, sad_32 = match_sad_32, ssd_32 = match_ssd_32;
   const bool narrow = fits_16_bits(left.width, left.height, matching);
   return match_bands(Pair(left.pixels, right.pixels, left.width, matching, kLanes), matching, left.width, left.height,
                      threads,
                      matching.cost == Cost::ssd ? ssd_32
                      : narrow                   ? sad_16
                                                 : sad_32);
}

}  // namespace

DisparityMap match_general(const GrayImage& left, const GrayImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}
DisparityMap match_general(const DeepImage& left, const DeepImage& right, const Matching& matching, int threads) {
   return match(left, right, matching, threads);
}

}  // namespace stereo::block_matching
