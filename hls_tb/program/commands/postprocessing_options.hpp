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
                                               "mark speckles of up to this many pixels as invalid in " + of +
                                                   ", as cv::filterSpeckles does; 0: off")
                                   ->check(CLI::Range(0, 1000000000))
                                   ->capture_default_str();
   command
       .add_option("--speckle-range", options.speckle_range_px,
                   "largest difference of neighbours in a speckle, in pixels")
       ->check(CLI::Range(0, 256))
       ->capture_default_str()
       ->needs(window);
   command
       .add_option("--least-confidence", options.least_confidence,
                   "mark pixels of less confidence as invalid, 0 ... 255; 0: off. With the option confidence it is "
                   "the configuration's own")
       ->check(CLI::Range(0, kLargestConfidence))
       ->capture_default_str();
   command
       .add_option(
           "--surest", options.surest_percent,
           "percent of the map's pixels that stay, those of the most confidence, and others of as much; evaluate takes "
           "them of the pixels that it counts")
       ->check(CLI::Range(1, 100))
       ->capture_default_str();
   command.add_flag("--measured-only", options.measured_only,
                    "pixels that the configuration's option fill_holes has filled count as invalid");
}

}  // namespace stereo::app
