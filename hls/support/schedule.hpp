// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "postprocessing/limits.hpp"

namespace stereo {

/// When the outputs of a core come. A group is the P pixel pairs that enter in one clock.
struct Schedule {
   int latency_clocks;          ///< clocks from the last group that an output depends on, or waits for, to the output
   int groups_to_first_output;  ///< valid groups, from a frame's first on, that bring out its first disparities
   int flush_groups;            ///< valid groups without start of frame that bring out the last disparities of a frame
   int gap_groups;              ///< valid groups without start of frame that must stand between two frames
   int clocks_per_group = 1;    ///< clocks from one valid group to the next, at least
};

/// The schedule of a core whose outputs come in the order of its inputs, a map of `map_width` columns.
/// groups_to_first_output: as above; image: its size and pixels per clock.
template <class Image>
constexpr Schedule raster_schedule(const Image& image, int map_width, int latency_clocks, int groups_to_first_output,
                                   int gap_groups) {
   const int groups_to_last_output = groups_to_first_output + (image.row_groups() - 1) * image.width_px + map_width - 1;
   const int left = groups_to_last_output - image.row_groups() * image.width_px;
   return {latency_clocks, groups_to_first_output, left < 0 ? 0 : left, gap_groups};
}

/// The gap of a core whose windows need `groups`. No gap at all, or one that brings out the last rows of every stage: a
/// frame that joins another one neither directly nor behind these takes them away.
template <class Config>
constexpr int gap_of(const Config& config, int groups) {
   int of_support = 0;
   if constexpr (requires { config.has_support_filter(); })
      if (config.has_support_filter()) of_support = support_groups(config.pixels_per_clock) * config.width_px;
   return groups > 0 && groups < of_support ? of_support : groups;
}

/// The same of a core whose blocks hold valid groups back up to a row's first window centre and the columns after it.
/// windows: the configuration of the windows; blocks: the sums over all blocks (support/blocks.hpp).
template <class Config, class Windows, class Sums>
constexpr Schedule window_schedule(const Config& config, const Windows& windows, const Sums& blocks) {
   const int groups = blocks.lag_groups + windows.first_map_column() + windows.columns_after() + 1;
   return raster_schedule(config, config.output_width_px(), blocks.clocks, groups,
                          gap_of(config, windows.gap_groups()));
}

}  // namespace stereo
