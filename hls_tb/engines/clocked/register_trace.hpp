// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "engines/clocked/clocked_core.hpp"
#include "engines/clocked/stimulus.hpp"

namespace stereo {

/// Writes what every port and register of a core shows in each clock, before the clock edge:
/// "stereo-hls trace 1 config=NAME clocks=N", a line with the names, then N lines of hexadecimal values, -1f for -31.
/// Pixel ports are words as in the vector files.
void trace_core(const CoreModule& module, const Stimulus& stimulus, std::ostream& out);

}  // namespace stereo
