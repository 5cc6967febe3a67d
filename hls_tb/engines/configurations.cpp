// SPDX-License-Identifier: Apache-2.0
#include "engines/configurations.hpp"

#include <algorithm>

#include "families.hpp"  // made by CMake: STEREO_FAMILIES(CALL), the functions that add the families' configurations

namespace stereo {

#define STEREO_DECLARE(add) void add(std::vector<Configuration>& table);
STEREO_FAMILIES(STEREO_DECLARE)
#undef STEREO_DECLARE

std::string Configuration::description() const {
   return size_text(shape.image.width_px, shape.image.height_px) + ", " + algorithm->description();
}

const std::vector<Configuration>& configurations() {
   static const std::vector<Configuration> all = [] {
      std::vector<Configuration> table;
#define STEREO_ADD(add) add(table);
      STEREO_FAMILIES(STEREO_ADD)
#undef STEREO_ADD
      std::ranges::sort(table, {}, &Configuration::name);
      return table;
   }();
   return all;
}

const Configuration* find_configuration(const std::string& name) {
   const auto found = std::ranges::find(configurations(), name, &Configuration::name);
   return found == configurations().end() ? nullptr : &*found;
}

}  // namespace stereo
