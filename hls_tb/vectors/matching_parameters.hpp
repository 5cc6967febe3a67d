// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/matching.hpp"
#include "stereo_config.hpp"

namespace stereo {

/// What the models must know of a hardware configuration.
constexpr MatchingParameters matching_parameters(const StereoConfig& config) {
   return {.disparities = config.disparities,
           .window_px = config.window_px,
           .min_disparity = config.min_disparity,
           .reference = config.reference,
           .cost = config.cost,
           .census_width_px = config.census_width_px,
           .census_height_px = config.census_height_px,
           .prefilter = config.prefilter,
           .prefilter_cap = config.prefilter_cap,
           .ties = config.ties,
           .left_right_threshold = config.left_right_threshold,
           .uniqueness_percent = config.uniqueness_percent,
           .texture_threshold = config.texture_threshold,
           .subpixel = config.subpixel,
           .median = config.median};
}

}  // namespace stereo
