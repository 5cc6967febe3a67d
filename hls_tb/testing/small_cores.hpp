// SPDX-License-Identifier: Apache-2.0
// Cores beside the named ones, compiled once for all tests of whole cores.
#pragma once

#include <string>
#include <vector>

#include "block_matching/core.hpp"
#include "engines/clocked/run_core.hpp"
#include "testing/stage_recorder.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {

struct SmallCore {
   std::string name;
   block_matching::Config config;
   CoreShape shape;
   /// run_core. `stages`, unless null: what they showed, when the clocks hold one frame.
   std::vector<CoreOutput> (*run)(const std::vector<WideInput>& clocks, HeapMemories& memories, Stages* stages);
};

/// AllSmallConfigs, and some with options together.
const std::vector<SmallCore>& small_cores();

template <const block_matching::Config& C>
std::vector<CoreOutput> run_recorded(const std::vector<WideInput>& clocks, HeapMemories& memories, Stages* stages) {
   using Core = block_matching::Core<C>;
   StageRecorder<C> recorder;
   const auto core = std::make_unique<ClockedCoreOf<Core>>(memories);
   const auto outputs = run_core(*core, C.pixels_per_clock, clocks, [&recorder, &core, stages] {
      if (stages != nullptr) recorder.record(core->core().slices);
   });
   if (stages != nullptr) *stages = recorder.stages();
   return outputs;
}

template <class... Configs>
void add_cores(std::vector<SmallCore>& cores, ::testing::Types<Configs...>) {
   (cores.push_back({config_name(Configs::kConfig), Configs::kConfig,
                     core_shape<block_matching::Core<Configs::kConfig>>(), &run_recorded<Configs::kConfig>}),
    ...);
}

// Parts of the table, one source each: they take the compiler long.
void add_plain_cores(std::vector<SmallCore>& cores);
void add_option_cores(std::vector<SmallCore>& cores);

}  // namespace stereo::test
