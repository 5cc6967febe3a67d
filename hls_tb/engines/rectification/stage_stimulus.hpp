// SPDX-License-Identifier: Apache-2.0
// What goes into a rectification core and what comes out of it, clock by clock.
#pragma once

#include <cstdint>
#include <vector>

#include "engines/clocked/register_trace.hpp"
#include "engines/clocked/stimulus.hpp"
#include "engines/rectification/stages.hpp"

namespace stereo {

struct StageClock {
   WideInput in;
   rectification::TableWrite node;
   bool reset = false;
};

/// A pixel pair that leaves. Between frames and before the first one, rows and columns are counted on.
struct StageOutput {
   uint64_t clock = 0;
   int x = 0, y = 0, frame = 0;
   uint16_t left = 0, right = 0;
   bool start_of_frame = false;
};

/// The stream of a core of the same size, with random tables: both are loaded at first and after each reset, and now
/// and then a node is written while frames are under way. Offsets are small or lead anywhere.
std::vector<StageClock> make_stage_stimulus(const Stage& stage, const Stimulus& stream, uint64_t seed);

/// The valid outputs of a core that starts from reset.
std::vector<StageOutput> run_stage(const Stage& stage, const std::vector<StageClock>& clocks);

/// Traces all ports and registers, the clocks from `first` on, as trace_core does.
void trace_stage(const Stage& stage, const std::vector<StageClock>& clocks, std::ostream& out, uint64_t first = 0);

/// The same over so many clocks: random pixels with bubbles, frames as close as they may be, and
/// nodes that are written again and again.
void trace_stage(const Stage& stage, int clocks, std::ostream& out);

}  // namespace stereo
