// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engines/clocked/clocked_core.hpp"
#include "engines/clocked/core_outputs.hpp"
#include "engines/clocked/stimulus.hpp"

namespace stereo {

/// The valid outputs of a core that starts from reset, at the clocks where they came. `observe()` is called after each
/// clock.
template <class Observer>
std::vector<CoreOutput> run_core(ClockedCore& core, int pixels_per_clock, const std::vector<WideInput>& clocks,
                                 Observer observe) {
   std::vector<CoreOutput> outputs;
   OutputLocator locator(pixels_per_clock);
   for (uint64_t clock = 0; clock < clocks.size(); ++clock) {
      const PostOutput output = core.output();
      core.clock(clocks[clock]);
      if (output.valid) outputs.push_back(locator.locate(clock, output));
      observe();
   }
   return outputs;
}

/// The same of a new core of a module, on `memories` or on new ones.
std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<WideInput>& clocks,
                                 HeapMemories& memories);
std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<WideInput>& clocks);

/// The same with the stimulus's resets: the core starts anew, its memories keep their words.
std::vector<CoreOutput> run_core(const CoreModule& module, const Stimulus& stimulus, HeapMemories& memories);
std::vector<CoreOutput> run_core(const CoreModule& module, const Stimulus& stimulus);

}  // namespace stereo
