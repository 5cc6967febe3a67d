// SPDX-License-Identifier: Apache-2.0
// From a configuration's name at run time to its core.
#pragma once

#include <ostream>

#include "vectors/stimulus.hpp"

namespace stereo {

struct Configuration {
   std::string name;
   StereoConfig config;
   int latency_clocks;
   std::vector<CoreOutput> (*run)(const std::vector<StereoInput>& clocks);  ///< run_core of this configuration
   void (*trace)(const Stimulus& stimulus, std::ostream& out);              ///< trace_core of this configuration
};

/// The named configurations of this build (STEREO_CONFIGURATIONS), sorted by name.
const std::vector<Configuration>& configuration_table();

/// nullptr when there is none of that name.
const Configuration* find_configuration(const std::string& name);

}  // namespace stereo
