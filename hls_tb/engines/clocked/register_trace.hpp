// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "engines/clocked/clocked_core.hpp"
#include "engines/clocked/stimulus.hpp"

namespace stereo {

/// Takes what every port and register of a core shows in each clock, before the clock edge. Pixel ports are words as in
/// the vector files.
class TraceSink {
  public:
   using Value = RegisterView::Value;

   virtual ~TraceSink() = default;
   /// Once, before all clocks.
   virtual void names(const std::vector<std::string>& names) = 0;
   /// Values in the order of the names.
   virtual void clock(std::span<const Value> values) = 0;
};

/// Writes text: "stereo-hls trace 1 config=NAME clocks=N", a line with the names, then N lines of hexadecimal values,
/// -1f for -31.
std::unique_ptr<TraceSink> text_trace(const std::string& config, std::size_t clocks, std::ostream& out);

/// The clocks from `first` on.
void trace_core(const CoreModule& module, const Stimulus& stimulus, TraceSink& sink, uint64_t first = 0);

/// As text.
void trace_core(const CoreModule& module, const Stimulus& stimulus, std::ostream& out, uint64_t first = 0);

/// Random pixels with bubbles: a frame that is broken off, then frames as close as they may be, so that what only
/// happens between frames shows as well where the frames are short enough.
Stimulus make_trace_stimulus(const std::string& config, const CoreShape& shape, int clocks);

}  // namespace stereo
