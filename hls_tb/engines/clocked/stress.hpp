// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "engines/clocked/stimulus.hpp"

namespace stereo {

/// The stream that is made to find faults in a core: frames of each class of stress_pairs.hpp, at first whole, at the
/// least gap and without bubbles, then with bubbles, broken off, behind resets, behind records without a start, each
/// with settings of its own, and of other sizes, where the core has such ports. Of one whose frames are long, the first
/// rows of each. That is a stream of some 25,000 clocks for a small core; streams of other seeds follow until there are
/// `clocks` of them at least: what one misses, another one shows most often. The last one has what they meet too
/// seldom: starts in the clock behind each row of the flush, each size that the ports can bring, costs that lie as far
/// apart as they can, and `own`, the pairs of the core's family, of the size of its images. docs/cosimulation.md has
/// its score. Other seeds give other streams.
Stimulus make_stress_stimulus(const std::string& config_name, const CoreShape& core, uint64_t seed,
                              std::size_t clocks = 1, const std::vector<DeepPair>& own = {});

/// Puts a stimulus behind another one of the same core, with a clock of reset between them. Returns the clock in which
/// it begins.
uint64_t append(Stimulus& stimulus, Stimulus next);

}  // namespace stereo
