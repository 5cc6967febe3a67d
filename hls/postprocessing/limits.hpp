// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/sentence.hpp"

namespace stereo {

// The window of the support filter: 35 pixels, those of every second column.
inline constexpr int kSupportRows = 2;     ///< above and below its centre
inline constexpr int kSupportColumns = 6;  ///< left and right of it

/// Groups of rows that a pixel waits for.
constexpr int support_groups(int pixels_per_clock) { return (kSupportRows + pixels_per_clock - 1) / pixels_per_clock; }

/// Groups and clocks that are enough from the check of a pixel to its support filter.
template <class Config>
constexpr int support_lag(const Config& config) {
   constexpr int kClocks = 10;
   if (!config.has_support_filter()) return 0;
   return support_groups(config.pixels_per_clock) * config.width_px + kSupportColumns + kClocks;
}

/// Why the post-processing of a configuration cannot be built; empty when it can.
template <class Config>
constexpr Sentence post_processing_problem(const Config& config) {
   if (!config.has_post_processing()) return {};
   if (config.has_support_filter() && config.row_groups() <= support_groups(config.pixels_per_clock))
      return "the image must be higher than the rows that the support filter waits for";
   if (config.fill_holes && config.row_groups() <= 1)
      return "the image must be higher than the row that the filling of holes waits for";
   if (config.disparity_bits() * config.pixels_per_clock > 64)
      return "four pixels a clock have no room for a confidence beside filled or fractional disparities";
   if (config.width_px <= 2 * kSupportColumns) return "with post-processing the image must have 13 columns or more";
   if (config.output_width_px() < 2) return "with post-processing the map must have two columns or more";
   return {};
}

}  // namespace stereo
