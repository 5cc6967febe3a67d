// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "stereo_core.hpp"
#include "vectors/heap_memories.hpp"
#include "vectors/stimulus.hpp"

namespace stereo {

/// The valid outputs of a core that starts from reset, at the clocks where they came. `observe(core)` is called after
/// each clock and sees all registers. `memories` may hold what a core before the reset has left there.
template <const StereoConfig& C, class Observer>
std::vector<CoreOutput> run_core(const std::vector<StereoInput>& clocks, HeapMemories& memories, Observer observe) {
   const auto core = std::make_unique<StereoCore<C>>(memories);
   std::vector<CoreOutput> outputs;
   OutputLocator locator(C.pixels_per_clock);
   for (uint64_t clock = 0; clock < clocks.size(); ++clock) {
      const StereoOutput output = core->clock(clocks[clock]);
      if (output.valid) outputs.push_back(locator.locate(clock, output));
      observe(*core);
   }
   return outputs;
}

template <const StereoConfig& C>
std::vector<CoreOutput> run_core(const std::vector<StereoInput>& clocks) {
   HeapMemories memories;
   return run_core<C>(clocks, memories, [](const StereoCore<C>&) {});
}

}  // namespace stereo
