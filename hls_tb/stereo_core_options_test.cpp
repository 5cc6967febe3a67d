// SPDX-License-Identifier: Apache-2.0
// The core of every named configuration against the reference.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/map_compare.hpp"
#include "support/reference_map.hpp"
#include "support/seed.hpp"
#include "support/test_pairs.hpp"
#include "vectors/configuration_table.hpp"
#include "vectors/matching_parameters.hpp"

namespace stereo::test {
namespace {

class StereoCoreOptionsTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const Configuration& core() const { return configuration_table()[GetParam()]; }
};
INSTANTIATE_TEST_SUITE_P(Named, StereoCoreOptionsTest, ::testing::Range(std::size_t(0), configuration_table().size()),
                         [](const auto& test) { return configuration_table()[test.param].name; });

bool is_small(const StereoConfig& config) { return config.width_px <= 100; }

/// Of a large configuration only the scene.
std::vector<NamedPair> pairs_for(const StereoConfig& config) {
   std::vector<NamedPair> pairs = test_pairs(config.width_px, config.height_px, config.disparities, test_seed());
   if (!is_small(config)) std::erase_if(pairs, [](const NamedPair& pair) { return pair.name != "scene"; });
   return pairs;
}

/// The frames one behind the other.
std::vector<DisparityMap> core_maps(const Configuration& core, const std::vector<ImagePair>& frames,
                                    int stall_percent) {
   StimulusWriter writer(core.config.pixels_per_clock, stall_percent, test_seed());
   for (std::size_t i = 0; i < frames.size(); ++i) {
      if (i > 0) writer.gap(core.config);
      writer.rows(frames[i], {0, core.config.height_px});
   }
   writer.flush(core.config);
   writer.drain(core.latency_clocks);
   return collect_frames(core.run(writer.clocks), core.config);
}

TEST_P(StereoCoreOptionsTest, EqualsTheReference) {
   const StereoConfig& config = core().config;
   const std::vector<NamedPair> pairs = pairs_for(config);
   std::vector<DisparityMap> expected;
   for (const NamedPair& pair : pairs) expected.push_back(reference_map(pair.images, config));
   std::ptrdiff_t valid = 0, invalid = 0;
   for (std::size_t i = 0; i < pairs.size(); ++i)
      for (const std::size_t frames : {1u, 2u})
         for (const int stall_percent : {0, 30}) {
            if (pairs.size() == 1 && (frames > 1 || stall_percent > 0)) continue;
            SCOPED_TRACE(pairs[i].name + ", " + std::to_string(frames) + " frames, " + std::to_string(stall_percent) +
                         " % stalls");
            std::vector<ImagePair> sent;
            for (std::size_t frame = 0; frame < frames; ++frame)
               sent.push_back(pairs[(i + frame) % pairs.size()].images);
            const auto maps = core_maps(core(), sent, stall_percent);
            ASSERT_EQ(maps.size(), frames);
            for (std::size_t frame = 0; frame < frames; ++frame) {
               EXPECT_TRUE(same_map(expected[(i + frame) % pairs.size()], maps[frame])) << "frame " << frame;
               valid += std::ranges::count(maps[frame].valid, 1);
               invalid += std::ranges::count(maps[frame].valid, 0);
            }
         }
   EXPECT_GT(valid, 0);
   if (matching_parameters(config).has_check()) EXPECT_GT(invalid, 0);
   else EXPECT_EQ(invalid, 0);
}

/// Records and bubbles of one frame and of some records behind it; the clocks of the records.
struct TimedFrame {
   std::vector<StereoInput> clocks;
   std::vector<uint64_t> clock_of_record;

   TimedFrame(const StereoConfig& config, int latency_clocks, int records, int stall_percent) {
      StimulusWriter writer(config.pixels_per_clock, stall_percent, test_seed());
      writer.rows(random_pair(config.width_px, config.height_px, test_seed()), {0, config.height_px});
      writer.random_records(records);
      std::vector<StereoInput> sent;
      int count = 0;
      for (const StereoInput& in : writer.clocks) {
         if (in.valid && count == records) break;
         if (in.valid) clock_of_record.push_back(sent.size());
         count += in.valid ? 1 : 0;
         sent.push_back(in);
      }
      StimulusWriter after(config.pixels_per_clock, 0, test_seed());
      after.drain(latency_clocks);
      sent.insert(sent.end(), after.clocks.begin(), after.clocks.end());
      clocks = std::move(sent);
   }
};

/// The places of the small configurations in the table.
std::vector<std::size_t> small_ones() {
   std::vector<std::size_t> places;
   for (std::size_t i = 0; i < configuration_table().size(); ++i)
      if (is_small(configuration_table()[i].config)) places.push_back(i);
   return places;
}

class StereoCoreLatencyTest : public StereoCoreOptionsTest {};
// A build of chosen configurations may have no small one.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StereoCoreLatencyTest);
INSTANTIATE_TEST_SUITE_P(Named, StereoCoreLatencyTest, ::testing::ValuesIn(small_ones()),
                         [](const auto& test) { return configuration_table()[test.param].name; });

/// Records from a frame's first to the one that brings out its last disparities.
int whole_frame(const StereoConfig& config) {
   return config.groups_to_first_output() + (config.row_groups() - 1) * config.width_px + config.output_width_px() - 1;
}

TEST_P(StereoCoreLatencyTest, TheFirstOutputComesExactlyTheLatencyAfterItsLastRecord) {
   const StereoConfig& config = core().config;
   for (const int stall_percent : {0, 50}) {
      const TimedFrame frame(config, core().latency_clocks, whole_frame(config), stall_percent);
      const auto outputs = core().run(frame.clocks);
      ASSERT_FALSE(outputs.empty());
      EXPECT_TRUE(outputs[0].start_of_frame);
      EXPECT_EQ(outputs[0].clock, frame.clock_of_record.at(std::size_t(config.groups_to_first_output()) - 1) +
                                      uint64_t(core().latency_clocks))
          << stall_percent << " % stalls";
      EXPECT_EQ(outputs.back().clock, frame.clock_of_record.back() + uint64_t(core().latency_clocks))
          << stall_percent << " % stalls";
   }
}

TEST_P(StereoCoreLatencyTest, TheFlushGroupsBringOutTheWholeFrameAndOneLessDoesNot) {
   const StereoConfig& config = core().config;
   const std::size_t outputs = std::size_t(config.output_width_px() * config.row_groups());
   const int records = config.width_px * config.row_groups() + config.flush_groups();
   for (int missing = 0; missing <= (config.flush_groups() > 0 ? 1 : 0); ++missing) {
      const TimedFrame frame(config, core().latency_clocks, records - missing, 0);
      EXPECT_EQ(core().run(frame.clocks).size(), outputs - std::size_t(missing));
   }
}

}  // namespace
}  // namespace stereo::test
