// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `video`: the disparity of each pair of frames, in colour beside the input.
void add_video(CLI::App& app);

}  // namespace stereo::app
