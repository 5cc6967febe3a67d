// SPDX-License-Identifier: Apache-2.0
// Must not compile: a core of a configuration whose one wrong member comes with -DSTEREO_WRONG="member=value".
// tests.cmake holds the sentence that the compiler must then show. -DSTEREO_WRONG="winner_group=4" compiles: nothing
// else is wrong here.
#include "block_matching/config.hpp"
#include "block_matching/core.hpp"

namespace {
constexpr stereo::block_matching::Config changed() {
   stereo::block_matching::Config config{{.width_px = 320, .height_px = 240}, {stereo::DisparityCount{100}}, {}};
   config.STEREO_WRONG;
   return config;
}
constexpr stereo::block_matching::Config kConfig = changed();
static_assert(stereo::block_matching::Core<kConfig>::kSchedule.latency_clocks > 0);
}  // namespace
