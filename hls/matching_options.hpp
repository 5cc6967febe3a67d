// SPDX-License-Identifier: Apache-2.0
// The choices of the algorithm; docs/algorithm.md defines each.
#pragma once

#include <cstdint>

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

}  // namespace stereo
