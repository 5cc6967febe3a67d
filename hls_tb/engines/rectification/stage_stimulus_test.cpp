// SPDX-License-Identifier: Apache-2.0
#include "engines/rectification/stage_stimulus.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "cosim/stage_files.hpp"
#include "definition/rectification/reference_model.hpp"
#include "testing/seed.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

const Stage& tiny() { return *find_stage("rectify_tiny"); }
const Stage& deep() { return *find_stage("rectify_tiny_12bit"); }

ImagePair pair_of(const Stage& stage) {
   return random_pair(stage.config.width_px, stage.config.height_px, test_seed());
}

TEST(Stages, AreThoseOfTheTable) {
   ASSERT_NE(find_stage("rectify_tiny"), nullptr);
   ASSERT_NE(find_stage("rectify_vga"), nullptr);
   ASSERT_NE(find_stage("rectify_tiny_12bit"), nullptr);
   EXPECT_EQ(tiny().shape.pixel_bits, 8);
   EXPECT_EQ(deep().shape.pixel_bits, 12);
   EXPECT_EQ(find_stage("tiny"), nullptr);
   EXPECT_EQ(find_stage("rectify_vga")->description(), "640x480, a node every 16 pixels, 16 rows above and 16 below");
}

/// Without the nodes that are written during the frames, what leaves is what the definition makes with the tables that
/// were loaded.
template <class Pixel>
void expect_frame_of_the_loaded_tables(const Stage& stage, const PairOf<Pixel>& pair) {
   const rectification::Config& config = stage.config;
   const Stimulus stream =
       make_stimulus(stage.name, stage.shape, pair, {.frames = 1, .stall_percent = 20, .seed = test_seed()});
   std::vector<StageClock> clocks = make_stage_stimulus(stage, stream, test_seed());
   rectification::Table tables[2] = {{config, config.width_px, config.height_px},
                                     {config, config.width_px, config.height_px}};
   bool frames = false;
   for (StageClock& clock : clocks) {
      frames = frames || clock.in.valid;
      if (frames) clock.node.valid = false;
      if (clock.node.valid)
         tables[clock.node.right ? 1 : 0].at(clock.node.column, clock.node.row) = {clock.node.x, clock.node.y};
   }
   const RasterImage<Pixel> left = rectification::rectified(pair.left, tables[0], config);
   const RasterImage<Pixel> right = rectification::rectified(pair.right, tables[1], config);
   int compared = 0;
   bool started = false;
   for (const StageOutput& output : run_stage(stage, clocks)) {
      started = started || output.start_of_frame;
      if (!started || output.y >= config.height_px) continue;
      ASSERT_EQ(output.left, left.at(output.x, output.y)) << "x=" << output.x << " y=" << output.y;
      ASSERT_EQ(output.right, right.at(output.x, output.y)) << "x=" << output.x << " y=" << output.y;
      ++compared;
   }
   EXPECT_EQ(compared, config.width_px * config.height_px);
}

TEST(StageStimulus, LoadsTheTablesOfWhichTheFramesAreMade) {
   expect_frame_of_the_loaded_tables(tiny(), pair_of(tiny()));
}

TEST(StageStimulus, LoadsTheTablesBeforePixelsOf12Bits) {
   constexpr int kBits = 12;
   const rectification::Config& config = deep().config;
   expect_frame_of_the_loaded_tables(
       deep(), random_deep_pair(config.width_px, config.height_px, test_seed(), kBits, 1 << kBits));
}

TEST(StageStimulus, LoadsTheTablesAgainAfterEachReset) {
   const Stimulus stream = make_broken_stimulus(tiny().name, tiny().shape, pair_of(tiny()), 40, 10, test_seed());
   ASSERT_FALSE(stream.resets.empty());
   const std::size_t nodes = 2U * unsigned(tiny().config.table_columns() * tiny().config.table_rows());
   std::set<std::tuple<bool, int, int>> loaded;
   std::size_t resets = 0, writes = 0;
   for (const auto& [in, node, reset] : make_stage_stimulus(tiny(), stream, test_seed())) {
      if (reset) loaded.clear();
      resets += reset ? 1 : 0;
      if (in.valid && !reset) {
         ASSERT_EQ(loaded.size(), nodes);
      }
      if (!node.valid) continue;
      ASSERT_FALSE(reset);
      ASSERT_LT(node.column, tiny().config.table_columns());
      ASSERT_LT(node.row, tiny().config.table_rows());
      loaded.insert({node.right, node.column, node.row});
      writes += in.valid ? 1 : 0;
   }
   EXPECT_EQ(resets, stream.resets.size());
   EXPECT_GT(writes, 0U) << "nodes are written while frames are under way";
}

TEST(StageFiles, HaveThreeDigitsForAPixelOf12Bits) {
   std::ostringstream stimulus, expected;
   write_stage_stimulus(stimulus, deep(),
                        {{{.left = {0x0a}, .right = {0xfff}, .start_of_frame = true, .valid = true}, {}}});
   write_stage_expected(expected, deep(), {{50, 0, 0, 0, 0x12, 0xabc, true}});
   EXPECT_EQ(stimulus.str(),
             "stereo-hls stimulus 2 config=rectify_tiny_12bit pixels=1 clocks=1 pixel_bits=12\n"
             "03 00a fff 0000 0000 0000 0000\n");
   EXPECT_EQ(expected.str(),
             "stereo-hls expected 2 config=rectify_tiny_12bit pixels=1 disparity_bits=24 outputs=1 latency=" +
                 std::to_string(deep().shape.schedule.latency_clocks) + "\n50 0 0 0 abc012 1\n");
}

TEST(StageFiles, HaveAFieldForEachPort) {
   std::ostringstream stimulus, expected;
   write_stage_stimulus(stimulus, tiny(),
                        {{{.left = {0x0a}, .right = {0xff}, .start_of_frame = true, .valid = true}, {}},
                         {{}, {true, true, 3, 2, -1, 256}},
                         {{}, {}, true}});
   write_stage_expected(expected, tiny(), {{50, 0, 0, 0, 0x12, 0xab, true}, {51, 1, 0, 0, 7, 0, false}});
   EXPECT_EQ(stimulus.str(),
             "stereo-hls stimulus 2 config=rectify_tiny pixels=1 clocks=3\n03 0a ff 0000 0000 0000 0000\n"
             "18 00 00 0003 0002 ffff 0100\n04 00 00 0000 0000 0000 0000\n");
   EXPECT_EQ(expected.str(), "stereo-hls expected 2 config=rectify_tiny pixels=1 disparity_bits=16 outputs=2 latency=" +
                                 std::to_string(tiny().shape.schedule.latency_clocks) +
                                 "\n"
                                 "50 0 0 0 ab12 1\n51 1 0 0 0007 0\n");
}

}  // namespace
}  // namespace stereo::test
