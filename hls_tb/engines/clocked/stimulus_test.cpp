// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/stimulus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "block_matching/core.hpp"
#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "engines/configurations.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

ImagePair pair_for(const Image& image) { return random_pair(image.width_px, image.height_px, test_seed()); }

std::ptrdiff_t valid_clocks(const Stimulus& made) {
   return std::ranges::count_if(made.clocks, [](const WideInput& in) { return in.valid; });
}

class StimulusTest : public ::testing::TestWithParam<const char*> {
  protected:
   const CoreModule& core() const { return core_module(GetParam()); }
   const Image& image() const { return core().shape.image; }
   const Schedule& schedule() const { return core().shape.schedule; }
   Stimulus stimulus(const StimulusOptions& options) const {
      return make_stimulus(core().name, core().shape, pair_for(image()), options);
   }
   std::vector<DisparityMap> maps(const Stimulus& made) const {
      return collect_frames(run_core(core(), made.clocks), core().shape);
   }
   DisparityMap reference_map(const ImagePair& pair) const {
      return find_configuration(GetParam())->algorithm->match_reference(pair.left, pair.right);
   }
};
INSTANTIATE_TEST_SUITE_P(Named, StimulusTest,
                         ::testing::Values("tiny", "tiny_p2", "tiny_p4", "tiny_w5", "tiny_w6_p2", "tiny_w5_p4",
                                           "tiny_wide_range", "tiny_left_w4_p2", "tiny_all_p4", "tiny_all_recursive"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(StimulusTest, WholeFramesAreFlushedAndDrained) {
   const Image& C = image();
   const Stimulus made = stimulus({.frames = 2});
   EXPECT_EQ(made.pixels_per_clock, C.pixels_per_clock);
   const int frame = C.width_px * C.height_px / C.pixels_per_clock;
   const std::ptrdiff_t records = 2 * frame + schedule().gap_groups + schedule().flush_groups;
   EXPECT_EQ(valid_clocks(made), records);
   EXPECT_EQ(std::ssize(made.clocks), records + schedule().latency_clocks + 4);
   for (std::size_t i = 0; i < made.clocks.size(); ++i) {
      if (!made.clocks[i].valid) continue;
      ASSERT_EQ(made.clocks[i].start_of_frame, i == 0 || i == std::size_t(frame + schedule().gap_groups))
          << "clock " << i;
   }
}

TEST_P(StimulusTest, RecordsAreColumnsOfNeighbouringRows) {
   const Image& C = image();
   const ImagePair pair = pair_for(C);
   const Stimulus made = stimulus({});
   for (int y = 0; y < C.height_px; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         const int group = y / C.pixels_per_clock, lane = y % C.pixels_per_clock;
         const WideInput& in = made.clocks[std::size_t(group * C.width_px + x)];
         ASSERT_EQ(in.left[lane], pair.left.at(x, y)) << "x=" << x << " y=" << y;
         ASSERT_EQ(in.right[lane], pair.right.at(x, y)) << "x=" << x << " y=" << y;
      }
}

TEST_P(StimulusTest, GarbageIsOnTheLanesInUseOnly) {
   const Image& C = image();
   StimulusWriter writer(C.pixels_per_clock, 50, test_seed());
   writer.random_records(200);
   for (const bool valid : {false, true})
      for (int p = 0; p < kMostPixels; ++p) {
         const auto has_garbage = [&](const WideInput& in) {
            return in.valid == valid && (in.left[p] != 0 || in.right[p] != 0);
         };
         EXPECT_EQ(std::ranges::any_of(writer.clocks, has_garbage), p < C.pixels_per_clock) << "lane " << p;
      }
}

TEST_P(StimulusTest, OddFramesAreUpsideDown) {
   const Image& C = image();
   const ImagePair pair = pair_for(C);
   const Stimulus made = stimulus({.frames = 3});
   ImagePair flipped = pair;
   for (int y = 0; y < C.height_px; ++y)
      for (int x = 0; x < C.width_px; ++x) {
         flipped.left.at(x, y) = pair.left.at(x, C.height_px - 1 - y);
         flipped.right.at(x, y) = pair.right.at(x, C.height_px - 1 - y);
      }
   const auto got = maps(made);
   ASSERT_EQ(got.size(), 3u);
   for (std::size_t i = 0; i < 3; ++i) {
      const ImagePair& shown = i % 2 == 0 ? pair : flipped;
      EXPECT_TRUE(same_map(reference_map(shown), got[i])) << i;
   }
}

TEST_P(StimulusTest, RowsAreTheTopOfAFrame) {
   const Image& C = image();
   constexpr int kHeight = 8, kFirst = 3;
   const ImagePair pair = pair_for(C);
   const int records = C.width_px * kHeight / C.pixels_per_clock;
   if (schedule().groups_to_first_output > records) {  // many rows at once wait for as many rows each
      EXPECT_THROW(stimulus({.rows = RowRange{kFirst, kFirst + kHeight}}), std::invalid_argument);
      return;
   }
   const Stimulus made = stimulus({.rows = RowRange{kFirst, kFirst + kHeight}, .stall_percent = 30});
   EXPECT_EQ(valid_clocks(made), records);
   EXPECT_FALSE(
       std::ranges::any_of(made.clocks.end() - schedule().latency_clocks - 4, made.clocks.end(), &WideInput::valid));
   ImagePair crop{GrayImage(C.width_px, kHeight), GrayImage(C.width_px, kHeight)};
   std::copy_n(pair.left.row(kFirst), crop.left.pixels.size(), crop.left.pixels.begin());
   std::copy_n(pair.right.row(kFirst), crop.right.pixels.size(), crop.right.pixels.begin());
   const DisparityMap expected = reference_map(crop);
   // Without the records after its last row, all that waits for them stays inside.
   const auto comes_out = [&](int x, int y) {
      return schedule().groups_to_first_output + y / C.pixels_per_clock * C.width_px + x <= records;
   };
   std::size_t seen = 0;
   for (int y = 0; y < kHeight; y += C.pixels_per_clock)
      for (int x = 0; x < expected.width; ++x) seen += comes_out(x, y) ? 1 : 0;
   const auto outputs = run_core(core(), made.clocks);
   ASSERT_EQ(outputs.size(), seen);
   for (const CoreOutput& output : outputs) {
      ASSERT_TRUE(comes_out(output.x, output.y));
      for (int p = 0; p < C.pixels_per_clock; ++p) {
         const int x = output.x, y = output.y + p;
         ASSERT_EQ(output.disparity[std::size_t(p)], expected.at(x, y)) << "x=" << x << " y=" << y;
         ASSERT_EQ(output.pixel_valid[std::size_t(p)], expected.valid_at(x, y)) << "x=" << x << " y=" << y;
      }
   }
}

TEST_P(StimulusTest, TheSmallestCropGivesOutputsAndASmallerOneIsRefused) {
   const Image& C = image();
   const int P = C.pixels_per_clock;
   int least = P;  // the fewest rows that give an output
   const auto outputs = [&](int rows) {
      StimulusWriter writer(P, 0, test_seed());
      writer.rows(pair_for(C), {0, rows});
      writer.drain(schedule());
      return run_core(core(), writer.clocks).size();
   };
   while (least < C.height_px && outputs(least) == 0) least += P;
   EXPECT_GE(run_core(core(), stimulus({.rows = RowRange{C.height_px - least, C.height_px}}).clocks).size(), 1u);
   EXPECT_THROW(stimulus({.rows = RowRange{1, 1 + least - P}}), std::invalid_argument);
   if (P > 1) {
      EXPECT_THROW(stimulus({.rows = RowRange{0, least - 1}}), std::invalid_argument);
   }
}

TEST(Stimulus, TheSmallestCropOfWideWindowsInNarrowImagesIsAGroupLarger) {
   static constexpr block_matching::Config C = Config<10, 8, 9, 5, 1, 9, 1, 2>::kConfig;  // one column of outputs
   using Core = block_matching::Core<C>;
   const auto crop = [](int rows) {
      return make_stimulus("narrow", core_shape<Core>(), pair_for(C), {.rows = RowRange{0, rows}});
   };
   EXPECT_THROW(crop(3), std::invalid_argument);
   HeapMemories memories;
   EXPECT_GE(run_core(*make_clocked_core<Core>(memories), 1, crop(4).clocks, [] {}).size(), 1u);
}

TEST_P(StimulusTest, AllRowsAreAWholeFrame) {
   const Stimulus rows = stimulus({.rows = RowRange{0, image().height_px}});
   EXPECT_EQ(maps(rows).size(), 1u);
}

TEST_P(StimulusTest, StallsAddBubblesWithGarbageAndChangeNothingElse) {
   const Stimulus full_speed = stimulus({}), stalled = stimulus({.stall_percent = 50});
   EXPECT_EQ(valid_clocks(full_speed), valid_clocks(stalled));
   EXPECT_GT(stalled.clocks.size(), full_speed.clocks.size() * 3 / 2);
   const auto bubble_that_starts = [](const WideInput& in) { return !in.valid && in.start_of_frame; };
   EXPECT_TRUE(std::ranges::any_of(stalled.clocks, bubble_that_starts));
   const auto expected = maps(full_speed);
   const auto got = maps(stalled);
   ASSERT_EQ(got.size(), 1u);
   EXPECT_TRUE(same_map(expected.at(0), got[0]));
}

TEST(Stimulus, RejectsWhatDoesNotFit) {
   const CoreShape& shape = find_configuration("tiny")->shape;
   const Image& tiny = shape.image;
   const auto stimulus = [&](const StimulusOptions& options) {
      return make_stimulus("tiny", shape, pair_for(tiny), options);
   };
   EXPECT_THROW(stimulus({.frames = 0}), std::invalid_argument);
   EXPECT_THROW(stimulus({.stall_percent = 96}), std::invalid_argument);
   EXPECT_THROW(stimulus({.stall_percent = -1}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{-1, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{4, 4}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{0, tiny.height_px + 1}}), std::invalid_argument);
   EXPECT_THROW(stimulus({.rows = RowRange{4, 5}}), std::invalid_argument) << "one row gives no output";
   EXPECT_THROW(make_stimulus("tiny", shape, random_pair(33, 12, 1)), std::invalid_argument);
}

TEST_P(StimulusTest, CollectFramesRefusesOutputsOutOfPlace) {
   const auto good = run_core(core(), stimulus({}).clocks);
   EXPECT_EQ(collect_frames(good, core().shape).size(), 1u);
   auto missing = good;
   missing.pop_back();
   EXPECT_THROW(collect_frames(missing, core().shape), std::runtime_error);
   for (const auto spoil :
        {+[](CoreOutput& o) { ++o.x; }, +[](CoreOutput& o) { ++o.y; }, +[](CoreOutput& o) { ++o.frame; },
         +[](CoreOutput& o) { o.start_of_frame = !o.start_of_frame; },
         +[](CoreOutput& o) { o.end_of_line = !o.end_of_line; }}) {
      auto spoilt = good;
      spoil(spoilt[good.size() / 2 + 1]);
      EXPECT_THROW(collect_frames(spoilt, core().shape), std::runtime_error);
   }
}

}  // namespace
}  // namespace stereo::test
