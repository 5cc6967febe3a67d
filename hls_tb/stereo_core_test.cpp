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
#include "vectors/matching_parameters.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {
namespace {

template <const StereoConfig& C>
std::vector<StereoInput> frame_clocks(const ImagePair& pair, int stall_percent) {
   StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed());
   writer.rows(pair, {0, C.height_px});
   writer.flush(C);
   writer.drain(StereoCore<C>::kLatency);
   return writer.clocks;
}

/// What one stage shows of `Count` disparities, in the order in which it shows it.
template <int Pixels, int Count>
struct StageValues {
   std::vector<uint16_t> values;  ///< [record][lane][disparity]

   void append(const uint16_t (&shown)[Pixels][Count]) {
      for (const auto& lane : shown) values.insert(values.end(), std::begin(lane), std::end(lane));
   }
   /// Puts them where they belong, the disparities from `first` on; `above` groups of rows come before the image.
   void place(int above, int first, CostVolume& volume) const {
      ASSERT_EQ(values.size(), std::size_t((above * Pixels + volume.height) * volume.width * Count));
      std::size_t i = std::size_t(above * Pixels * volume.width * Count);
      for (int y = 0; y < volume.height; y += Pixels)
         for (int x = 0; x < volume.width; ++x)
            for (int p = 0; p < Pixels; ++p)
               for (int d = 0; d < Count; ++d) volume.at(x, y + p, first + d) = values[i++];
   }
};

/// Gathers what the stages of a slice, and of those below it, show.
template <const StereoConfig& C, int Disparities>
struct StageRecorder {
   using Slice = DisparitySlice<C, Disparities>;

   StageValues<C.pixels_per_clock, Slice::kCount> columns, sums;
   StageRecorder<C, Slice::kFirst> below;

   void record(const Slice& slice) {
      if (slice.cost.tag.valid && !slice.cost.tag.border_column) columns.append(slice.cost.column);
      if (slice.window.tag.valid && slice.window.tag.output_column) sums.append(slice.window.sum);
      below.record(slice.next);
   }
   void place_columns(CostVolume& volume) const {
      columns.place(C.delay_groups(), Slice::kFirst, volume);
      below.place_columns(volume);
   }
   void place_sums(CostVolume& volume) const {
      sums.place(0, Slice::kFirst, volume);
      below.place_sums(volume);
   }
};

template <const StereoConfig& C>
struct StageRecorder<C, 0> {
   void record(const DisparitySlice<C, 0>&) {}
   void place_columns(CostVolume&) const {}
   void place_sums(CostVolume&) const {}
};

template <const StereoConfig& C>
void expect_exact(const ImagePair& pair, int stall_percent) {
   const CostVolume costs = pixel_costs(pair.left, pair.right, matching_parameters(C));
   const CostVolume expected_sums = window_sums(costs, C.window_px);

   StageRecorder<C, C.disparities> stages;
   const auto outputs = run_core<C>(frame_clocks<C>(pair, stall_percent),
                                    [&stages](const StereoCore<C>& core) { stages.record(core.slices); });

   CostVolume columns(C.width_px - C.disparities + 1, C.height_px, C.disparities);
   stages.place_columns(columns);
   EXPECT_TRUE(same_volume(column_sums(costs, C.window_px), columns)) << "column sums";

   CostVolume sums(C.output_width_px(), C.output_height_px(), C.disparities);
   stages.place_sums(sums);
   EXPECT_TRUE(same_volume(expected_sums, sums)) << "window sums";

   const auto maps = collect_frames(outputs, C);
   ASSERT_EQ(maps.size(), 1u);
   EXPECT_TRUE(same_map(winners(expected_sums), maps[0])) << "disparities";
}

template <const StereoConfig& C>
void equals_the_reference_after_every_stage() {
   for (const NamedPair& pair : test_pairs(C.width_px, C.height_px, C.disparities, test_seed()))
      for (const int stall_percent : {0, 30}) {
         SCOPED_TRACE(pair.name + ", " + std::to_string(stall_percent) + " % stalls");
         expect_exact<C>(pair.images, stall_percent);
      }
}

template <class Config>
class StereoCoreTest : public ::testing::Test {};
TYPED_TEST_SUITE(StereoCoreTest, SmallConfigs, ConfigNames);

TYPED_TEST(StereoCoreTest, EqualsTheReferenceAfterEveryStage) {
   equals_the_reference_after_every_stage<TypeParam::kConfig>();
}

template <class Config>
class LargeStereoCoreTest : public ::testing::Test {};
TYPED_TEST_SUITE(LargeStereoCoreTest, LargeConfigs, ConfigNames);

TYPED_TEST(LargeStereoCoreTest, EqualsTheReferenceAfterEveryStage) {
   equals_the_reference_after_every_stage<TypeParam::kConfig>();
}

inline constexpr StereoConfig kAwkward{.width_px = 311, .height_px = 239, .disparities = 37, .winner_group = 7};

TEST(StereoCore, EqualsTheReferenceAtAnAwkwardSize) {
   expect_exact<kAwkward>(random_pair(kAwkward.width_px, kAwkward.height_px, test_seed(), 16), 20);
}

template <const StereoConfig& C>
void equals_the_reference_on_a_scene() {
   const SceneOptions options{
       .width = C.width_px, .height = C.height_px, .disparities = C.disparities, .seed = test_seed()};
   expect_exact<C>(make_scene(options).images, 0);
}

TEST(StereoCore, EqualsTheReferenceAtThePapersSize) { equals_the_reference_on_a_scene<configurations::ambrosch2007>(); }
TEST(StereoCore, EqualsTheReferenceWithTwoRowsAtOnce) {
   equals_the_reference_on_a_scene<configurations::ambrosch2007_p2>();
}
TEST(StereoCore, EqualsTheReferenceWithFourRowsAtOnce) {
   equals_the_reference_on_a_scene<configurations::ambrosch2007_p4>();
}

TEST(StereoCore, FindsAKnownShift) {
   for (const int disparity : {0, 1, 17, 36}) {
      const auto maps =
          collect_frames(run_core<kAwkward>(frame_clocks<kAwkward>(
                             shifted_pair(kAwkward.width_px, kAwkward.height_px, disparity, test_seed()), 0)),
                         kAwkward);
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(DisparityMap(kAwkward.output_width_px(), kAwkward.height_px, uint16_t(disparity)), maps[0]));
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
   expect_exact<kTeddy>(pair, 0);
   expect_exact<kTeddyTop>({top_rows(pair.left, kTeddyTop.height_px), top_rows(pair.right, kTeddyTop.height_px)}, 0);

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
