// SPDX-License-Identifier: Apache-2.0
// Options that say which stream a pair of images becomes, clock by clock.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "engines/clocked/stimulus.hpp"
#include "program/io/images.hpp"

namespace stereo::app {

struct StreamArguments {
   std::string left, right;
   std::string rows;  ///< "A:B"; empty for all
   Fit fit = Fit::none;
   StimulusOptions options;
   int broken = 0;  ///< events of a broken stream instead of frames
};

void add_stream_options(CLI::App& command, StreamArguments& arguments);

/// Throws InputError with one sentence when the images or rows do not fit the core.
Stimulus make_stream(const StreamArguments& arguments, const std::string& config, const CoreShape& shape);

}  // namespace stereo::app
