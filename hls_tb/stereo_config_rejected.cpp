// SPDX-License-Identifier: Apache-2.0
// Must not compile: a configuration whose one wrong member comes with -DSTEREO_WRONG="member=value". tests.cmake holds
// the sentence that the compiler must then show. -DSTEREO_WRONG="winner_group=4" compiles: nothing else is wrong here.
#include "stereo_config.hpp"

namespace {
constexpr stereo::StereoConfig changed() {
   stereo::StereoConfig config{.width_px = 320, .height_px = 240, .disparities = 100};
   config.STEREO_WRONG;
   return config;
}
constexpr stereo::StereoConfig kConfig = changed();
static_assert(stereo::CheckedConfig<kConfig>::kValid);
}  // namespace
