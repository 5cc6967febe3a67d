// SPDX-License-Identifier: Apache-2.0
// The core as a stream: frames after frames, cut frames, bubbles and clocks.
#include <algorithm>

#include "block_matching/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "scene/random.hpp"
#include "testing/map_compare.hpp"
#include "testing/reference_map.hpp"
#include "testing/seed.hpp"
#include "testing/small_cores.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

/// Random pairs of few grey values, so that ties are frequent.
std::vector<ImagePair> some_pairs(const block_matching::Config& config, int count) {
   std::vector<ImagePair> pairs;
   for (int i = 0; i < count; ++i)
      pairs.push_back(random_pair(config.width_px, config.height_px, test_seed() + uint64_t(i), 8));
   return pairs;
}

/// The outputs from the last start of frame on, as a stream of their own.
std::vector<CoreOutput> last_frame(const std::vector<CoreOutput>& outputs) {
   std::vector<CoreOutput> frame;
   for (const CoreOutput& output : outputs) {
      if (output.start_of_frame) frame.clear();
      frame.push_back(output);
      frame.back().frame = 0;
   }
   return frame;
}

class StereoCoreStreamTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const SmallCore& core() const { return small_cores()[GetParam()]; }
   const block_matching::Config& config() const { return core().config; }
   const Schedule& schedule() const { return core().shape.schedule; }
   StimulusWriter writer(int stall_percent = 0) const {
      return StimulusWriter(core().shape, stall_percent, test_seed());
   }
   /// One behind the other, to be sent by another writer.
   StimulusWriter records() const { return StimulusWriter(config().pixels_per_clock, 0, test_seed()); }
   void send(StimulusWriter& to, const ImagePair& frame) const { to.rows(frame, {0, config().height_px}); }
   std::vector<CoreOutput> run(StimulusWriter& from) const {
      HeapMemories memories;
      return run(from, memories);
   }
   std::vector<CoreOutput> run(StimulusWriter& from, HeapMemories& memories) const {
      from.drain(schedule());
      return core().run(from.clocks, memories, nullptr);
   }
   int frame_records() const { return config().width_px * config().row_groups(); }
};
INSTANTIATE_TEST_SUITE_P(Small, StereoCoreStreamTest, ::testing::Range(std::size_t(0), small_cores().size()),
                         [](const auto& test) { return small_cores()[test.param].name; });

TEST_P(StereoCoreStreamTest, FramesOneBehindTheOtherEqualFramesAlone) {
   const std::vector<ImagePair> pairs = some_pairs(config(), 4);
   for (const int frames : {2, 4})
      for (const int stall_percent : {0, 40}) {
         StimulusWriter stream = writer(stall_percent);
         for (int i = 0; i < frames; ++i) {
            if (i > 0) stream.gap(schedule());
            send(stream, pairs[std::size_t(i)]);
         }
         stream.flush(schedule());
         const auto maps = collect_frames(run(stream), core().shape);
         ASSERT_EQ(maps.size(), std::size_t(frames));
         for (std::size_t i = 0; i < maps.size(); ++i)
            EXPECT_TRUE(same_map(reference_map(pairs[i], config()), maps[i]))
                << "frame " << i << ", " << stall_percent << " % stalls";
      }
}

TEST_P(StereoCoreStreamTest, FlushGroupsAndNextFrameGroupsGiveTheSame) {
   const std::vector<ImagePair> pairs = some_pairs(config(), 2);
   StimulusWriter flushed = writer(), at_once = writer();
   for (const ImagePair& pair : pairs) {
      send(flushed, pair);
      flushed.random_records(std::max(schedule().flush_groups, schedule().gap_groups));
      send(at_once, pair);
      at_once.gap(schedule());
   }
   at_once.flush(schedule());
   const auto expected = collect_frames(run(at_once), core().shape);
   const auto got = collect_frames(run(flushed), core().shape);
   ASSERT_EQ(expected.size(), 2u);
   ASSERT_EQ(got.size(), 2u);
   EXPECT_TRUE(same_map(expected[0], got[0]));
   EXPECT_TRUE(same_map(expected[1], got[1]));
}

TEST_P(StereoCoreStreamTest, AStartOfFrameRestartsAtAnyPlace) {
   const std::vector<ImagePair> pairs = some_pairs(config(), 3);
   StimulusWriter whole = records();
   send(whole, pairs[1]);
   const DisparityMap expected = reference_map(pairs[2], config());
   Random random(test_seed());
   for (int round = 0; round < 40; ++round) {
      const bool follows_a_frame = random.percent(50);
      // Up to and into the flush groups.
      const int sent = 1 + random.below(frame_records() + schedule().flush_groups);
      StimulusWriter stream = writer(20);
      if (follows_a_frame) {
         send(stream, pairs[0]);
         stream.gap(schedule());
      }
      for (int i = 0; i < std::min(sent, frame_records()); ++i) stream.record(whole.clocks[std::size_t(i)]);
      stream.random_records(std::max(0, sent - frame_records()));
      send(stream, pairs[2]);
      stream.flush(schedule());
      const auto maps = collect_frames(last_frame(run(stream)), core().shape);
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(expected, maps[0])) << sent << " records before, after a frame: " << follows_a_frame;
   }
}

TEST_P(StereoCoreStreamTest, AResetAtAnyPlaceLeavesNothingOfTheFrameBefore) {
   const std::vector<ImagePair> pairs = some_pairs(config(), 2);
   StimulusWriter whole = records(), alone = writer();
   send(whole, pairs[0]);
   whole.flush(schedule());
   send(alone, pairs[1]);
   alone.flush(schedule());
   const std::vector<CoreOutput> expected = run(alone);
   Random random(test_seed());
   for (int round = 0; round < 20; ++round) {
      const int sent = 1 + random.below(int(whole.clocks.size()));
      StimulusWriter before = writer(20), after = writer();
      for (int i = 0; i < sent; ++i) before.record(whole.clocks[std::size_t(i)]);
      send(after, pairs[1]);
      after.flush(schedule());
      HeapMemories memories;
      run(before, memories);
      EXPECT_EQ(run(after, memories), expected) << sent << " records before";
   }
}

TEST_P(StereoCoreStreamTest, IsSilentOutsideFrames) {
   StimulusWriter stream = writer(20);
   stream.random_records(3 * frame_records() * config().pixels_per_clock);
   EXPECT_EQ(run(stream).size(), 0u) << "before the first start of frame";
   send(stream, some_pairs(config(), 1)[0]);
   stream.random_records(3 * frame_records() * config().pixels_per_clock + schedule().flush_groups);
   EXPECT_EQ(collect_frames(run(stream), core().shape).size(), 1u) << "long after the frame's end";
}

TEST_P(StereoCoreStreamTest, LatencyIsTheConstantWithAndWithoutStalls) {
   for (const int stall_percent : {0, 50}) {
      StimulusWriter stream = writer(stall_percent);
      send(stream, some_pairs(config(), 1)[0]);
      stream.flush(schedule());
      const auto outputs = run(stream);
      std::vector<uint64_t> clock_of_record;
      for (uint64_t clock = 0; clock < stream.clocks.size(); ++clock)
         if (stream.clocks[clock].valid) clock_of_record.push_back(clock);
      ASSERT_EQ(outputs.size(), std::size_t(config().output_width_px() * config().row_groups()));
      for (const CoreOutput& output : outputs) {
         // The last record that it waits for: a row of groups further for each row of groups, a column for each column.
         const int last_record = schedule().groups_to_first_output - 1 +
                                 output.y / config().pixels_per_clock * config().width_px + output.x;
         ASSERT_EQ(output.clock, clock_of_record.at(std::size_t(last_record)) + uint64_t(schedule().latency_clocks))
             << "x=" << output.x << " y=" << output.y << ", " << stall_percent << " % stalls";
      }
   }
}

/// Without the blocks behind the windows the constant is that of the paper's core, by definition: the last column of
/// the lowest window.
TEST(StereoCoreStream, FirstOutputOfAPlainCoreComesWithTheLastColumnOfItsWindow) {
   for (const SmallCore& core : small_cores()) {
      const block_matching::Config& c = core.config;
      if (c.has_transform() || c.has_left_right_check() || c.median || c.reference == Reference::left) continue;
      // R(x) of the first map column meets L(x+m+D-1); both must be there, and those of the columns behind.
      const int first = std::max(0, -c.min_disparity);
      const int last_column = (c.window_px - 1) / 2 + std::max(first, first + c.min_disparity + c.disparities - 1);
      EXPECT_EQ(core.shape.schedule.groups_to_first_output, c.delay_groups() * c.width_px + last_column + 1)
          << core.name;
   }
}

TEST_P(StereoCoreStreamTest, AFrameCostsNotOneClockMoreThanItsPixelsAndItsGap) {
   const ImagePair pair = some_pairs(config(), 1)[0];
   StimulusWriter stream = writer();
   for (int i = 0; i < 3; ++i) {
      send(stream, pair);
      stream.gap(schedule());
   }
   stream.flush(schedule());
   const int gap = config().aggregation == Aggregation::direct ? 0 : config().delay_groups() * config().width_px;
   std::vector<uint64_t> starts;
   for (const CoreOutput& output : run(stream))
      if (output.start_of_frame) starts.push_back(output.clock);
   ASSERT_EQ(starts.size(), 3u);
   EXPECT_EQ(starts[1] - starts[0], uint64_t(frame_records() + gap));
   EXPECT_EQ(starts[2] - starts[1], uint64_t(frame_records() + gap));
}

}  // namespace
}  // namespace stereo::test
