// SPDX-License-Identifier: Apache-2.0
#include "testing/small_cores.hpp"

namespace stereo::test {
namespace {

/// At least two of the blocks that are not in every core each, in images as narrow and low as they may be.
using OptionConfigs = ::testing::Types<
    Exactly<block_matching::Config{
        {.width_px = 8, .height_px = 2},
        {DisparityCount{3}, MatchingWindow{2}, Prefiltering{.prefilter = Prefilter::xsobel}, TieRule{Ties::largest},
         LeftRightThreshold{0}, block_matching::TextureThreshold{40}, MedianFilter{true}},
        {SliceSize{2}}}>,
    Exactly<block_matching::Config{{.width_px = 9, .height_px = 8, .pixels_per_clock = 4},
                                   {DisparityCount{8}, ReferenceImage{Reference::left}, Comparison{Cost::census},
                                    CensusWindow{.census_width_px = 3, .census_height_px = 3}, LeftRightThreshold{1},
                                    SubpixelSteps{true}, MedianFilter{true}},
                                   {SliceSize{25}}}>,
    Exactly<block_matching::Config{
        {.width_px = 14, .height_px = 8, .pixels_per_clock = 2},
        {DisparityCount{5}, MatchingWindow{7}, SmallestDisparity{-2}, Comparison{Cost::ssd},
         Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = 10}, UniquenessPercent{30}, SubpixelSteps{true}},
        {Summation{Aggregation::recursive}, SliceSize{3}}}>>;

}  // namespace

void add_option_cores(std::vector<SmallCore>& cores) {
   add_cores(cores, Both<FewRecursiveConfigs, MoreRecursiveConfigs>::Configs());
   add_cores(cores, OptionConfigs());
}

}  // namespace stereo::test
