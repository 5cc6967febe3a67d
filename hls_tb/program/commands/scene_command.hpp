// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// `stereo_hls scene`: makes a stereo pair with ground truth.
void add_scene(CLI::App& app);

}  // namespace stereo::app
