// SPDX-License-Identifier: Apache-2.0
// Cores beside the named ones, compiled once for all tests of whole cores.
#pragma once

#include <string>
#include <vector>

#include "support/stage_recorder.hpp"
#include "support/test_configs.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {

struct SmallCore {
   std::string name;
   StereoConfig config;
   int latency_clocks;
   /// run_core. `stages`, unless null: what they showed, when the clocks hold one frame.
   std::vector<CoreOutput> (*run)(const std::vector<StereoInput>& clocks, HeapMemories& memories, Stages* stages);
};

/// AllSmallConfigs, and some with options together.
const std::vector<SmallCore>& small_cores();

template <const StereoConfig& C>
std::vector<CoreOutput> run_recorded(const std::vector<StereoInput>& clocks, HeapMemories& memories, Stages* stages) {
   StageRecorder<C> recorder;
   const auto outputs = run_core<C>(clocks, memories, [&recorder, stages](const StereoCore<C>& core) {
      if (stages != nullptr) recorder.record(core.slices);
   });
   if (stages != nullptr) *stages = recorder.stages();
   return outputs;
}

template <class... Configs>
void add_cores(std::vector<SmallCore>& cores, ::testing::Types<Configs...>) {
   (cores.push_back({config_name(Configs::kConfig), Configs::kConfig, StereoCore<Configs::kConfig>::kLatency,
                     &run_recorded<Configs::kConfig>}),
    ...);
}

// Parts of the table, one source each: they take the compiler long.
void add_plain_cores(std::vector<SmallCore>& cores);
void add_option_cores(std::vector<SmallCore>& cores);

}  // namespace stereo::test
