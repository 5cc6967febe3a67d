// SPDX-License-Identifier: Apache-2.0
// What can be done with the core of each named configuration. Compiled apart from each other, as they take the compiler
// long.
#pragma once

#include <ostream>

#include "built_configurations.hpp"  // made by CMake: STEREO_BUILT_CONFIGURATIONS
#include "configurations.hpp"
#include "vectors/stimulus.hpp"

namespace stereo {

struct ConfigurationFunctions {
   int latency_clocks;
   std::vector<CoreOutput> (*run)(const std::vector<StereoInput>& clocks);  ///< run_core
};

#define STEREO_DECLARE(name)                                \
   namespace configuration_functions::name {                \
   ConfigurationFunctions functions();                      \
   void trace(const Stimulus& stimulus, std::ostream& out); \
   }
STEREO_BUILT_CONFIGURATIONS(STEREO_DECLARE)
#undef STEREO_DECLARE

}  // namespace stereo
