// SPDX-License-Identifier: Apache-2.0
// Options of the commands that do something with a map after the matching.
#pragma once

#include <CLI/CLI.hpp>

#include "program/postprocessing/confidence.hpp"
#include "program/postprocessing/postprocessing.hpp"

namespace stereo::app {

/// `of`: whose maps, for --help.
inline void add_postprocessing_options(CLI::App& command, Postprocessing& options, const std::string& of = "the map") {
   CLI::Option* const window = command
                                   .add_option("--speckle-window", options.speckle_window_px,
                                               "pixels of the largest speckle that becomes invalid in " + of +
                                                   ", as cv::filterSpeckles does it; 0: none")
                                   ->check(CLI::Range(0, 1000000000))
                                   ->capture_default_str();
   command
       .add_option("--speckle-range", options.speckle_range_px, "pixels by which neighbours in a speckle may differ")
       ->check(CLI::Range(0, 256))
       ->capture_default_str()
       ->needs(window);
   command
       .add_option("--least-confidence", options.least_confidence,
                   "pixels of less confidence become invalid; 0: none, 255: all but the surest")
       ->check(CLI::Range(0, kLargestConfidence))
       ->capture_default_str();
}

}  // namespace stereo::app
