// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// `stereo_hls trace`: traces all registers of a clocked core.
void add_trace(CLI::App& app);

}  // namespace stereo::app
