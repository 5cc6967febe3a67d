// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "engines/configurations.hpp"
#include "scene/random.hpp"

namespace stereo {

/// An algorithm family as CMake registers it (cmake/StereoFamilies.cmake).
struct Family {
   std::string name;
   std::string source_folder;  ///< of its core, from the project's root
   std::vector<Configuration> configurations;
   std::shared_ptr<const Algorithm> defaults;  ///< its algorithm with the default of each option
   std::string (*random_row)(Random& random);  ///< random_cores/random_options.hpp
   std::vector<OptionLimits> options;          ///< all of its cores
};

const std::vector<Family>& families();

}  // namespace stereo
