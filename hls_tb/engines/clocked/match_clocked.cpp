// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/match_clocked.hpp"

#include "engines/clocked/run_core.hpp"

namespace stereo {

namespace {

template <class Pair>
DisparityMap match(const CoreModule& core, const Pair& pair) {
   const Stimulus stimulus = make_stimulus(core.name, core.shape, pair);
   std::vector<DisparityMap> frames = collect_frames(run_core(core, stimulus.clocks), core.shape);
   if (frames.size() != 1)
      throw std::runtime_error("the clocked core gave " + std::to_string(frames.size()) + " frames");
   return std::move(frames.front());
}

}  // namespace

DisparityMap match_clocked(const CoreModule& core, const ImagePair& pair) { return match(core, pair); }
DisparityMap match_clocked(const CoreModule& core, const DeepPair& pair) { return match(core, pair); }

}  // namespace stereo
