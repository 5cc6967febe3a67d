// SPDX-License-Identifier: Apache-2.0
// Each filter is a product of one along the columns and one along the rows: three rows of numbers come from the first,
// all six responses from these.
#include "engines/fast/phase_correlation/phase_codes.hpp"

#include <cstddef>

#include "engines/fast/vector_clones.hpp"

namespace stereo::fast {
namespace {

constexpr int kBitsOfScale = 6;

using Numbers = std::vector<int>;

/// Of pixels, the sums of s x s that end in each one; those that reach outside of the image have no meaning.
STEREO_VECTOR_CLONES Numbers boxes(Numbers sums, int width, int step) {
   for (int lag = 1; lag < step; lag *= 2) {
      for (const std::size_t before : {std::size_t(lag), std::size_t(lag) * std::size_t(width)}) {
         const Numbers smaller = sums;
         for (std::size_t i = before; i < sums.size(); ++i) sums[i] = smaller[i] + smaller[i - before];
      }
   }
   return sums;
}

/// Five boxes of one row.
struct Row {
   const int* before_2;
   const int* before_1;
   const int* centre;
   const int* after_1;
   const int* after_2;
};

STEREO_VECTOR_CLONES void filter_columns(const Row& rows, int width, int* __restrict low, int* __restrict even,
                                         int* __restrict odd) {
   for (int x = 0; x < width; ++x) {
      low[x] = rows.before_1[x] + 2 * rows.centre[x] + rows.after_1[x];
      even[x] = 2 * rows.centre[x] - rows.before_2[x] - rows.after_2[x];
      odd[x] = rows.after_2[x] + 2 * (rows.after_1[x] - rows.before_1[x]) - rows.before_2[x];
   }
}

STEREO_VECTOR_CLONES void filter_row(const Row& low, const Row& even, const Row& odd, int count,
                                     uint64_t* __restrict codes) {
   const auto along_e = [](const Row& row, int x) { return 2 * row.centre[x] - row.before_2[x] - row.after_2[x]; };
   const auto along_o = [](const Row& row, int x) {
      return row.after_2[x] + 2 * (row.after_1[x] - row.before_1[x]) - row.before_2[x];
   };
   for (int x = 0; x < count; ++x) {
      const int ee = along_e(even, x), oe = along_o(even, x), eo = along_e(odd, x), oo = along_o(odd, x);
      const unsigned bits = unsigned(along_e(low, x) > 0) | unsigned(along_o(low, x) > 0) << 1 |
                            unsigned(ee > oo) << 2 | unsigned(oe + eo > 0) << 3 | unsigned(ee + oo > 0) << 4 |
                            unsigned(oe > eo) << 5;
      codes[x] = codes[x] << kBitsOfScale | bits;
   }
}

/// Moves every code up by one scale, and adds the bits of this one where its filters lie in the image.
template <class Image>
void append_scale(const Image& image, int scale, std::vector<uint64_t>& codes) {
   const int step = 1 << scale, before = 3 * step - 1, after = 2 * step, width = image.width;
   const Numbers sums = boxes(Numbers(image.pixels.begin(), image.pixels.end()), width, step);
   Numbers low(static_cast<std::size_t>(width)), even(low), odd(low);
   const int count = width - before - after;
   for (int y = 0; y < image.height; ++y) {
      uint64_t* const row = codes.data() + std::ptrdiff_t(y) * width;
      const bool inside = y >= before && y + after < image.height && count > 0;
      for (int x = 0; x < width; ++x)
         if (!inside || x < before || x >= before + count) row[x] <<= kBitsOfScale;
      if (!inside) continue;
      const auto sums_of = [&](int n) { return sums.data() + std::ptrdiff_t(y + n * step) * width; };
      filter_columns({sums_of(-2), sums_of(-1), sums_of(0), sums_of(1), sums_of(2)}, width, low.data(), even.data(),
                     odd.data());
      const auto shifted = [&](const Numbers& numbers) {
         const int* const centre = numbers.data() + before;
         return Row{centre - 2 * step, centre - step, centre, centre + step, centre + 2 * step};
      };
      filter_row(shifted(low), shifted(even), shifted(odd), count, row + before);
   }
}

template <class Image>
std::vector<uint64_t> codes_of(const Image& image, int scales) {
   std::vector<uint64_t> codes(image.pixels.size());
   for (int scale = 0; scale < scales; ++scale) append_scale(image, scale, codes);
   if (scales > 1) append_scale(image, 0, codes);
   return codes;
}

}  // namespace

std::vector<uint64_t> weighted_phase_codes(const GrayImage& image, int scales) { return codes_of(image, scales); }
std::vector<uint64_t> weighted_phase_codes(const DeepImage& image, int scales) { return codes_of(image, scales); }

}  // namespace stereo::fast
