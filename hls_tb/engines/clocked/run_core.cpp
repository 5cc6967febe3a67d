// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/run_core.hpp"

namespace stereo {

std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<WideInput>& clocks,
                                 HeapMemories& memories) {
   const auto core = module.make(memories);
   return run_core(*core, module.shape.image.pixels_per_clock, clocks, [] {});
}

std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<WideInput>& clocks) {
   HeapMemories memories;
   return run_core(module, clocks, memories);
}

std::vector<CoreOutput> run_core(const CoreModule& module, const Stimulus& stimulus) {
   HeapMemories memories;
   return run_core(module, stimulus, memories);
}

std::vector<CoreOutput> run_core(const CoreModule& module, const Stimulus& stimulus, HeapMemories& memories) {
   auto core = module.make(memories);
   std::vector<CoreOutput> outputs;
   OutputLocator locator(stimulus.pixels_per_clock);
   auto reset = stimulus.resets.begin();
   auto change = stimulus.settings.begin();
   for (uint64_t clock = 0; clock < stimulus.clocks.size(); ++clock) {
      if (change != stimulus.settings.end() && change->clock == clock) core->set(change++->values);
      const PostOutput output = core->output();
      if (output.valid) outputs.push_back(locator.locate(clock, output));
      if (reset != stimulus.resets.end() && *reset == clock) {
         core = module.make(memories);
         if (change != stimulus.settings.begin()) core->set((change - 1)->values);
         ++reset;
      } else {
         core->clock(stimulus.clocks[clock]);
      }
   }
   return outputs;
}

}  // namespace stereo
