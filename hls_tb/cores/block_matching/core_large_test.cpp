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
using LargeConfigs =
    ::testing::Types<Config<270, 4, 256, 3, 1, 25, 3, 2>, Config<270, 8, 256, 3, 2, 100, 2, 16>,
                     Exactly<block_matching::Config{{.width_px = 70, .height_px = 40, .pixels_per_clock = 2},
                                                    {.disparities = 33,
                                                     .window_px = 31,
                                                     .reference = Reference::left,
                                                     .cost = Cost::ssd,
                                                     .left_right_threshold = 1,
                                                     .subpixel = true},
                                                    {.aggregation = Aggregation::recursive, .slice_disparities = 16}}>,
                     Exactly<block_matching::Config{
                         {.width_px = 290, .height_px = 12},
                         {.disparities = 256,
                          .window_px = 10,
                          .min_disparity = -100,
                          .cost = Cost::census,
                          .census_width_px = 9,
                          .census_height_px = 7,
                          .left_right_threshold = 2,
                          .uniqueness_percent = 5,
                          .median = true},
                         {.aggregation = Aggregation::recursive, .slice_disparities = 64, .winner_group = 4}}>>;
TYPED_TEST_SUITE(LargeStereoCoreTest, LargeConfigs, ConfigNames);

TYPED_TEST(LargeStereoCoreTest, EqualsTheReference) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   for (const NamedPair& pair : test_pairs(C.width_px, C.height_px, C.disparities, test_seed())) {
      SCOPED_TRACE(pair.name);
      expect_reference<C>(pair.images, 10);
   }
}

inline constexpr block_matching::Config kAwkward{
    {.width_px = 311, .height_px = 239}, {.disparities = 37}, {.winner_group = 7}};

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
