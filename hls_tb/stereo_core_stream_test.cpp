// SPDX-License-Identifier: Apache-2.0
// The core as a stream: frames after frames, cut frames, bubbles and clocks.
#include "models/random.hpp"
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
DisparityMap reference(const ImagePair& pair) {
   return match_reference(pair.left, pair.right, matching_parameters(C));
}

/// Random pairs of few grey values, so that ties are frequent.
template <const StereoConfig& C>
std::vector<ImagePair> some_pairs(int count) {
   std::vector<ImagePair> pairs;
   for (int i = 0; i < count; ++i) pairs.push_back(random_pair(C.width_px, C.height_px, test_seed() + uint64_t(i), 8));
   return pairs;
}

template <const StereoConfig& C>
std::vector<CoreOutput> run(StimulusWriter& writer) {
   writer.drain(StereoCore<C>::kLatency);
   return run_core<C>(writer.clocks);
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

template <class Config>
class StereoCoreStreamTest : public ::testing::Test {};
TYPED_TEST_SUITE(StereoCoreStreamTest, SmallConfigs, ConfigNames);

template <const StereoConfig& C>
void frames_back_to_back_equal_frames_alone() {
   const std::vector<ImagePair> pairs = some_pairs<C>(3);
   for (const int frames : {2, 3})
      for (const int stall_percent : {0, 40}) {
         StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed());
         for (int i = 0; i < frames; ++i) writer.rows(pairs[std::size_t(i)], {0, C.height_px});
         writer.flush(C);
         const auto maps = collect_frames(run<C>(writer), C);
         ASSERT_EQ(maps.size(), std::size_t(frames));
         for (std::size_t i = 0; i < maps.size(); ++i)
            EXPECT_TRUE(same_map(reference<C>(pairs[i]), maps[i]))
                << "frame " << i << ", " << stall_percent << " % stalls";
      }
}

TYPED_TEST(StereoCoreStreamTest, FramesBackToBackEqualFramesAlone) {
   frames_back_to_back_equal_frames_alone<TypeParam::kConfig>();
}

template <const StereoConfig& C>
void flush_groups_and_next_frame_groups_give_the_same() {
   const std::vector<ImagePair> pairs = some_pairs<C>(2);
   StimulusWriter flushed(C.pixels_per_clock, 0, test_seed());
   for (const ImagePair& pair : pairs) {
      flushed.rows(pair, {0, C.height_px});
      flushed.random_records(C.delay_groups() * C.width_px);
   }
   flushed.random_records(C.radius_px());
   StimulusWriter back_to_back(C.pixels_per_clock, 0, test_seed());
   for (const ImagePair& pair : pairs) back_to_back.rows(pair, {0, C.height_px});
   back_to_back.flush(C);
   const auto expected = collect_frames(run<C>(back_to_back), C);
   const auto got = collect_frames(run<C>(flushed), C);
   ASSERT_EQ(expected.size(), 2u);
   ASSERT_EQ(got.size(), 2u);
   EXPECT_TRUE(same_map(expected[0], got[0]));
   EXPECT_TRUE(same_map(expected[1], got[1]));
}

TYPED_TEST(StereoCoreStreamTest, FlushGroupsAndNextFrameGroupsGiveTheSame) {
   flush_groups_and_next_frame_groups_give_the_same<TypeParam::kConfig>();
}

template <const StereoConfig& C>
void a_start_of_frame_restarts_at_any_place() {
   const std::vector<ImagePair> pairs = some_pairs<C>(3);
   StimulusWriter whole(C.pixels_per_clock, 0, test_seed());
   whole.rows(pairs[1], {0, C.height_px});
   const int frame = int(whole.clocks.size());
   whole.flush(C);
   const int with_flush = int(whole.clocks.size());
   Random random(test_seed());
   for (int round = 0; round < 40; ++round) {
      const bool follows_a_frame = random.percent(50);
      const int sent = 1 + random.below(with_flush);  // up to and into the flush groups
      StimulusWriter writer(C.pixels_per_clock, 20, test_seed());
      if (follows_a_frame) writer.rows(pairs[0], {0, C.height_px});
      for (int i = 0; i < std::min(sent, frame); ++i) writer.record(whole.clocks[std::size_t(i)]);
      writer.random_records(std::max(0, sent - frame));
      writer.rows(pairs[2], {0, C.height_px});
      writer.flush(C);
      const auto maps = collect_frames(last_frame(run<C>(writer)), C);
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(reference<C>(pairs[2]), maps[0]))
          << sent << " records before, after a frame: " << follows_a_frame;
   }
}

TYPED_TEST(StereoCoreStreamTest, AStartOfFrameRestartsAtAnyPlace) {
   a_start_of_frame_restarts_at_any_place<TypeParam::kConfig>();
}

template <const StereoConfig& C>
void is_silent_outside_frames() {
   StimulusWriter writer(C.pixels_per_clock, 20, test_seed());
   writer.random_records(3 * C.width_px * C.height_px);
   EXPECT_EQ(run<C>(writer).size(), 0u) << "before the first start of frame";
   writer.rows(some_pairs<C>(1)[0], {0, C.height_px});
   writer.random_records(3 * C.width_px * C.height_px);
   EXPECT_EQ(collect_frames(run<C>(writer), C).size(), 1u) << "long after the frame's end";
}

TYPED_TEST(StereoCoreStreamTest, IsSilentOutsideFrames) { is_silent_outside_frames<TypeParam::kConfig>(); }

template <const StereoConfig& C>
void latency_is_the_constant_with_and_without_stalls() {
   for (const int stall_percent : {0, 50}) {
      StimulusWriter writer(C.pixels_per_clock, stall_percent, test_seed());
      writer.rows(some_pairs<C>(1)[0], {0, C.height_px});
      writer.flush(C);
      const auto outputs = run<C>(writer);
      std::vector<uint64_t> clock_of_record;
      for (uint64_t clock = 0; clock < writer.clocks.size(); ++clock)
         if (writer.clocks[clock].valid) clock_of_record.push_back(clock);
      ASSERT_EQ(outputs.size(), std::size_t(C.output_width_px() * C.row_groups()));
      for (const CoreOutput& output : outputs) {
         // The last record of the windows: delay_groups below the centres, D-1+r columns to the right.
         const int last_record = (output.y / C.pixels_per_clock + C.delay_groups()) * C.width_px + output.x +
                                 C.disparities - 1 + C.radius_px();
         ASSERT_EQ(output.clock, clock_of_record[std::size_t(last_record)] + uint64_t(StereoCore<C>::kLatency))
             << "x=" << output.x << " y=" << output.y << ", " << stall_percent << " % stalls";
      }
   }
}

TYPED_TEST(StereoCoreStreamTest, LatencyIsTheConstantWithAndWithoutStalls) {
   latency_is_the_constant_with_and_without_stalls<TypeParam::kConfig>();
}

TYPED_TEST(StereoCoreStreamTest, AFrameCostsNotOneClockMoreThanItsPixels) {
   constexpr const StereoConfig& C = TypeParam::kConfig;
   const ImagePair pair = some_pairs<TypeParam::kConfig>(1)[0];
   StimulusWriter writer(C.pixels_per_clock, 0, test_seed());
   for (int i = 0; i < 3; ++i) writer.rows(pair, {0, C.height_px});
   writer.flush(C);
   std::vector<uint64_t> starts;
   for (const CoreOutput& output : run<TypeParam::kConfig>(writer))
      if (output.start_of_frame) starts.push_back(output.clock);
   ASSERT_EQ(starts.size(), 3u);
   EXPECT_EQ(starts[1] - starts[0], uint64_t(C.width_px * C.height_px / C.pixels_per_clock));
   EXPECT_EQ(starts[2] - starts[1], uint64_t(C.width_px * C.height_px / C.pixels_per_clock));
}

}  // namespace
}  // namespace stereo::test
