// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>

#include "engines/clocked/clocked_core.hpp"

namespace stereo {

/// The core of a configuration was not built.
struct NoCoreModule : std::runtime_error {
   using std::runtime_error::runtime_error;
};

/// Where the modules are: else in the folder `cores` beside the running program.
void set_core_folder(const std::filesystem::path& folder);

/// The module of a configuration: NAME.so in the folder of the cores, or in that of the environment variable
/// STEREO_CORES. Stays loaded. Throws NoCoreModule with one sentence when it is not there.
const CoreModule& core_module(const std::string& name);

/// The module in a file.
const CoreModule& load_core_module(const std::filesystem::path& file);

}  // namespace stereo
