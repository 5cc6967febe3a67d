// SPDX-License-Identifier: Apache-2.0
#include "block_matching/texture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "block_matching/disparity_slice.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/features.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <int B, int P, int Cap, int Threshold, Cost Kind, Reference Side, int CostClocks>
using TextureConfig = Exactly<block_matching::Config{
    {.width_px = 30, .height_px = 12, .pixels_per_clock = P},
    {DisparityCount{8}, MatchingWindow{B}, ReferenceImage{Side}, Comparison{Kind},
     Prefiltering{.prefilter = Prefilter::xsobel, .prefilter_cap = Cap}, block_matching::TextureThreshold{Threshold}},
    {SliceSize{3}, block_matching::CostSteps{.cost_clocks = CostClocks}}}>;

template <class Config>
class TextureTest : public ::testing::Test {};
using Configs = ::testing::Types<TextureConfig<3, 1, 31, 9, Cost::sad, Reference::right, 3>,
                                 TextureConfig<3, 4, 63, 9, Cost::sad, Reference::left, 1>,
                                 TextureConfig<2, 2, 1, 3, Cost::ssd, Reference::right, 2>,
                                 TextureConfig<5, 1, 31, 20, Cost::ssd, Reference::left, 3>>;
TYPED_TEST_SUITE(TextureTest, Configs, ConfigNames);

/// docs/algorithm.md, 5., on columns of taps.
template <const block_matching::Config& C>
struct TextureBench {
   static constexpr int P = C.pixels_per_clock, B = C.window_px, kTaps = C.tap_rows();
   static constexpr int kClocks = block_matching::DisparitySlice<C>::kClocks;
   struct Column {
      PixelTag tag;
      std::array<int, kTaps> texture{};  ///< |f - cap|; 0 outside the image
   };
   struct Step {
      bool valid = false;
      std::array<int, P> textures{};
   };

   Random random{test_seed()};
   HeapMemories memories;
   LineBuffer<C> rows{memories, MemoryId<0>()};
   block_matching::Texture<C, kClocks> block{memories, MemoryId<LineBuffer<C>::kMemories>()};
   std::vector<Column> columns = std::vector<Column>(B);  // reset: nothing came before
   std::deque<Step> pipeline = std::deque<Step>(kClocks - 1);
   int below = 0, at = 0, above = 0;  ///< the threshold

   Step random_column() {
      Column column;
      column.tag = random_tag(random);
      column.tag.border_column = random.percent(10);
      rows.tag = column.tag;
      for (int t = 0; t < kTaps; ++t) {
         rows.inside[t] = random.percent(85);
         const int deviation =
             random.percent(80) ? random.below(3) - 1 : random.below(2 * C.prefilter_cap + 1) - C.prefilter_cap;
         rows.reference[t] = Feature<C>(rows.inside[t] ? C.prefilter_cap + deviation : 0);
         if (rows.inside[t] && !column.tag.border_column) column.texture[std::size_t(t)] = std::abs(deviation);
      }
      Step step;
      step.valid = column.tag.valid;
      if (!step.valid) return step;
      columns.push_back(column);
      for (int p = 0; p < P; ++p)
         for (std::size_t n = columns.size() - B; n < columns.size(); ++n)
            for (int t = p; t < p + B; ++t) step.textures[std::size_t(p)] += columns[n].texture[std::size_t(t)];
      return step;
   }

   void clock() {
      pipeline.push_back(random_column());
      block.clock(rows, NoSettings());
      const Step now = pipeline.front();
      pipeline.pop_front();
      if (!now.valid) return;
      for (int p = 0; p < P; ++p) {
         const int texture = now.textures[std::size_t(p)];
         ASSERT_EQ(block.passed(p), texture >= C.texture_threshold) << "texture " << texture << " lane " << p;
         (texture < C.texture_threshold ? below : texture == C.texture_threshold ? at : above) += 1;
      }
   }
};

TYPED_TEST(TextureTest, PassesFromTheThresholdOnInStepWithTheWinners) {
   TextureBench<TypeParam::kConfig> bench;
   for (int clock = 0; clock < 20000 && !::testing::Test::HasFatalFailure(); ++clock) bench.clock();
   for (const int count : {bench.below, bench.at, bench.above}) EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace stereo::test
