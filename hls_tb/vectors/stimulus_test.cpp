// SPDX-License-Identifier: Apache-2.0
#include "vectors/stimulus.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/map_compare.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"
#include "support/test_pairs.hpp"
#include "vectors/matching_parameters.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {
namespace {

template <const StereoConfig& C>
Stimulus stimulus(const StimulusOptions& options) {
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   return make_stimulus("tiny", C, StereoCore<C>::kLatency, pair, options);
}

std::ptrdiff_t valid_clocks(const Stimulus& made) {
   return std::ranges::count_if(made.clocks, [](const StereoInput& in) { return in.valid; });
}

template <int P, int B>
using StimulusConfig = Config<32, 16, 8, B, P, 3, 3, 2>;

template <class Config>
class StimulusTest : public ::testing::Test {};
using Configs = ::testing::Types<StimulusConfig<1, 3>, StimulusConfig<2, 3>, StimulusConfig<4, 3>, StimulusConfig<1, 5>,
                                 StimulusConfig<2, 5>, StimulusConfig<4, 5>>;
TYPED_TEST_SUITE(StimulusTest, Configs, ConfigNames);

TYPED_TEST(StimulusTest, WholeFramesAreFlushedAndDrained) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const Stimulus made = stimulus<TypeParam::kConfig>({.frames = 2});
   EXPECT_EQ(made.pixels_per_clock, C.pixels_per_clock);
   const int frame = C.width_px * C.height_px / C.pixels_per_clock;
   const std::ptrdiff_t records = 2 * frame + C.delay_groups() * C.width_px + C.radius_px();
   EXPECT_EQ(valid_clocks(made), records);
   EXPECT_EQ(std::ssize(made.clocks), records + StereoCore<TypeParam::kConfig>::kLatency + 4);
   for (std::size_t i = 0; i < made.clocks.size(); ++i) {
      if (!made.clocks[i].valid) continue;
      ASSERT_EQ(made.clocks[i].start_of_frame, i == 0 || i == std::size_t(frame)) << "clock " << i;
   }
}

TYPED_TEST(StimulusTest, RecordsAreColumnsOfNeighbouringRows) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   const Stimulus made = stimulus<TypeParam::kConfig>({});
   for (int y = 0; y < C.height_px; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         const int group = y / C.pixels_per_clock, lane = y % C.pixels_per_clock;
         const StereoInput& in = made.clocks[std::size_t(group * C.width_px + x)];
         ASSERT_EQ(in.left[lane], pair.left.at(x, y)) << "x=" << x << " y=" << y;
         ASSERT_EQ(in.right[lane], pair.right.at(x, y)) << "x=" << x << " y=" << y;
      }
}

TYPED_TEST(StimulusTest, GarbageIsOnTheLanesInUseOnly) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   StimulusWriter writer(C.pixels_per_clock, 50, test_seed());
   writer.random_records(200);
   for (const bool valid : {false, true})
      for (int p = 0; p < kMostPixels; ++p) {
         const auto has_garbage = [&](const StereoInput& in) {
            return in.valid == valid && (in.left[p] != 0 || in.right[p] != 0);
         };
         EXPECT_EQ(std::ranges::any_of(writer.clocks, has_garbage), p < C.pixels_per_clock) << "lane " << p;
      }
}

TYPED_TEST(StimulusTest, OddFramesAreUpsideDown) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   const Stimulus made = stimulus<TypeParam::kConfig>({.frames = 3});
   ImagePair flipped = pair;
   for (int y = 0; y < C.height_px; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         flipped.left.at(x, y) = pair.left.at(x, C.height_px - 1 - y);
         flipped.right.at(x, y) = pair.right.at(x, C.height_px - 1 - y);
      }
   const auto maps = collect_frames(run_core<TypeParam::kConfig>(made.clocks), C);
   ASSERT_EQ(maps.size(), 3u);
   for (std::size_t i = 0; i < 3; ++i) {
      const ImagePair& shown = i % 2 == 0 ? pair : flipped;
      EXPECT_TRUE(same_map(match_reference(shown.left, shown.right, matching_parameters(C)), maps[i])) << i;
   }
}

TYPED_TEST(StimulusTest, RowsAreTheTopOfAFrame) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   constexpr int kHeight = 8, kFirst = 3, kLatency = StereoCore<TypeParam::kConfig>::kLatency;
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   const Stimulus made =
       stimulus<TypeParam::kConfig>({.rows = RowRange{kFirst, kFirst + kHeight}, .stall_percent = 30});
   EXPECT_EQ(valid_clocks(made), C.width_px * kHeight / C.pixels_per_clock);
   EXPECT_FALSE(std::ranges::any_of(made.clocks.end() - kLatency - 4, made.clocks.end(), &StereoInput::valid));
   GrayImage left(C.width_px, kHeight), right(C.width_px, kHeight);
   std::copy_n(pair.left.row(kFirst), left.pixels.size(), left.pixels.begin());
   std::copy_n(pair.right.row(kFirst), right.pixels.size(), right.pixels.begin());
   const DisparityMap expected = match_reference(left, right, matching_parameters(C));
   // Without the records after its last row, the last groups stay inside; in wide windows also the last r - 1 columns
   // of the group before them.
   const int height = kHeight - C.delay_groups() * C.pixels_per_clock, hidden = C.radius_px() - 1;
   DisparityMap seen(expected.width, height), got(expected.width, height);
   std::copy_n(expected.disparity.begin(), seen.disparity.size(), seen.disparity.begin());
   for (int y = height - C.pixels_per_clock; y < height; ++y)
      std::fill_n(seen.disparity.begin() + (y + 1) * seen.width - hidden, hidden, uint16_t(0));
   const auto outputs = run_core<TypeParam::kConfig>(made.clocks);
   ASSERT_EQ(int(outputs.size()), expected.width * height / C.pixels_per_clock - hidden);
   for (const CoreOutput& output : outputs)
      for (int p = 0; p < C.pixels_per_clock; ++p) got.at(output.x, output.y + p) = output.disparity[std::size_t(p)];
   EXPECT_TRUE(same_map(seen, got));
}

TYPED_TEST(StimulusTest, TheSmallestCropGivesOutputsAndASmallerOneIsRefused) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   constexpr int P = C.pixels_per_clock, kLeast = (C.delay_groups() + 1) * P;
   EXPECT_GE(
       run_core<TypeParam::kConfig>(stimulus<TypeParam::kConfig>({.rows = RowRange{1, 1 + kLeast}}).clocks).size(), 1u);
   EXPECT_THROW(stimulus<TypeParam::kConfig>({.rows = RowRange{1, 1 + kLeast - P}}), std::invalid_argument);
   if (P > 1) {
      EXPECT_THROW(stimulus<TypeParam::kConfig>({.rows = RowRange{0, kLeast + 1}}), std::invalid_argument);
   }
}

TEST(Stimulus, TheSmallestCropOfWideWindowsInNarrowImagesIsAGroupLarger) {
   static constexpr StereoConfig C = Config<10, 8, 9, 5, 1, 9, 1, 2>::kConfig;  // one column of outputs
   EXPECT_THROW(stimulus<C>({.rows = RowRange{0, 3}}), std::invalid_argument);
   EXPECT_GE(run_core<C>(stimulus<C>({.rows = RowRange{0, 4}}).clocks).size(), 1u);
}

TYPED_TEST(StimulusTest, AllRowsAreAWholeFrame) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const Stimulus rows = stimulus<TypeParam::kConfig>({.rows = RowRange{0, C.height_px}});
   EXPECT_EQ(collect_frames(run_core<TypeParam::kConfig>(rows.clocks), C).size(), 1u);
}

TYPED_TEST(StimulusTest, StallsAddBubblesWithGarbageAndChangeNothingElse) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const Stimulus full_speed = stimulus<TypeParam::kConfig>({}),
                  stalled = stimulus<TypeParam::kConfig>({.stall_percent = 50});
   EXPECT_EQ(valid_clocks(full_speed), valid_clocks(stalled));
   EXPECT_GT(stalled.clocks.size(), full_speed.clocks.size() * 3 / 2);
   const auto bubble_that_starts = [](const StereoInput& in) { return !in.valid && in.start_of_frame; };
   EXPECT_TRUE(std::ranges::any_of(stalled.clocks, bubble_that_starts));
   const auto expected = collect_frames(run_core<TypeParam::kConfig>(full_speed.clocks), C);
   const auto got = collect_frames(run_core<TypeParam::kConfig>(stalled.clocks), C);
   ASSERT_EQ(got.size(), 1u);
   EXPECT_TRUE(same_map(expected.at(0), got[0]));
}

TEST(Stimulus, RejectsWhatDoesNotFit) {
   using configurations::tiny;
   EXPECT_THROW(stimulus<tiny>({.frames = 0}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.stall_percent = 96}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.stall_percent = -1}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.rows = RowRange{-1, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.rows = RowRange{4, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.rows = RowRange{0, tiny.height_px + 1}}), std::invalid_argument);
   EXPECT_THROW(stimulus<tiny>({.rows = RowRange{4, 5}}), std::invalid_argument) << "one row gives no output";
   EXPECT_THROW(make_stimulus("tiny", tiny, 10, random_pair(33, 12, 1)), std::invalid_argument);
}

TYPED_TEST(StimulusTest, CollectFramesRefusesOutputsOutOfPlace) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const auto good = run_core<TypeParam::kConfig>(stimulus<TypeParam::kConfig>({}).clocks);
   EXPECT_EQ(collect_frames(good, C).size(), 1u);
   auto missing = good;
   missing.pop_back();
   EXPECT_THROW(collect_frames(missing, C), std::runtime_error);
   for (const auto spoil :
        {+[](CoreOutput& o) { ++o.x; }, +[](CoreOutput& o) { ++o.y; }, +[](CoreOutput& o) { ++o.frame; },
         +[](CoreOutput& o) { o.start_of_frame = !o.start_of_frame; },
         +[](CoreOutput& o) { o.end_of_line = !o.end_of_line; }}) {
      auto spoilt = good;
      spoil(spoilt[37]);
      EXPECT_THROW(collect_frames(spoilt, C), std::runtime_error);
   }
}

}  // namespace
}  // namespace stereo::test
