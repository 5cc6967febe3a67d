// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "engines/clocked/core_modules.hpp"

namespace stereo {

struct CoreCheck {
   int maps = 0;         ///< that were compared
   std::string problem;  ///< the first difference; empty when there is none
};

/// Compares a core with its family's definition: frames back to back at the stated gap and further apart, broken frames
/// before whole ones, resets anywhere, all with and without bubbles, and each output at its clock.
CoreCheck check_core(const CoreModule& core, uint64_t seed);

}  // namespace stereo
