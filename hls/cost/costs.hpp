// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/full_width.hpp"
#include "support/hls_support.hpp"

namespace stereo {

/// Sum of the costs of one column of a window, and of a window.
template <const auto& C>
using ColumnCost = uint_of_bits<bits_for(C.largest_column_cost())>;
template <const auto& C>
using WindowCost = uint_of_bits<bits_for(C.largest_window_cost() + (kFullWidth<C> ? 1 : 0))>;

/// With full_width: stands for the cost of a candidate that is not searched. Larger than every cost.
template <const auto& C>
inline constexpr WindowCost<C> kMaskedCost = WindowCost<C>((uint64_t(1) << bits_for(C.largest_window_cost() + 1)) - 1);

}  // namespace stereo
