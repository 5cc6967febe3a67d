// SPDX-License-Identifier: Apache-2.0
// The whole core at sizes and disparity ranges beyond those of the small and the named ones.
#include "block_matching/config.hpp"
#include "testing/expect_reference.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class LargeStereoCoreTest : public ::testing::Test {};
/// The largest disparity ranges, windows and costs.
using LargeConfigs = ::testing::Types<
    Config<270, 4, 256, 3, 1, 25, 3, 2>, Config<270, 8, 256, 3, 2, 100, 2, 16>,
    Exactly<block_matching::Config{{.width_px = 70, .height_px = 40, .pixels_per_clock = 2},
                                   {DisparityCount{33}, MatchingWindow{31}, ReferenceImage{Reference::left},
                                    Comparison{Cost::ssd}, LeftRightThreshold{1}, SubpixelSteps{true}},
                                   {Summation{Aggregation::recursive}, SliceSize{16}}}>,
    Exactly<block_matching::Config{{.width_px = 290, .height_px = 12},
                                   {DisparityCount{256}, MatchingWindow{10}, SmallestDisparity{-100},
                                    Comparison{Cost::census}, CensusWindow{.census_width_px = 9, .census_height_px = 7},
                                    LeftRightThreshold{2}, UniquenessPercent{5}, MedianFilter{true}},
                                   {Summation{Aggregation::recursive}, SliceSize{64}, WinnerGroup{4}}}>>;
TYPED_TEST_SUITE(LargeStereoCoreTest, LargeConfigs, ConfigNames);

TYPED_TEST(LargeStereoCoreTest, EqualsTheReference) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   for (const NamedPair& pair : test_pairs(C.width_px, C.height_px, C.disparities, test_seed())) {
      SCOPED_TRACE(pair.name);
      expect_reference<C>(pair.images, 10);
   }
}

inline constexpr block_matching::Config kAwkward{
    {.width_px = 311, .height_px = 239}, {DisparityCount{37}}, {WinnerGroup{7}}};

TEST(StereoCore, EqualsTheReferenceAtAnAwkwardSize) {
   expect_reference<kAwkward>(random_pair(kAwkward.width_px, kAwkward.height_px, test_seed(), 16), 20);
}

TEST(StereoCore, FindsAKnownShift) {
   for (const int disparity : {0, 1, 17, 36}) {
      const ImagePair pair = shifted_pair(kAwkward.width_px, kAwkward.height_px, disparity, test_seed());
      EXPECT_TRUE(same_map(DisparityMap(kAwkward.output_width_px(), kAwkward.height_px, uint16_t(disparity)),
                           core_map<kAwkward>(pair)));
   }
}

}  // namespace
}  // namespace stereo::test
