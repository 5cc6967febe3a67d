// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// `stereo_hls configurations`: lists the named configurations, also as JSON for scripts.
void add_configurations(CLI::App& app);

}  // namespace stereo::app
