// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `match`: the disparity map of a rectified pair.
void add_match(CLI::App& app);

}  // namespace stereo::app
