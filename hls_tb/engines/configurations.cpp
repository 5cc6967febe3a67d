// SPDX-License-Identifier: Apache-2.0
#include "engines/configurations.hpp"

#include <algorithm>

#include "engines/families.hpp"
#include "family_list.hpp"  // made by CMake: STEREO_FAMILIES(CALL), the functions that make the families

namespace stereo {

#define STEREO_DECLARE(make) Family make();
STEREO_FAMILIES(STEREO_DECLARE)
#undef STEREO_DECLARE

const std::vector<Family>& families() {
#define STEREO_MAKE(make) make(),
   static const std::vector<Family> all{STEREO_FAMILIES(STEREO_MAKE)};
#undef STEREO_MAKE
   return all;
}

std::string Configuration::description() const {
   return size_text(shape.image.width_px, shape.image.height_px) + ", " + algorithm->description();
}

const std::vector<Configuration>& configurations() {
   static const std::vector<Configuration> all = [] {
      std::vector<Configuration> table;
      for (const Family& family : families())
         table.insert(table.end(), family.configurations.begin(), family.configurations.end());
      std::ranges::sort(table, {}, &Configuration::name);
      return table;
   }();
   return all;
}

const Configuration* find_configuration(const std::string& name) {
   const auto found = std::ranges::find(configurations(), name, &Configuration::name);
   return found == configurations().end() ? nullptr : &*found;
}

std::string no_such_configuration() {
   std::string known;
   for (const Configuration& entry : configurations()) known += (known.empty() ? "" : ", ") + entry.name;
   return "there is no such configuration; known are: " + known;
}

}  // namespace stereo
