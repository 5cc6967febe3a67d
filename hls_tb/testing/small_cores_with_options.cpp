// SPDX-License-Identifier: Apache-2.0
#include "testing/small_cores.hpp"

namespace stereo::test {
namespace {

/// At least two of the blocks that are not in every core each, in images as narrow and low as they may be.
using OptionConfigs =
    ::testing::Types<Exactly<block_matching::Config{{.width_px = 8, .height_px = 2},
                                                    {.disparities = 3,
                                                     .window_px = 2,
                                                     .prefilter = Prefilter::xsobel,
                                                     .ties = Ties::largest,
                                                     .left_right_threshold = 0,
                                                     .texture_threshold = 40,
                                                     .median = true},
                                                    {.slice_disparities = 2}}>,
                     Exactly<block_matching::Config{{.width_px = 9, .height_px = 8, .pixels_per_clock = 4},
                                                    {.disparities = 8,
                                                     .reference = Reference::left,
                                                     .cost = Cost::census,
                                                     .census_width_px = 3,
                                                     .census_height_px = 3,
                                                     .left_right_threshold = 1,
                                                     .subpixel = true,
                                                     .median = true},
                                                    {.slice_disparities = 25}}>,
                     Exactly<block_matching::Config{{.width_px = 14, .height_px = 8, .pixels_per_clock = 2},
                                                    {.disparities = 5,
                                                     .window_px = 7,
                                                     .min_disparity = -2,
                                                     .cost = Cost::ssd,
                                                     .prefilter = Prefilter::xsobel,
                                                     .prefilter_cap = 10,
                                                     .uniqueness_percent = 30,
                                                     .subpixel = true},
                                                    {.aggregation = Aggregation::recursive, .slice_disparities = 3}}>>;

}  // namespace

void add_option_cores(std::vector<SmallCore>& cores) {
   add_cores(cores, RecursiveConfigs());
   add_cores(cores, OptionConfigs());
}

}  // namespace stereo::test
