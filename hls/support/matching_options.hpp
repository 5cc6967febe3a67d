// SPDX-License-Identifier: Apache-2.0
// The choices of the algorithm; docs/algorithm.md defines each.
#pragma once

#include <cstdint>

#include "support/options.hpp"

namespace stereo {

/// The image whose pixels get disparities.
enum class Reference : uint8_t { right, left };

/// How two pixels are compared.
enum class Cost : uint8_t {
   sad,    ///< absolute difference
   ssd,    ///< squared difference
   census  ///< Hamming distance of the census transforms
};

/// Which pixels of the census window are compared with its centre.
enum class CensusPattern : uint8_t {
   all,
   even_columns,  ///< those of the columns at an even distance from the centre
   checkerboard,  ///< those whose distances in rows and columns add up to an even number
   sparse         ///< those of the rows and columns at an even distance from the centre
};

/// Whether the transform has a bit for the pixel dx columns and dy rows from the centre.
constexpr bool has_census_bit(CensusPattern pattern, int dx, int dy) {
   if (dx == 0 && dy == 0) return false;
   switch (pattern) {
      case CensusPattern::even_columns:
         return dx % 2 == 0;
      case CensusPattern::checkerboard:
         return (dx + dy) % 2 == 0;
      case CensusPattern::sparse:
         return dx % 2 == 0 && dy % 2 == 0;
      default:
         return true;
   }
}
constexpr int census_bits(int width_px, int height_px, CensusPattern pattern) {
   int bits = 0;
   for (int dy = -(height_px / 2); dy <= height_px / 2; ++dy)
      for (int dx = -(width_px / 2); dx <= width_px / 2; ++dx) bits += has_census_bit(pattern, dx, dy) ? 1 : 0;
   return bits;
}

/// What is done to both images before they are compared.
enum class Prefilter : uint8_t { none, xsobel };

/// Which disparity wins among equal window costs.
enum class Ties : uint8_t { smallest, largest };

/// How window costs are summed. Both give the same sums.
enum class Aggregation : uint8_t {
   direct,    ///< all rows of a column at once
   recursive  ///< the column's last sum, plus its newest row, minus its oldest
};

template <>
struct Words<Reference> {
   static constexpr const char* kName = "Reference";
   static constexpr const char* kWords[] = {"right", "left"};
};

template <>
struct Words<Cost> {
   static constexpr const char* kName = "Cost";
   static constexpr const char* kWords[] = {"sad", "ssd", "census"};
};

template <>
struct Words<CensusPattern> {
   static constexpr const char* kName = "CensusPattern";
   static constexpr const char* kWords[] = {"all", "even_columns", "checkerboard", "sparse"};
};

template <>
struct Words<Prefilter> {
   static constexpr const char* kName = "Prefilter";
   static constexpr const char* kWords[] = {"none", "xsobel"};
};

template <>
struct Words<Ties> {
   static constexpr const char* kName = "Ties";
   static constexpr const char* kWords[] = {"smallest", "largest"};
};

template <>
struct Words<Aggregation> {
   static constexpr const char* kName = "Aggregation";
   static constexpr const char* kWords[] = {"direct", "recursive"};
};

}  // namespace stereo
