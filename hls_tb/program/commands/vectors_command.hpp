// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// `stereo_hls vectors`: makes test vectors for the hardware.
void add_vectors(CLI::App& app);

}  // namespace stereo::app
