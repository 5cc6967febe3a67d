// SPDX-License-Identifier: Apache-2.0
// The core of every named configuration against the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/run_core.hpp"
#include "engines/clocked/stimulus.hpp"
#include "engines/configurations.hpp"
#include "scene/scene.hpp"
#include "support/ports.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"
#include "testing/tested_cores.hpp"

namespace stereo::test {
namespace {

class NamedCoreTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const Configuration& configuration() const { return configurations()[GetParam()]; }
   const CoreModule& core() const { return core_module(configuration().name); }
};
INSTANTIATE_TEST_SUITE_P(Named, NamedCoreTest, ::testing::ValuesIn(tested_configurations()),
                         [](const auto& test) { return configurations()[test.param].name; });

bool is_small(const Configuration& configuration) { return configuration.shape.image.width_px <= 100; }

/// Of a large configuration only the scene, and what a check rejects.
std::vector<NamedPair> pairs_for(const Configuration& configuration) {
   const Image& image = configuration.shape.image;
   const int disparities =
       std::min(configuration.algorithm->map_geometry(image.width_px).disparities, image.width_px - 1);
   std::vector<NamedPair> pairs = test_pairs(image.width_px, image.height_px, disparities, test_seed());
   const bool has_check = configuration.algorithm->map_geometry(image.width_px).has_check;
   const auto is_needed = [has_check](const NamedPair& pair) {
      return pair.name == "scene" || (has_check && pair.name == "flat");
   };
   if (!is_small(configuration)) std::erase_if(pairs, [&](const NamedPair& pair) { return !is_needed(pair); });
   return pairs;
}

/// The frames one behind the other.
template <class Pair>
std::vector<DisparityMap> core_maps(const CoreModule& core, const std::vector<Pair>& frames, int stall_percent) {
   const Schedule& schedule = core.shape.schedule;
   StimulusWriter writer(core.shape, stall_percent, test_seed());
   for (std::size_t i = 0; i < frames.size(); ++i) {
      if (i > 0) writer.gap(schedule);
      writer.rows(frames[i], {0, core.shape.image.height_px});
   }
   writer.flush(schedule);
   writer.drain(schedule);
   return collect_frames(run_core(core, writer.clocks), core.shape);
}

/// Of all maps.
struct PixelCounts {
   std::ptrdiff_t valid = 0, invalid = 0;
};

/// Every pair alone and before the next one, with and without bubbles.
template <class Pair>
PixelCounts compare_with_reference(const Configuration& configuration, const CoreModule& core,
                                   const std::vector<NamedPair>& named, const std::vector<Pair>& pairs) {
   std::vector<DisparityMap> expected;
   for (const Pair& pair : pairs) expected.push_back(configuration.algorithm->match_reference(pair.left, pair.right));
   PixelCounts counts;
   for (std::size_t i = 0; i < pairs.size(); ++i)
      for (const std::size_t frames : {1u, 2u})
         for (const int stall_percent : {0, 30}) {
            if (!is_small(configuration) && (frames > 1 || stall_percent > 0)) continue;
            SCOPED_TRACE(named[i].name + ", " + std::to_string(frames) + " frames, " + std::to_string(stall_percent) +
                         " % stalls");
            std::vector<Pair> sent;
            for (std::size_t frame = 0; frame < frames; ++frame) sent.push_back(pairs[(i + frame) % pairs.size()]);
            const auto maps = core_maps(core, sent, stall_percent);
            EXPECT_EQ(maps.size(), frames);
            for (std::size_t frame = 0; frame < maps.size(); ++frame) {
               EXPECT_TRUE(same_map(expected[(i + frame) % pairs.size()], maps[frame])) << "frame " << frame;
               counts.valid += std::ranges::count(maps[frame].valid, 1);
               counts.invalid += std::ranges::count(maps[frame].valid, 0);
            }
         }
   return counts;
}

TEST_P(NamedCoreTest, EqualsTheReference) {
   const std::vector<NamedPair> named = pairs_for(configuration());
   std::vector<ImagePair> pairs;
   std::vector<DeepPair> deep;
   const int bits = core().shape.pixel_bits;
   for (const NamedPair& pair : named) {
      if (bits > 8) deep.push_back(deepened(pair.images, bits, test_seed()));
      else pairs.push_back(pair.images);
   }
   const PixelCounts counts = bits > 8 ? compare_with_reference(configuration(), core(), named, deep)
                                       : compare_with_reference(configuration(), core(), named, pairs);
   EXPECT_GT(counts.valid, 0);
   if (configuration().algorithm->map_geometry(core().shape.image.width_px).has_check) EXPECT_GT(counts.invalid, 0);
   else EXPECT_EQ(counts.invalid, 0);
}

/// Records and bubbles of one frame and of some records behind it; the clocks of the records.
struct TimedFrame {
   std::vector<WideInput> clocks;
   std::vector<uint64_t> clock_of_record;

   TimedFrame(const CoreShape& core, int records, int stall_percent) {
      const Image& image = core.image;
      StimulusWriter writer(core, stall_percent, test_seed());
      writer.rows(random_pair(image.width_px, image.height_px, test_seed()), {0, image.height_px});
      writer.random_records(records);
      std::vector<WideInput> sent;
      int count = 0;
      for (const WideInput& in : writer.clocks) {
         if (in.valid && count == records) break;
         if (in.valid) clock_of_record.push_back(sent.size());
         count += in.valid ? 1 : 0;
         sent.push_back(in);
      }
      StimulusWriter after(image.pixels_per_clock, 0, test_seed());
      after.drain(core.schedule);
      sent.insert(sent.end(), after.clocks.begin(), after.clocks.end());
      clocks = std::move(sent);
   }
};

/// The places of the small configurations in the table.
std::vector<std::size_t> small_ones() {
   std::vector<std::size_t> places = tested_configurations();
   std::erase_if(places, [](std::size_t place) { return !is_small(configurations()[place]); });
   return places;
}

class NamedCoreLatencyTest : public NamedCoreTest {};
INSTANTIATE_TEST_SUITE_P(Named, NamedCoreLatencyTest, ::testing::ValuesIn(small_ones()),
                         [](const auto& test) { return configurations()[test.param].name; });

/// Records from a frame's first to the one that brings out its last disparities.
int whole_frame(const CoreShape& core) {
   return core.schedule.groups_to_first_output + (core.image.row_groups() - 1) * core.image.width_px +
          core.output_width_px - 1;
}

TEST_P(NamedCoreLatencyTest, TheFirstOutputComesExactlyTheLatencyAfterItsLastRecord) {
   const CoreShape& shape = core().shape;
   const uint64_t latency = uint64_t(shape.schedule.latency_clocks);
   for (const int stall_percent : {0, 50}) {
      const TimedFrame frame(shape, whole_frame(shape), stall_percent);
      const auto outputs = run_core(core(), frame.clocks);
      ASSERT_FALSE(outputs.empty());
      EXPECT_TRUE(outputs[0].start_of_frame);
      EXPECT_EQ(outputs[0].clock,
                frame.clock_of_record.at(std::size_t(shape.schedule.groups_to_first_output) - 1) + latency)
          << stall_percent << " % stalls";
      EXPECT_EQ(outputs.back().clock, frame.clock_of_record.back() + latency) << stall_percent << " % stalls";
   }
}

TEST_P(NamedCoreLatencyTest, TheFlushGroupsBringOutTheWholeFrameAndOneLessDoesNot) {
   const CoreShape& shape = core().shape;
   const int flush = shape.schedule.flush_groups;
   const std::size_t outputs = std::size_t(shape.output_width_px * shape.image.row_groups());
   const int records = shape.image.width_px * shape.image.row_groups() + flush;
   for (int missing = 0; missing <= (flush > 0 ? 1 : 0); ++missing) {
      const TimedFrame frame(shape, records - missing, 0);
      EXPECT_EQ(run_core(core(), frame.clocks).size(), outputs - std::size_t(missing));
   }
}

TEST(NamedCores, HaveModulesThatFitTheTable) {
   EXPECT_GE(tested_configurations().size(), 50u);
   for (const std::size_t place : tested_configurations()) {
      const Configuration& entry = configurations()[place];
      const CoreModule& core = core_module(entry.name);
      EXPECT_EQ(core.family, entry.family) << entry.name;
      EXPECT_EQ(core.shape.schedule.latency_clocks, entry.shape.schedule.latency_clocks) << entry.name;
   }
}

TEST(NamedCores, ListEachRegisterOnceUnderItsBlock) {
   for (const std::size_t place : tested_configurations()) {
      const Configuration& entry = configurations()[place];
      HeapMemories memories;
      const auto core = core_module(entry.name).make(memories);
      std::set<std::string> names;
      std::set<const void*> addresses;
      for (const RegisterView& shown : core->registers()) {
         EXPECT_TRUE(names.insert(shown.name).second) << entry.name << ": " << shown.name;
         // Traces name the ports so.
         EXPECT_FALSE(shown.name.starts_with("in_") || shown.name.starts_with("out_"))
             << entry.name << ": " << shown.name;
         EXPECT_TRUE(addresses.insert(shown.address).second) << entry.name << ": " << shown.name;
         EXPECT_NE(shown.name.find('_'), std::string::npos) << entry.name << ": " << shown.name;
      }
      EXPECT_GT(names.size(), 10u) << entry.name;
   }
}

TEST(Configurations, AreFoundByTheirNamesAndNoOther) {
   for (const Configuration& entry : configurations()) EXPECT_EQ(find_configuration(entry.name), &entry);
   EXPECT_EQ(find_configuration("no such configuration"), nullptr);
}

TEST(CoreModules, SayWhichOneIsMissing) {
   try {
      core_module("no_such_core");
      ADD_FAILURE() << "found";
   } catch (const NoCoreModule& missing) {
      EXPECT_NE(std::string(missing.what()).find("--target core_no_such_core"), std::string::npos) << missing.what();
   }
}

}  // namespace
}  // namespace stereo::test
