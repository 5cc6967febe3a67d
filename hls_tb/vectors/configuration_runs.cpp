// SPDX-License-Identifier: Apache-2.0
// The clocked cores of one group of configurations: -DSTEREO_GROUP=STEREO_TINY_CONFIGURATIONS
#include "vectors/configuration_functions.hpp"
#include "vectors/run_core.hpp"

#define STEREO_DEFINE(name)                                                                 \
   stereo::ConfigurationFunctions stereo::configuration_functions::name::functions() {      \
      return {StereoCore<configurations::name>::kLatency, &run_core<configurations::name>}; \
   }
STEREO_GROUP(STEREO_DEFINE)
