// SPDX-License-Identifier: Apache-2.0
// The whole core against the reference, for each kind of image, after each stage.
#include "stereo_core.hpp"

#include <cstdlib>
#include <filesystem>

#include "app/images.hpp"
#include "models/scene.hpp"
#include "support/map_compare.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"
#include "support/test_pairs.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {
namespace {

template <const StereoConfig& C>
std::vector<StereoInput> frame_clocks(const ImagePair& pair, int stall_percent) {
   StimulusWriter writer(stall_percent, test_seed());
   writer.rows(pair, {0, C.height_px});
   writer.flush(C);
   writer.drain(StereoCore<C>::kLatency);
   return writer.clocks;
}

/// Gathers what two stages of the core show, in the order in which they show it.
template <const StereoConfig& C>
struct StageRecorder {
   std::vector<int> columns, sums;

   void operator()(const StereoCore<C>& core) {
      if (core.cost.tag.valid && core.cost.tag.cost_column)
         columns.insert(columns.end(), std::begin(core.cost.column), std::end(core.cost.column));
      if (core.window.tag.valid && core.window.tag.output_column)
         sums.insert(sums.end(), std::begin(core.window.sum), std::end(core.window.sum));
   }
};

template <const StereoConfig& C>
void expect_exact(const ImagePair& pair, int stall_percent) {
   const CostVolume costs = pixel_costs(pair.left, pair.right, {C.disparities, C.window_px});
   const CostVolume expected_columns = column_sums(costs, C.window_px);
   const CostVolume expected_sums = window_sums(costs, C.window_px);

   StageRecorder<C> stages;
   const auto outputs = run_core<C>(frame_clocks<C>(pair, stall_percent), std::ref(stages));

   CostVolume columns(C.width_px - C.disparities + 1, C.height_px, C.disparities);
   // The first r rows of columns are windows above the image.
   const std::size_t above = std::size_t(C.radius_px()) * std::size_t(columns.width) * std::size_t(C.disparities);
   ASSERT_GE(stages.columns.size(), above);
   columns.values.assign(stages.columns.begin() + std::ptrdiff_t(above), stages.columns.end());
   EXPECT_TRUE(same_volume(expected_columns, columns)) << "column sums";

   CostVolume sums(C.output_width_px(), C.output_height_px(), C.disparities);
   sums.values = std::move(stages.sums);
   EXPECT_TRUE(same_volume(expected_sums, sums)) << "window sums";

   const auto maps = collect_frames(outputs, C);
   ASSERT_EQ(maps.size(), 1u);
   EXPECT_TRUE(same_map(winners(expected_sums), maps[0])) << "disparities";
}

template <class Config>
class StereoCoreTest : public ::testing::Test {};
TYPED_TEST_SUITE(StereoCoreTest, SmallConfigs);

template <const StereoConfig& C>
void equals_the_reference_after_every_stage() {
   for (const NamedPair& pair : test_pairs(C.width_px, C.height_px, C.disparities, test_seed()))
      for (const int stall_percent : {0, 30}) {
         SCOPED_TRACE(pair.name + ", " + std::to_string(stall_percent) + " % stalls");
         expect_exact<C>(pair.images, stall_percent);
      }
}

TYPED_TEST(StereoCoreTest, EqualsTheReferenceAfterEveryStage) {
   equals_the_reference_after_every_stage<TypeParam::kConfig>();
}

TEST(StereoCore, EqualsTheReferenceAtAnAwkwardSize) {
   expect_exact<kAwkward>(random_pair(kAwkward.width_px, kAwkward.height_px, test_seed(), 16), 20);
}

TEST(StereoCore, EqualsTheReferenceAtThePapersSize) {
   const SceneOptions options{.width = configurations::ambrosch2007.width_px,
                              .height = configurations::ambrosch2007.height_px,
                              .disparities = configurations::ambrosch2007.disparities,
                              .seed = test_seed()};
   expect_exact<configurations::ambrosch2007>(make_scene(options).images, 0);
}

TEST(StereoCore, FindsAKnownShift) {
   for (const int disparity : {0, 1, 17, 36}) {
      const auto maps =
          collect_frames(run_core<kAwkward>(frame_clocks<kAwkward>(
                             shifted_pair(kAwkward.width_px, kAwkward.height_px, disparity, test_seed()), 0)),
                         kAwkward);
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(GrayImage(kAwkward.output_width_px(), kAwkward.height_px, uint8_t(disparity)), maps[0]));
   }
}

inline constexpr StereoConfig kTeddy{.width_px = 450, .height_px = 375, .disparities = 60, .window_px = 5};

TEST(StereoCore, EqualsTheReferenceOnARealPair) {
   const char* const data = std::getenv("STEREO_DATA");
   const std::filesystem::path folder =
       std::filesystem::path(data != nullptr ? data : STEREO_SOURCE_DIR "/../shared/data/stereo") / "teddy";
   if (!std::filesystem::exists(folder / "left.png"))
      GTEST_SKIP() << "SKIP: the stereo pair teddy is missing; set STEREO_DATA to the folder that holds teddy/left.png";
   const ImagePair pair = app::load_pair(folder / "left.png", folder / "right.png");
   expect_exact<kTeddy>(pair, 0);

   // The truth, four times the disparity and 0 where unknown: most pixels must be right within one.
   const GrayImage truth = app::load_gray(folder / "disp_right_x4.pgm");
   const GrayImage map = match_reference(pair.left, pair.right, {kTeddy.disparities, kTeddy.window_px});
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
