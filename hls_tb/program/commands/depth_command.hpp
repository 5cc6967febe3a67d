// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `depth`: cameras' images and their calibration become a depth image and a point cloud.
void add_depth(CLI::App& app);

}  // namespace stereo::app
