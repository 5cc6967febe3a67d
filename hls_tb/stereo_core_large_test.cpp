// SPDX-License-Identifier: Apache-2.0
// The whole core at sizes and disparity ranges beyond those of the small and the named ones.
#include <cstdlib>
#include <filesystem>

#include "app/images.hpp"
#include "models/scene.hpp"
#include "stereo_core.hpp"
#include "support/map_compare.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"
#include "support/test_pairs.hpp"
#include "vectors/matching_parameters.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {
namespace {

template <const StereoConfig& C>
DisparityMap core_map(const ImagePair& pair, int stall_percent = 0) {
   StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed());
   writer.rows(pair, {0, C.height_px});
   writer.flush(C);
   writer.drain(StereoCore<C>::kLatency);
   const auto maps = collect_frames(run_core<C>(writer.clocks), C);
   EXPECT_EQ(maps.size(), 1u);
   return maps.empty() ? DisparityMap() : maps[0];
}

template <const StereoConfig& C>
void expect_reference(const ImagePair& pair, int stall_percent = 0) {
   EXPECT_TRUE(
       same_map(match_reference(pair.left, pair.right, matching_parameters(C)), core_map<C>(pair, stall_percent)));
}

template <class Config>
class LargeStereoCoreTest : public ::testing::Test {};
/// The largest disparity ranges, windows and costs.
using LargeConfigs = ::testing::Types<Config<270, 4, 256, 3, 1, 25, 3, 2>, Config<270, 8, 256, 3, 2, 100, 2, 16>,
                                      Exactly<StereoConfig{.width_px = 70,
                                                           .height_px = 40,
                                                           .disparities = 33,
                                                           .window_px = 31,
                                                           .pixels_per_clock = 2,
                                                           .reference = Reference::left,
                                                           .cost = Cost::ssd,
                                                           .left_right_threshold = 1,
                                                           .subpixel = true,
                                                           .aggregation = Aggregation::recursive,
                                                           .slice_disparities = 16}>,
                                      Exactly<StereoConfig{.width_px = 290,
                                                           .height_px = 12,
                                                           .disparities = 256,
                                                           .window_px = 10,
                                                           .min_disparity = -100,
                                                           .cost = Cost::census,
                                                           .census_width_px = 9,
                                                           .census_height_px = 7,
                                                           .left_right_threshold = 2,
                                                           .uniqueness_percent = 5,
                                                           .median = true,
                                                           .aggregation = Aggregation::recursive,
                                                           .slice_disparities = 64,
                                                           .winner_group = 4}>>;
TYPED_TEST_SUITE(LargeStereoCoreTest, LargeConfigs, ConfigNames);

TYPED_TEST(LargeStereoCoreTest, EqualsTheReference) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   for (const NamedPair& pair : test_pairs(C.width_px, C.height_px, C.disparities, test_seed())) {
      SCOPED_TRACE(pair.name);
      expect_reference<C>(pair.images, 10);
   }
}

inline constexpr StereoConfig kAwkward{.width_px = 311, .height_px = 239, .disparities = 37, .winner_group = 7};

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

inline constexpr StereoConfig kTeddy{.width_px = 450, .height_px = 375, .disparities = 60, .window_px = 5};
/// Its rows as far as they fill groups of four.
inline constexpr StereoConfig kTeddyTop{
    .width_px = 450, .height_px = 372, .disparities = 60, .window_px = 5, .pixels_per_clock = 4};

GrayImage top_rows(GrayImage image, int height) {
   image.height = height;
   image.pixels.resize(std::size_t(image.width) * std::size_t(height));
   return image;
}

TEST(StereoCore, EqualsTheReferenceOnARealPair) {
   const char* const data = std::getenv("STEREO_DATA");
   const std::filesystem::path folder =
       std::filesystem::path(data != nullptr ? data : STEREO_SOURCE_DIR "/../shared/data/stereo") / "teddy";
   if (!std::filesystem::exists(folder / "left.png"))
      GTEST_SKIP() << "SKIP: the stereo pair teddy is missing; set STEREO_DATA to the folder that holds teddy/left.png";
   const ImagePair pair = app::load_pair(folder / "left.png", folder / "right.png");
   expect_reference<kTeddy>(pair);
   expect_reference<kTeddyTop>({top_rows(pair.left, kTeddyTop.height_px), top_rows(pair.right, kTeddyTop.height_px)});

   // The truth, four times the disparity and 0 where unknown: most pixels must be right within one.
   const GrayImage truth = app::load_gray(folder / "disp_right_x4.pgm");
   const DisparityMap map = match_reference(pair.left, pair.right, matching_parameters(kTeddy));
   int known = 0, good = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (truth.at(x, y) == 0) continue;
         ++known;
         good += std::abs(4 * map.at(x, y) - truth.at(x, y)) <= 4 ? 1 : 0;
      }
   RecordProperty("good_percent", 100 * good / known);
   EXPECT_GT(100 * good, 60 * known) << good << " of " << known << " pixels";
}

}  // namespace
}  // namespace stereo::test
