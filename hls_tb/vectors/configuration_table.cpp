// SPDX-License-Identifier: Apache-2.0
#include "vectors/configuration_table.hpp"

#include <algorithm>

#include "vectors/register_trace.hpp"
#include "vectors/run_core.hpp"

namespace stereo {
namespace {

template <const StereoConfig& C>
Configuration entry(const char* name) {
   return {name, C, StereoCore<C>::kLatency, &run_core<C>, &trace_core<C>};
}

}  // namespace

const std::vector<Configuration>& configuration_table() {
   static const std::vector<Configuration> table = [] {
      std::vector<Configuration> entries{
#define STEREO_ENTRY(name) entry<configurations::name>(#name),
          STEREO_FOR_EACH_CONFIGURATION(STEREO_ENTRY)
#undef STEREO_ENTRY
      };
      std::ranges::sort(entries, {}, &Configuration::name);
      return entries;
   }();
   return table;
}

const Configuration* find_configuration(const std::string& name) {
   const auto found = std::ranges::find(configuration_table(), name, &Configuration::name);
   return found == configuration_table().end() ? nullptr : &*found;
}

}  // namespace stereo
