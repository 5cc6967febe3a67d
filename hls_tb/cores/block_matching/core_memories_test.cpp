// SPDX-License-Identifier: Apache-2.0
// The numbers of a whole core's memories.
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <vector>

#include "block_matching/config.hpp"
#include "block_matching/configurations.hpp"
#include "block_matching/core.hpp"

namespace stereo::test {
namespace {

/// Gives memories and keeps the numbers that were asked for.
struct NumberedMemories {
   std::vector<int> numbers;

   template <class Word, int Depth, int Number>
   Word (&words())[Depth] {
      static Word memory[Depth];
      numbers.push_back(Number);
      return memory;
   }
};

/// One memory for two banks would be a fault that small images need not show.
template <const block_matching::Config& C>
void no_number_serves_twice() {
   NumberedMemories memories;
   const auto core = std::make_unique<block_matching::Core<C>>(memories);
   const std::set<int> numbers(memories.numbers.begin(), memories.numbers.end());
   EXPECT_EQ(numbers.size(), memories.numbers.size());
   EXPECT_GT(numbers.size(), 1u);
}

/// Every bank there is, as large as they get: 31x31 windows, 256 disparities in one slice, four rows at once.
inline constexpr block_matching::Config kLargest{
    {.width_px = 400, .height_px = 40, .pixels_per_clock = 4},
    {DisparityCount{256}, MatchingWindow{31}, Prefiltering{.prefilter = Prefilter::xsobel}, LeftRightThreshold{1},
     block_matching::TextureThreshold{1}, SubpixelSteps{true}, MedianFilter{true}},
    {Summation{Aggregation::recursive}, SliceSize{256}}};
/// The same in the smallest slices.
inline constexpr block_matching::Config kMostSlices{{.width_px = 400, .height_px = 40, .pixels_per_clock = 4},
                                                    {DisparityCount{24}, MatchingWindow{31}},
                                                    {Summation{Aggregation::recursive}, SliceSize{2}}};
/// The widest words: 62 bits of census in each of 31 stored rows.
inline constexpr block_matching::Config kWidest{
    {.width_px = 40, .height_px = 36, .pixels_per_clock = 4},
    {DisparityCount{16}, MatchingWindow{31}, SmallestDisparity{3}, Comparison{Cost::census},
     CensusWindow{.census_width_px = 9, .census_height_px = 7}, LeftRightThreshold{1}, MedianFilter{true}},
    {SliceSize{16}}};

TEST(CoreMemories, NoNumberServesTwoMemoriesOfACore) {
   no_number_serves_twice<block_matching::configurations::tiny_all_recursive>();
   no_number_serves_twice<kLargest>();
   no_number_serves_twice<kMostSlices>();
   no_number_serves_twice<kWidest>();
}

}  // namespace
}  // namespace stereo::test
