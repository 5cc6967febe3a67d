// SPDX-License-Identifier: Apache-2.0
#include "vectors/configuration_table.hpp"

#include <algorithm>

#include "vectors/configuration_functions.hpp"

namespace stereo {
const std::vector<Configuration>& configuration_table() {
   static const std::vector<Configuration> table = [] {
      std::vector<Configuration> entries{
#define STEREO_ENTRY(name)                                                                               \
   Configuration{#name, configurations::name, configuration_functions::name::functions().latency_clocks, \
                 configuration_functions::name::functions().run, &configuration_functions::name::trace},
          STEREO_BUILT_CONFIGURATIONS(STEREO_ENTRY)
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
