// SPDX-License-Identifier: Apache-2.0
// Running column sums for every disparity, updated by one row in and one row out. Each loop over x is free of branches
// and calls, so that the compiler vectorises it.
#include "models/fast_model.hpp"

#include <algorithm>
#include <limits>

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

/// |R(x) - L(x+d)|, given pointers to the pixels of one row.
struct RowCosts {
   const uint8_t* left;
   const uint8_t* right;
   uint8_t operator[](int x) const { return uint8_t(std::max(left[x], right[x]) - std::min(left[x], right[x])); }
};

/// An image with room for whole vectors behind its last row.
struct PaddedImage {
   explicit PaddedImage(const GrayImage& image) : width(image.width), pixels(image.pixels) {
      pixels.resize(pixels.size() + kLanes);
   }
   const uint8_t* row(int y) const { return pixels.data() + std::ptrdiff_t(y) * width; }

   int width;
   std::vector<uint8_t> pixels;
};

/// The mask is 0 beyond the cost columns and all ones inside.
template <class Sum>
STEREO_INTO_CLONES void add_row(Sum* columns, const Sum* mask, int count, RowCosts in) {
   for (int x = 0; x < count; ++x) columns[x] = Sum((columns[x] + in[x]) & mask[x]);
}

template <class Sum>
STEREO_INTO_CLONES void remove_row(Sum* columns, const Sum* mask, int count, RowCosts out) {
   for (int x = 0; x < count; ++x) columns[x] = Sum((columns[x] - out[x]) & mask[x]);
}

template <class Sum>
STEREO_INTO_CLONES void exchange_rows(Sum* columns, const Sum* mask, int count, RowCosts in, RowCosts out) {
   for (int x = 0; x < count; ++x) columns[x] = Sum((columns[x] + in[x] - out[x]) & mask[x]);
}

/// totals[x] = columns[x] + ... + columns[x + window - 1], two columns a pass.
template <class Sum>
STEREO_INTO_CLONES void add_columns(Sum* totals, const Sum* columns, int count, int window) {
   for (int x = 0; x < count; ++x) totals[x] = columns[x];
   for (int j = 1; j < window; j += 2)
      for (int x = 0; x < count; ++x) totals[x] = Sum(totals[x] + columns[x + j] + columns[x + j + 1]);
}

template <class Sum>
STEREO_INTO_CLONES void keep_smaller(Sum* best, Sum* winner, const Sum* totals, int count, Sum disparity) {
   for (int x = 0; x < count; ++x) {
      const Sum before = best[x], now = winner[x];
      const Sum after = std::min(totals[x], before);
      winner[x] = after == before ? now : disparity;
      best[x] = after;
   }
}

template <class Sum>
STEREO_INTO_CLONES void match_rows(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                   GrayImage& map) {
   // A window beyond the image adds nothing but zeros.
   const int cost_columns = map.width + 1;
   const int radius_x = std::min(parameters.window_px / 2, cost_columns);
   const int radius_y = std::min(parameters.window_px / 2, map.height);
   const int count = (cost_columns + kLanes - 1) / kLanes * kLanes;
   const int stride = count + 2 * radius_x;  // with zeros on both sides
   std::vector<Sum> sums(std::size_t(stride) * std::size_t(parameters.disparities));
   std::vector<Sum> mask(static_cast<std::size_t>(count)), totals(mask), best(mask), winner(mask);
   std::fill_n(mask.begin(), cost_columns, std::numeric_limits<Sum>::max());

   for (int y = -radius_y; y < map.height; ++y) {  // rows above 0 only take in what lies below them
      std::fill(best.begin(), best.end(), std::numeric_limits<Sum>::max());
      std::fill(winner.begin(), winner.end(), Sum(0));
      const int row_in = y + radius_y, row_out = y - radius_y - 1;
      for (int d = 0; d < parameters.disparities; ++d) {
         Sum* const padded = sums.data() + std::ptrdiff_t(d) * stride;
         Sum* const columns = padded + radius_x;
         const auto row = [&](int number) { return RowCosts{left.row(number) + d, right.row(number)}; };
         if (row_in < map.height && row_out >= 0) exchange_rows(columns, mask.data(), count, row(row_in), row(row_out));
         else if (row_in < map.height) add_row(columns, mask.data(), count, row(row_in));
         else if (row_out >= 0) remove_row(columns, mask.data(), count, row(row_out));
         if (y < 0) continue;
         add_columns(totals.data(), padded, count, 2 * radius_x + 1);
         keep_smaller(best.data(), winner.data(), totals.data(), count, Sum(d));
      }
      if (y >= 0) std::copy_n(winner.begin(), map.width, map.row(y));
   }
}

STEREO_VECTOR_CLONES void match_narrow(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                       GrayImage& map) {
   match_rows<uint16_t>(left, right, parameters, map);
}

STEREO_VECTOR_CLONES void match_wide(const PaddedImage& left, const PaddedImage& right, MatchingParameters parameters,
                                     GrayImage& map) {
   match_rows<uint32_t>(left, right, parameters, map);
}

}  // namespace

GrayImage match_fast(const GrayImage& left, const GrayImage& right, MatchingParameters parameters) {
   check_matching_input(left, right, parameters);
   GrayImage map(left.width - parameters.disparities, left.height);
   const int64_t window_pixels =
       int64_t(std::min(parameters.window_px, map.width + 1)) * std::min(parameters.window_px, map.height);
   const bool narrow = 255 * window_pixels < std::numeric_limits<uint16_t>::max();
   (narrow ? match_narrow : match_wide)(PaddedImage(left), PaddedImage(right), parameters, map);
   return map;
}

}  // namespace stereo
