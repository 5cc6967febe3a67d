// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/run_core.hpp"

namespace stereo {

std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<StereoInput>& clocks,
                                 HeapMemories& memories) {
   const auto core = module.make(memories);
   return run_core(*core, module.shape.image.pixels_per_clock, clocks, [] {});
}

std::vector<CoreOutput> run_core(const CoreModule& module, const std::vector<StereoInput>& clocks) {
   HeapMemories memories;
   return run_core(module, clocks, memories);
}

}  // namespace stereo
