// SPDX-License-Identifier: Apache-2.0
#include "engines/rectification/stages.hpp"

#include <algorithm>

namespace stereo {

std::vector<Stage> make_rectification_stages();  // made by CMake

std::string Stage::description() const {
   return size_text(config.width_px, config.height_px) + ", a node every " + std::to_string(config.grid_px) +
          " pixels, " + std::to_string(config.rows_above) + " rows above and " + std::to_string(config.rows_below) +
          " below";
}

const std::vector<Stage>& stages() {
   static const std::vector<Stage> all = [] {
      std::vector<Stage> table = make_rectification_stages();
      std::ranges::sort(table, {}, &Stage::name);
      return table;
   }();
   return all;
}

const Stage* find_stage(const std::string& name) {
   const auto found = std::ranges::find(stages(), name, &Stage::name);
   return found == stages().end() ? nullptr : &*found;
}

}  // namespace stereo
