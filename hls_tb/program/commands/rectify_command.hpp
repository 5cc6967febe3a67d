// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `rectify`: a calibration becomes the tables of the rectification in hardware, and images what it makes
/// of them.
void add_rectify(CLI::App& app);

}  // namespace stereo::app
