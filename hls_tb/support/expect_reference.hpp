// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/map_compare.hpp"
#include "support/reference_map.hpp"
#include "support/seed.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {

/// The map of one frame.
template <const StereoConfig& C>
DisparityMap core_map(const ImagePair& pair, int stall_percent = 0) {
   StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed());
   writer.rows(pair, {0, C.height_px});
   writer.flush(C);
   writer.drain(StereoCore<C>::kLatency);
   const auto maps = collect_frames(run_core<C>(writer.clocks), C);
   EXPECT_EQ(maps.size(), 1u);
   return maps.empty() ? DisparityMap() : maps[0];
}

/// Compares the core's map with that of the reference model.
template <const StereoConfig& C>
void expect_reference(const ImagePair& pair, int stall_percent = 0) {
   EXPECT_TRUE(same_map(reference_map(pair, C), core_map<C>(pair, stall_percent)));
}

}  // namespace stereo::test
