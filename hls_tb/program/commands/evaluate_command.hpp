// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace stereo::app {

/// The command `evaluate`: our configurations, OpenCV's matchers and results from files beside ground truth.
void add_evaluate(CLI::App& app);

}  // namespace stereo::app
