// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// `stereo_hls options`: lists the options of each family with their defaults and limits, also as JSON for scripts.
void add_options(CLI::App& app);

}  // namespace stereo::app
