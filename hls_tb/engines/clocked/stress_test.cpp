// SPDX-License-Identifier: Apache-2.0
#include "engines/clocked/stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "scene/stress_pairs.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

/// How often a stream does what.
struct Events {
   int frames = 0, whole = 0, at_the_gap = 0, broken = 0, bubbles = 0, resets = 0, later = 0, false_starts = 0;
};

Events events_of(const Stimulus& made, const CoreShape& shape) {
   Events events;
   const int frame = shape.image.width_px * shape.image.row_groups();
   int since_start = -1;  // valid groups; -1 before the first start
   bool was_reset = false, at_the_gap = false, behind_false_start = false;
   for (std::size_t clock = 0; clock < made.clocks.size(); ++clock) {
      const WideInput& in = made.clocks[clock];
      const bool reset = std::ranges::binary_search(made.resets, clock);
      events.resets += reset && !was_reset;
      was_reset = reset;
      events.bubbles += !in.valid && !reset;
      if (reset) since_start = -1, at_the_gap = behind_false_start = false;
      if (reset || !in.valid) continue;
      if (in.start_of_frame) {
         ++events.frames;
         events.broken += since_start >= 0 && since_start < frame;
         behind_false_start = at_the_gap && since_start <= std::min(frame - 1, shape.schedule.flush_groups);
         at_the_gap = since_start == frame + shape.schedule.gap_groups;
         events.at_the_gap += at_the_gap;
         events.later += since_start > frame + shape.schedule.gap_groups;
         since_start = 0;
      }
      if (since_start < 0) continue;
      events.whole += ++since_start == frame;
      events.false_starts += behind_false_start && since_start == frame + shape.schedule.flush_groups;
   }
   return events;
}

class StressTest : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Named, StressTest,
                         ::testing::Values("tiny", "tiny_p2", "tiny_sgm", "tiny_trellis", "tiny_phase",
                                           "tiny_dynamic_census", "tiny_settings"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(StressTest, HasAllThatMayComeBetweenFrames) {
   const CoreModule& core = core_module(GetParam());
   const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
   const Events events = events_of(made, core.shape);
   const int classes = int(kStressClasses.size());
   EXPECT_GE(events.frames, classes) << "each class once";
   EXPECT_GE(events.whole, classes / 2);
   EXPECT_GE(events.at_the_gap, classes / 2 - 1);
   EXPECT_GT(events.broken, 0);
   EXPECT_GT(events.later, 0);
   EXPECT_GT(events.false_starts, 0)
       << "broken off in place of the flush of the frame before, then a whole frame alone";
   EXPECT_GT(events.resets, 0);
   EXPECT_GT(events.bubbles, 100);
   EXPECT_GT(run_core(core, made).size(), std::size_t(classes) * 100) << "maps";
}

TEST_P(StressTest, ASeedIsAStream) {
   const CoreModule& core = core_module(GetParam());
   const auto pixels = [&](uint64_t seed) {
      std::vector<int> all;
      for (const WideInput& in : make_stress_stimulus(core.name, core.shape, seed).clocks)
         all.insert(all.end(), {in.left[0], in.right[0], in.valid, in.start_of_frame});
      return all;
   };
   EXPECT_EQ(pixels(3), pixels(3));
   EXPECT_NE(pixels(3), pixels(4));
}

TEST_P(StressTest, StreamsOfOtherSeedsFollow) {
   const CoreModule& core = core_module(GetParam());
   const Stimulus one = make_stress_stimulus(core.name, core.shape, test_seed());
   EXPECT_EQ(make_stress_stimulus(core.name, core.shape, test_seed(), 1).clocks.size(), one.clocks.size());
   const Stimulus two = make_stress_stimulus(core.name, core.shape, test_seed(), one.clocks.size());
   ASSERT_GT(two.clocks.size(), 3 * one.clocks.size() / 2) << "a whole stream";
   const auto pixels = [&](std::size_t from) {
      std::vector<int> some;
      for (std::size_t clock = from; clock < from + 5000; ++clock) some.push_back(two.clocks[clock].left[0]);
      return some;
   };
   // The first stream is the same in both; behind a clock of reset comes what follows it.
   const auto differ = std::ranges::mismatch(one.clocks, two.clocks, [](const WideInput& a, const WideInput& b) {
      return a.left[0] == b.left[0] && a.valid == b.valid && a.start_of_frame == b.start_of_frame;
   });
   const std::size_t end = std::size_t(differ.in1 - one.clocks.begin());
   EXPECT_GT(end, one.clocks.size() / 3);
   EXPECT_NE(pixels(0), pixels(end));
   EXPECT_TRUE(std::ranges::binary_search(two.resets, end - 1));
}

TEST(Stress, OfALongFrameSendsTheFirstRows) {
   const CoreModule& core = core_module("tiny");
   CoreShape shape = core.shape;
   shape.image.width_px = 320;
   shape.image.height_px = 240;
   shape.schedule.groups_to_first_output = 3 * 320;
   const Stimulus made = make_stress_stimulus(core.name, shape, test_seed());
   EXPECT_LT(made.clocks.size(), 100'000u);
   EXPECT_GT(made.clocks.size(), 2u * 320 * 4 * kStressClasses.size());
}

TEST(Stress, SettingsAndSizesChangeWithTheFrames) {
   for (const char* const name : {"tiny_settings", "tiny_size"}) {
      const CoreModule& core = core_module(name);
      const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
      const Setting* const ports = made.ports.setting;
      const auto port = std::find_if(ports, ports + made.ports.count, [&](const Setting& setting) {
         return std::string_view(setting.name) ==
                (name == std::string_view("tiny_size") ? "image_width" : "uniqueness_percent");
      });
      ASSERT_NE(port, ports + made.ports.count);
      std::vector<uint32_t> values;
      for (const SettingsChange& change : made.settings) values.push_back(change.values[std::size_t(port - ports)]);
      std::ranges::sort(values);
      EXPECT_GT(std::ranges::unique(values).begin() - values.begin(), 3) << name;
   }
}

TEST(Stress, PenaltiesAndCostsGoBeyondTheirLimitsAndCountAsThese) {
   for (const char* const name : {"tiny_sgm_settings", "tiny_trellis_settings", "tiny_dense_size"}) {
      const CoreModule& core = core_module(name);
      const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
      std::vector<std::size_t> starts;
      for (std::size_t clock = 0; clock < made.clocks.size(); ++clock)
         if (made.clocks[clock].valid && made.clocks[clock].start_of_frame) starts.push_back(clock);
      Stimulus limited = made;
      int beyond = 0;
      for (std::size_t change = 0; change < limited.settings.size(); ++change) {
         if (!std::ranges::binary_search(starts, limited.settings[change].clock)) continue;
         for (int i = 0; i < made.ports.count; ++i) {
            const Setting& port = made.ports.setting[i];
            uint32_t& value = limited.settings[change].values[std::size_t(i)];
            if (!port.clamped) continue;
            const uint32_t limit = uint32_t(std::clamp(int(value), port.least, port.largest));
            beyond += value != limit;
            value = limit;
         }
      }
      EXPECT_GT(beyond, 3) << name;
      const std::vector<CoreOutput> shown = run_core(core, made), expected = run_core(core, limited);
      ASSERT_EQ(shown.size(), expected.size());
      for (std::size_t i = 0; i < shown.size(); ++i) ASSERT_EQ(shown[i].disparity, expected[i].disparity) << name;
   }
}

TEST(Stress, EachWidthAndHeightComes) {
   for (const char* const name : {"tiny_size", "tiny_dense_size"}) {
      const CoreModule& core = core_module(name);
      const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
      const int count = made.ports.count;
      std::set<uint32_t> widths, heights;
      for (const SettingsChange& change : made.settings) {
         widths.insert(change.values[std::size_t(count - 2)]);
         heights.insert(change.values[std::size_t(count - 1)]);
      }
      const Setting &width = made.ports.setting[count - 2], &height = made.ports.setting[count - 1];
      for (int value = width.least; value <= width.largest; value += width.step)
         EXPECT_TRUE(widths.contains(uint32_t(value))) << name << ": width " << value;
      for (int value = height.least; value <= height.largest; value += height.step)
         EXPECT_TRUE(heights.contains(uint32_t(value))) << name << ": height " << value;
   }
}

TEST(Stress, AFrameStartsInEachRowOfTheFlush) {
   for (const char* const name : {"tiny", "tiny_sgm"}) {
      const CoreModule& core = core_module(name);
      const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
      const int width = core.shape.image.width_px, frame = width * core.shape.image.row_groups();
      std::vector<int> lengths;  // of the frames behind whole ones
      int records = 0;
      bool was_whole = false;
      for (std::size_t clock = 0; clock < made.clocks.size(); ++clock) {
         if (!made.clocks[clock].valid) continue;
         if (made.clocks[clock].start_of_frame) {
            if (was_whole) lengths.push_back(records);
            was_whole = records == frame;
            records = 0;
         }
         ++records;
      }
      for (int row = 1; row * width <= core.shape.schedule.flush_groups; ++row)
         EXPECT_TRUE(std::ranges::find(lengths, row * width) != lengths.end()) << name << ": " << row << " rows";
   }
}

TEST(Stress, AFrameStartsBehindEachRowOfTheFlush) {
   for (const char* const name : {"tiny", "tiny_sgm", "tiny_trellis", "tiny_phase"}) {
      const CoreModule& core = core_module(name);
      const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed());
      const int width = core.shape.image.width_px, frame = width * core.shape.image.row_groups();
      std::vector<int> distances;  // from a start to the next one
      int records = 0;
      for (const WideInput& in : made.clocks) {
         if (!in.valid) continue;
         if (in.start_of_frame) {
            distances.push_back(records);
            records = 0;
         }
         ++records;
      }
      for (int row = 1; row * width <= core.shape.schedule.flush_groups; ++row)
         EXPECT_TRUE(std::ranges::find(distances, frame + row * width) != distances.end()) << name << ": row " << row;
   }
}

TEST(Stress, PairsOfTheFamilyComeWhole) {
   const CoreModule& core = core_module("tiny");
   Random random(test_seed());
   const StressShape shape{core.shape.image.width_px, core.shape.image.height_px, 0, 8};
   const std::vector<DeepPair> own{stress_pair(StressClass::noise, shape, random),
                                   stress_pair(StressClass::noise, shape, random)};
   const Stimulus made = make_stress_stimulus(core.name, core.shape, test_seed(), 1, own);
   std::vector<int> left;
   for (const WideInput& in : made.clocks)
      if (in.valid) left.push_back(in.left[0]);
   for (const DeepPair& pair : own) {
      const std::vector<int> sent(pair.left.pixels.begin(), pair.left.pixels.end());
      EXPECT_FALSE(std::ranges::search(left, sent).empty());
   }
}

TEST(Stress, AnAppendedStreamGivesWhatItGivesAlone) {
   for (const char* const name : {"tiny", "tiny_settings", "tiny_size"}) {
      const CoreModule& core = core_module(name);
      Random random(test_seed());
      const DeepPair deep =
          stress_pair(StressClass::noise, {core.shape.image.width_px, core.shape.image.height_px, 0, 8}, random);
      const Stimulus alone = make_stimulus(core.name, core.shape, deep, {.frames = 2, .seed = 5});
      Stimulus both = make_stress_stimulus(core.name, core.shape, test_seed());
      const std::size_t before = run_core(core, both).size();
      const uint64_t begin = append(both, alone);
      const std::vector<CoreOutput> expected = run_core(core, alone), got = run_core(core, both);
      ASSERT_EQ(got.size(), before + expected.size()) << name;
      for (std::size_t i = 0; i < expected.size(); ++i) {
         EXPECT_EQ(got[before + i].clock, begin + expected[i].clock);
         EXPECT_EQ(got[before + i].disparity, expected[i].disparity);
         EXPECT_EQ(got[before + i].pixel_valid, expected[i].pixel_valid);
      }
   }
}

}  // namespace
}  // namespace stereo::test
