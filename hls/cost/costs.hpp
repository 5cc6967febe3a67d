// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/hls_support.hpp"

namespace stereo {

/// Sum of the costs of one column of a window, and of a window.
template <const auto& C>
using ColumnCost = uint_of_bits<bits_for(C.largest_column_cost())>;
template <const auto& C>
using WindowCost = uint_of_bits<bits_for(C.largest_window_cost())>;

}  // namespace stereo
