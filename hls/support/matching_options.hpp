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
