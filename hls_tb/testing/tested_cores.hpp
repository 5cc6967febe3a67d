// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "engines/configurations.hpp"

namespace stereo::test {

/// The places in the table of the configurations whose cores are built, which are at least those of the fast set; with
/// STEREO_ALL_CORES in the environment of all.
inline std::vector<std::size_t> tested_configurations() {
   const std::filesystem::path folder = STEREO_CORE_FOLDER;
   std::vector<std::size_t> places;
   for (std::size_t i = 0; i < configurations().size(); ++i)
      if (std::getenv("STEREO_ALL_CORES") != nullptr || exists(folder / (configurations()[i].name + ".so")))
         places.push_back(i);
   return places;
}

}  // namespace stereo::test
