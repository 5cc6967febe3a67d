// SPDX-License-Identifier: Apache-2.0
// Running column sums for every disparity, updated by one row in and one row out. Each loop over x is free of branches
// and calls, so that the compiler vectorises it; 3x3 and 5x5 windows fit 16-bit lanes.
#include "models/fast_model.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "models/reference_model.hpp"

// One build that uses AVX2 where the machine has it. Sanitizers cannot run the resolvers this needs.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__)
#define STEREO_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#define STEREO_INTO_CLONES inline __attribute__((always_inline))
#else
#define STEREO_VECTOR_CLONES
#define STEREO_INTO_CLONES inline
#endif

namespace stereo {
namespace {

/// Loops run over whole vectors of this many columns: the compiler's code for a rest would cost as much as the body.
constexpr int kLanes = 32;

/// So many disparities are compared with each other before the smallest of them meets the best so far. In these
/// comparisons the disparity stands in the lowest bits of its cost, so that one minimum finds both.
constexpr int kGroup = 8;

/// |R(x) - L(x+d)|, given pointers to the pixels of one row.
struct RowCosts {
   const uint8_t* left;
   const uint8_t* right;
   uint16_t operator[](int x) const { return uint16_t(std::abs(left[x] - right[x])); }
};

/// An image with black rows above and below it and with room for whole vectors behind each row.
struct PaddedImage {
   explicit PaddedImage(const GrayImage& image)
       : width(image.width),
         height(image.height),
         pixels(image.pixels),
         black(static_cast<std::size_t>(width + kLanes)) {
      pixels.resize(pixels.size() + kLanes);
   }
   const uint8_t* row(int y) const {
      return y >= 0 && y < height ? pixels.data() + std::ptrdiff_t(y) * width : black.data();
   }

   int width, height;
   std::vector<uint8_t> pixels, black;
};

/// Column sums of one disparity move down by a row.
template <class Sum>
STEREO_INTO_CLONES void exchange_rows(Sum* __restrict columns, int count, RowCosts in, RowCosts out) {
   for (int x = 0; x < count; ++x) columns[x] = Sum(columns[x] + in[x] - out[x]);
}

/// totals[x] = columns[x] + ... + columns[x + window - 1]: one column, then two a pass.
template <class Sum>
STEREO_INTO_CLONES void add_columns(Sum* __restrict totals, const Sum* __restrict columns, int count, int window) {
   for (int x = 0; x < count; ++x) totals[x] = columns[x];
   for (int j = 1; j < window; j += 2)
      for (int x = 0; x < count; ++x) totals[x] = Sum(totals[x] + columns[x + j] + columns[x + j + 1]);
}

/// Compares windows of `Window` columns. rows[i]: the columns of disparity first + i.
template <int Window, class Sum>
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

/// Window: the matching window's side, or 0 for any. Sum must hold kGroup times the largest window sum.
template <int Window, class Sum>
STEREO_INTO_CLONES void match_rows(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                   GrayImage& map) {
   static_assert(kGroup * (255 * Window * Window + 1) <= std::numeric_limits<Sum>::max());
   // A window beyond the image adds nothing but zeros.
   const int cost_columns = map.width + 1;
   const int radius_x = std::min(parameters.window_px / 2, cost_columns);
   const int radius_y = std::min(parameters.window_px / 2, map.height);
   const int count = (cost_columns + kLanes - 1) / kLanes * kLanes;
   const int stride = count + 2 * radius_x;  // with zeros on both sides
   const int beyond = std::min(radius_x, count - cost_columns);
   std::vector<Sum> sums(std::size_t(stride) * std::size_t(parameters.disparities));
   std::vector<Sum> best(static_cast<std::size_t>(count)), winner(best), totals(kGroup * best.size());

   for (int y = -radius_y; y < map.height; ++y) {  // rows above 0 only take in what lies below them
      std::fill(best.begin(), best.end(), std::numeric_limits<Sum>::max());
      for (int first = 0; first < parameters.disparities; first += kGroup) {
         const Sum* rows[kGroup];
         for (int i = 0; i < kGroup; ++i) {
            const int d = std::min(first + i, parameters.disparities - 1);  // a copy of the last one loses to it
            Sum* const padded = sums.data() + std::ptrdiff_t(d) * stride;
            Sum* const columns = padded + radius_x;
            const auto row = [&](int number) { return RowCosts{left.row(number) + d, right.row(number)}; };
            if (d == first + i) exchange_rows(columns, count, row(y + radius_y), row(y - radius_y - 1));
            std::fill_n(columns + cost_columns, beyond, Sum(0));
            rows[i] = padded;
            if constexpr (Window == 0) {
               add_columns(totals.data() + i * count, padded, count, 2 * radius_x + 1);
               rows[i] = totals.data() + i * count;
            }
         }
         keep_smallest<std::max(Window, 1)>(best.data(), winner.data(), rows, count, Sum(first));
      }
      if (y >= 0) std::copy_n(winner.begin(), map.width, map.row(y));
   }
}

using Match = void(const PaddedImage&, const PaddedImage&, MatchingParameters, GrayImage&);

STEREO_VECTOR_CLONES void match_3x3(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                    GrayImage& map) {
   match_rows<3, uint16_t>(left, right, parameters, map);
}

STEREO_VECTOR_CLONES void match_5x5(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                    GrayImage& map) {
   match_rows<5, uint16_t>(left, right, parameters, map);
}

STEREO_VECTOR_CLONES void match_any(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                    GrayImage& map) {
   match_rows<0, uint32_t>(left, right, parameters, map);
}

/// For windows of millions of pixels.
void match_huge(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters, GrayImage& map) {
   match_rows<0, uint64_t>(left, right, parameters, map);
}

Match* matcher_for(int window_px, const GrayImage& map) {
   if (window_px == 3) return match_3x3;
   if (window_px == 5) return match_5x5;
   const int64_t window_pixels = int64_t(std::min(window_px, map.width + 1)) * std::min(window_px, map.height);
   const bool fits = kGroup * (255 * window_pixels + 1) <= std::numeric_limits<uint32_t>::max();
   return fits ? match_any : match_huge;
}

}  // namespace

DisparityMap match_fast(const GrayImage& left, const GrayImage& right, const MatchingParameters& parameters) {
   check_matching_input(left, right, parameters);
   const bool plain = parameters.window_px % 2 == 1 && parameters.min_disparity == 0 &&
                      parameters.reference == Reference::right && parameters.cost == Cost::sad &&
                      parameters.prefilter == Prefilter::none && parameters.ties == Ties::smallest &&
                      !parameters.has_check() && !parameters.subpixel && !parameters.median;
   if (!plain) return match_reference(left, right, parameters);
   GrayImage winners(left.width - parameters.disparities, left.height);
   matcher_for(parameters.window_px, winners)(PaddedImage(left), PaddedImage(right), parameters, winners);
   DisparityMap map(winners.width, winners.height);
   std::copy(winners.pixels.begin(), winners.pixels.end(), map.disparity.begin());
   return map;
}

}  // namespace stereo
