// SPDX-License-Identifier: Apache-2.0
// The register traces of one group of configurations: -DSTEREO_GROUP=STEREO_TINY_CONFIGURATIONS
#include "vectors/configuration_functions.hpp"
#include "vectors/register_trace.hpp"

#define STEREO_DEFINE(name)                                                                         \
   void stereo::configuration_functions::name::trace(const Stimulus& stimulus, std::ostream& out) { \
      trace_core<configurations::name>(stimulus, out);                                              \
   }
STEREO_GROUP(STEREO_DEFINE)
