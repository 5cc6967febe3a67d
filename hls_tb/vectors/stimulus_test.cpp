// SPDX-License-Identifier: Apache-2.0
#include "vectors/stimulus.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/map_compare.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"
#include "support/test_pairs.hpp"
#include "vectors/run_core.hpp"

namespace stereo::test {
namespace {

constexpr const StereoConfig& C = configurations::tiny;
constexpr int kLatency = StereoCore<C>::kLatency;

Stimulus stimulus(const StimulusOptions& options) {
   return make_stimulus("tiny", C, kLatency, random_pair(C.width_px, C.height_px, test_seed()), options);
}

std::ptrdiff_t valid_clocks(const Stimulus& made) {
   return std::ranges::count_if(made.clocks, [](const StereoInput& in) { return in.valid; });
}

TEST(Stimulus, WholeFramesAreFlushedAndDrained) {
   const Stimulus made = stimulus({.frames = 2});
   const std::ptrdiff_t pairs = 2 * C.width_px * C.height_px + C.radius_px() * C.width_px + C.radius_px();
   EXPECT_EQ(valid_clocks(made), pairs);
   EXPECT_EQ(std::ssize(made.clocks), pairs + kLatency + 4);
   for (std::size_t i = 0; i < made.clocks.size(); ++i) {
      if (!made.clocks[i].valid) continue;
      ASSERT_EQ(made.clocks[i].start_of_frame, i == 0 || i == std::size_t(C.width_px * C.height_px)) << "clock " << i;
   }
}

TEST(Stimulus, OddFramesAreUpsideDown) {
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   const Stimulus made = make_stimulus("tiny", C, kLatency, pair, {.frames = 3});
   ImagePair flipped = pair;
   for (int y = 0; y < C.height_px; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         flipped.left.at(x, y) = pair.left.at(x, C.height_px - 1 - y);
         flipped.right.at(x, y) = pair.right.at(x, C.height_px - 1 - y);
      }
   const auto maps = collect_frames(run_core<C>(made.clocks), C);
   ASSERT_EQ(maps.size(), 3u);
   for (std::size_t i = 0; i < 3; ++i) {
      const ImagePair& shown = i % 2 == 0 ? pair : flipped;
      EXPECT_TRUE(same_map(match_reference(shown.left, shown.right, {C.disparities, C.window_px}), maps[i])) << i;
   }
}

TEST(Stimulus, RowsAreTheTopOfAFrame) {
   const ImagePair pair = random_pair(C.width_px, C.height_px, test_seed());
   const RowRange rows{4, 9};
   const Stimulus made = make_stimulus("tiny", C, kLatency, pair, {.rows = rows, .stall_percent = 30});
   EXPECT_EQ(valid_clocks(made), C.width_px * 5);
   EXPECT_FALSE(std::ranges::any_of(made.clocks.end() - kLatency - 4, made.clocks.end(), &StereoInput::valid));
   GrayImage left(C.width_px, 5), right(C.width_px, 5);
   std::copy_n(pair.left.row(4), left.pixels.size(), left.pixels.begin());
   std::copy_n(pair.right.row(4), right.pixels.size(), right.pixels.begin());
   const GrayImage expected = match_reference(left, right, {C.disparities, C.window_px});
   // Without the pairs after its last row, the crop's bottom row stays inside.
   GrayImage seen(expected.width, 4), got(expected.width, 4);
   std::copy_n(expected.pixels.begin(), seen.pixels.size(), seen.pixels.begin());
   const auto outputs = run_core<C>(made.clocks);
   ASSERT_EQ(outputs.size(), got.pixels.size());
   for (const CoreOutput& output : outputs) got.at(output.x, output.y) = output.disparity;
   EXPECT_TRUE(same_map(seen, got));
}

TEST(Stimulus, AllRowsAreAWholeFrame) {
   const Stimulus rows = stimulus({.rows = RowRange{0, C.height_px}});
   EXPECT_EQ(collect_frames(run_core<C>(rows.clocks), C).size(), 1u);
}

TEST(Stimulus, StallsAddBubblesWithGarbageAndChangeNothingElse) {
   const Stimulus full_speed = stimulus({}), stalled = stimulus({.stall_percent = 50});
   EXPECT_EQ(valid_clocks(full_speed), valid_clocks(stalled));
   EXPECT_GT(stalled.clocks.size(), full_speed.clocks.size() * 3 / 2);
   const auto bubble_that_starts = [](const StereoInput& in) { return !in.valid && in.start_of_frame; };
   EXPECT_TRUE(std::ranges::any_of(stalled.clocks, bubble_that_starts));
   const auto expected = collect_frames(run_core<C>(full_speed.clocks), C);
   const auto got = collect_frames(run_core<C>(stalled.clocks), C);
   ASSERT_EQ(got.size(), 1u);
   EXPECT_TRUE(same_map(expected.at(0), got[0]));
}

TEST(Stimulus, RejectsWhatDoesNotFit) {
   EXPECT_THROW(stimulus({.frames = 0}), std::invalid_argument);
   EXPECT_THROW(stimulus({.stall_percent = 96}), std::invalid_argument);
   EXPECT_THROW(stimulus({.stall_percent = -1}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{-1, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{4, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{0, C.height_px + 1}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{4, 5}}), std::invalid_argument) << "one row gives no output";
   EXPECT_THROW(make_stimulus("tiny", C, kLatency, random_pair(33, 12, 1)), std::invalid_argument);
}

TEST(CollectFrames, RefusesOutputsOutOfPlace) {
   const auto good = run_core<C>(stimulus({}).clocks);
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
