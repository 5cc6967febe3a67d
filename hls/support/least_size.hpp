// SPDX-License-Identifier: Apache-2.0
// The smallest images of a core with a run-time size.
#pragma once

#include "support/image.hpp"

namespace stereo {

/// The smallest multiple of `step` up to `largest` that fits; what is larger than one that fits does, too.
template <class Fits>
constexpr int least_multiple(int largest, int step, Fits fits) {
   int below = 0, fitting = largest / step;
   while (fitting - below > 1) {
      const int middle = (below + fitting) / 2;
      (fits(middle * step) ? fitting : below) = middle;
   }
   return fitting * step;
}

/// Such a core takes each width from here on together with each height: the width is that of the narrowest images of
/// half the height, the height that of the lowest images of that width. `config`: what the core was built for.
template <class Config>
constexpr Image least_size(const Config& config) {
   const auto takes = [&](int width, int height) {
      Config other = config;
      other.width_px = width;
      other.height_px = height;
      return other.problem().empty();
   };
   const int step = config.pixels_per_clock, half = (config.row_groups() + 1) / 2 * step;
   Image least = config;
   const int height = takes(config.width_px, half) ? half : config.height_px;
   least.width_px = least_multiple(config.width_px, 1, [&](int width) { return takes(width, height); });
   least.height_px = least_multiple(config.height_px, step, [&](int rows) { return takes(least.width_px, rows); });
   return least;
}

/// The ports of the size, where the configuration has run_time_size. They are the last ones of a core's settings.
template <class Config, class Visitor>
constexpr void visit_size(const Config& config, Visitor& visit) {
   if (!config.run_time_size) return;
   const Image least = least_size(config);
   visit.held("image_width", 16, config.width_px, least.width_px, 1);
   visit.held("image_height", 16, config.height_px, least.height_px, config.pixels_per_clock);
}

}  // namespace stereo
