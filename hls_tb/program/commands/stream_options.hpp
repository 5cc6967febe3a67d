// SPDX-License-Identifier: Apache-2.0
// Options that say which stream goes into a core, clock by clock.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "engines/clocked/stimulus.hpp"
#include "program/io/images.hpp"

namespace stereo::app {

struct StreamArguments {
   bool stress = false;         ///< the stream that is made to find faults; that of the images comes behind it
   int stress_clocks = 80'000;  ///< at least; three streams of a small core
   std::string left, right;
   std::string rows;  ///< "A:B"; empty for all
   Fit fit = Fit::none;
   StimulusOptions options;
   int broken = 0;  ///< events of a broken stream instead of frames
};

void add_stream_options(CLI::App& command, StreamArguments& arguments);

struct Stream {
   Stimulus stimulus;
   uint64_t images_from = 0;  ///< the clock in which the images' part begins
};

/// Throws InputError with one sentence when there is nothing to send, or when the images or rows do not fit the core.
Stream make_stream(const StreamArguments& arguments, const std::string& config, const CoreShape& shape);

}  // namespace stereo::app
