// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/core.hpp"
#include "engines/clocked/run_core.hpp"
#include "testing/map_compare.hpp"
#include "testing/reference_map.hpp"
#include "testing/seed.hpp"

namespace stereo::test {

/// The map of one frame.
template <const block_matching::Config& C>
DisparityMap core_map(const ImagePair& pair, int stall_percent = 0) {
   using Core = block_matching::Core<C>;
   StimulusWriter writer(core_shape<Core>(), stall_percent, test_seed());
   writer.rows(pair, {0, C.height_px});
   writer.flush(Core::kSchedule);
   writer.drain(Core::kSchedule);
   HeapMemories memories;
   const auto core = make_clocked_core<Core>(memories);
   const auto maps = collect_frames(run_core(*core, C.pixels_per_clock, writer.clocks, [] {}), core_shape<Core>());
   EXPECT_EQ(maps.size(), 1u);
   return maps.empty() ? DisparityMap() : maps[0];
}

/// Compares the core's map with that of the reference model.
template <const block_matching::Config& C>
void expect_reference(const ImagePair& pair, int stall_percent = 0) {
   EXPECT_TRUE(same_map(reference_map(pair, C), core_map<C>(pair, stall_percent)));
}

}  // namespace stereo::test
