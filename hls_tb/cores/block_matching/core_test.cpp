// SPDX-License-Identifier: Apache-2.0
// The whole core against the reference, for each kind of image, after each stage.
#include "block_matching/config.hpp"
#include "definition/block_matching/reference_model.hpp"
#include "definition/mirror.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/small_cores.hpp"
#include "testing/test_pairs.hpp"

namespace stereo::test {
namespace {

class StereoCoreTest : public ::testing::TestWithParam<std::size_t> {
  protected:
   const SmallCore& core() const { return small_cores()[GetParam()]; }
};
INSTANTIATE_TEST_SUITE_P(Small, StereoCoreTest, ::testing::Range(std::size_t(0), small_cores().size()),
                         [](const auto& test) { return small_cores()[test.param].name; });

void expect_exact(const SmallCore& core, const ImagePair& pair, int stall_percent) {
   const block_matching::Config& config = core.config;
   const block_matching::Matching& parameters = config;
   const ImagePair upright = config.reference == Reference::right ? pair : mirrored(pair);
   const CostVolume costs = pixel_costs(upright.left, upright.right, parameters);

   StimulusWriter writer(config.pixels_per_clock, stall_percent, test_seed());
   writer.rows(pair, {0, config.height_px});
   writer.flush(core.shape.schedule);
   writer.random_records(2);  // the last column sums belong to no pixel of the map
   writer.drain(core.shape.schedule);
   HeapMemories memories;
   Stages stages;
   const auto outputs = core.run(writer.clocks, memories, &stages);

   EXPECT_TRUE(same_volume(column_sums(costs, config.window_px), stages.columns)) << "column sums";
   EXPECT_TRUE(same_volume(window_sums(costs, config.window_px), stages.sums)) << "window sums";
   const auto maps = collect_frames(outputs, core.shape);
   ASSERT_EQ(maps.size(), 1u);
   EXPECT_TRUE(same_map(match_reference(pair.left, pair.right, parameters), maps[0])) << "map";
}

TEST_P(StereoCoreTest, EqualsTheReferenceAfterEveryStage) {
   const block_matching::Config& config = core().config;
   for (const NamedPair& pair : test_pairs(config.width_px, config.height_px, config.disparities, test_seed()))
      for (const int stall_percent : {0, 30}) {
         SCOPED_TRACE(pair.name + ", " + std::to_string(stall_percent) + " % stalls");
         expect_exact(core(), pair.images, stall_percent);
      }
}

}  // namespace
}  // namespace stereo::test
