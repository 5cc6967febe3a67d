// SPDX-License-Identifier: Apache-2.0
#include "winner/median.hpp"

#include "block_matching/config.hpp"
#include "block_matching/core.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"
#include "winner/winners.hpp"

namespace stereo::test {
namespace {

template <int W, int H, int D, int B, int P, Reference Side = Reference::right, bool Subpixel = false>
using MedianConfig = Exactly<block_matching::Config{
    {.width_px = W, .height_px = H, .pixels_per_clock = P},
    {DisparityCount{D}, MatchingWindow{B}, ReferenceImage{Side}, SubpixelSteps{Subpixel}, MedianFilter{true}},
    {}}>;

template <class Config>
class MedianTest : public ::testing::Test {};
/// Maps of one column, of two, of two rows, of two groups of rows.
using Configs = ::testing::Types<MedianConfig<20, 7, 6, 3, 1>, MedianConfig<20, 12, 6, 3, 2, Reference::left, true>,
                                 MedianConfig<20, 12, 6, 3, 4, Reference::right, true>, MedianConfig<9, 6, 8, 3, 1>,
                                 MedianConfig<9, 6, 8, 3, 2, Reference::left>, MedianConfig<10, 8, 8, 3, 4>,
                                 MedianConfig<12, 4, 4, 2, 2>, MedianConfig<12, 2, 4, 2, 1, Reference::left>,
                                 MedianConfig<9, 8, 8, 2, 4>>;
TYPED_TEST_SUITE(MedianTest, Configs, ConfigNames);

/// Sends maps as the core's winners come: the map's columns of each row of groups between other columns.
template <const block_matching::Config& C>
struct MedianBench {
   static constexpr int P = C.pixels_per_clock, W = C.width_px;
   /// Where the map's columns stand in a row of the stream.
   static constexpr int kFirst = C.first_cost_column() + (C.reference == Reference::left ? 1 : 0);

   Random random{test_seed()};
   HeapMemories memories;
   Median<C> block{memories, MemoryId<0>()};
   OutputLocator locator{P};
   std::vector<CoreOutput> outputs;
   uint64_t clocks = 0;

   void clock(const Winners<C>& in) {
      block.clock(in);
      ++clocks;
      if (!block.out.valid) return;
      StereoOutput shown;
      for (int p = 0; p < P; ++p) {
         shown.disparity[p] = block.out.disparity[p];
         shown.pixel_valid[p] = block.out.passed[p];
      }
      shown.start_of_frame = block.out.start_of_frame;
      shown.end_of_line = block.out.end_of_line;
      outputs.push_back(locator.locate(clocks, shown));
   }

   Winners<C> garbage() {
      Winners<C> in;
      for (int p = 0; p < P; ++p) {
         in.disparity[p] = uint8_t(random.below(C.disparities));
         const bool at_an_end = in.disparity[p] == 0 || in.disparity[p] == C.disparities - 1;
         in.fraction[p] = C.subpixel && !at_an_end ? uint8_t(random.below(17)) : uint8_t(8);
         in.passed[p] = random.percent(50);
      }
      in.tag = random_tag(random);
      return in;
   }

   /// A record at its place in the stream; `group` counts from the map's first.
   Winners<C> record(int x, int group) {
      Winners<C> in = garbage();
      in.tag.valid = true;
      in.tag.map_column = x >= kFirst && x < kFirst + C.output_width_px();
      in.tag.output_column = in.tag.map_column && group < C.row_groups();
      in.tag.start_of_frame = x == kFirst && group == 0;
      in.tag.end_of_line = x == kFirst + C.output_width_px() - 1;
      return in;
   }
   void bubbles() {
      while (random.percent(25)) {
         Winners<C> in = garbage();
         in.tag.valid = false;
         clock(in);
      }
   }

   /// The first `records` of a frame. The map that went in, as far as it did.
   DisparityMap send_records(int records) {
      DisparityMap map(C.output_width_px(), C.height_px, 0, C.subpixel);
      for (int n = 0; n < records; ++n) {
         bubbles();
         const int x = n % W, group = n / W;
         const Winners<C> in = record(x, group);
         for (int p = 0; p < P && in.tag.map_column; ++p) {
            const int disparity = C.subpixel ? 16 * in.disparity[p] + in.fraction[p] - 8 : in.disparity[p];
            map.at(x - kFirst, group * P + p) = uint16_t(disparity);
            map.valid_at(x - kFirst, group * P + p) = in.passed[p] ? 1 : 0;
         }
         clock(in);
      }
      return map;
   }
   DisparityMap send_frame() { return send_records(W * C.row_groups()); }
   /// Rows of groups behind a frame.
   void send_flush(int records) {
      for (int n = 0; n < records; ++n) {
         bubbles();
         clock(record(n % W, C.row_groups() + n / W));
      }
   }
   void drain() {
      for (int i = 0; i < block.kClocks; ++i) {
         Winners<C> in = garbage();
         in.tag.valid = false;
         clock(in);
      }
   }
};

TYPED_TEST(MedianTest, FramesBackToBackAndApart) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   MedianBench<C> bench;
   std::vector<DisparityMap> sent;
   for (int frame = 0; frame < 12; ++frame) {
      sent.push_back(bench.send_frame());
      // Nothing, the row that the last one waits for, or more.
      const int lengths[] = {0, C.width_px, 3 * C.width_px};
      bench.send_flush(lengths[frame % 3]);
   }
   bench.drain();
   const auto maps = collect_frames(bench.outputs, core_shape<block_matching::Core<C>>());
   ASSERT_EQ(maps.size(), sent.size());
   for (std::size_t i = 0; i < maps.size(); ++i)
      EXPECT_TRUE(same_map(median_filtered(sent[i]), maps[i])) << "frame " << i;
}

TYPED_TEST(MedianTest, AStartOfFrameRestartsAtAnyPlace) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   for (int round = 0; round < 40; ++round) {
      MedianBench<C> bench;
      bench.random = Random(test_seed() + uint64_t(round));
      bench.send_records(1 + bench.random.below(C.width_px * C.row_groups() - 1));
      // A new frame starts with a new row of the stream: the core's counters see to that.
      const DisparityMap sent = bench.send_frame();
      bench.send_flush(C.width_px + 1);
      bench.drain();
      std::vector<CoreOutput> last;
      for (const CoreOutput& output : bench.outputs) {
         if (output.start_of_frame) last.clear();
         last.push_back(output);
         last.back().frame = 0;
      }
      const auto maps = collect_frames(last, core_shape<block_matching::Core<C>>());
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(median_filtered(sent), maps[0])) << "round " << round;
   }
}

TYPED_TEST(MedianTest, IsSilentBeforeTheFirstFrameAndLongAfterIt) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   MedianBench<C> bench;
   bench.send_flush(5 * C.width_px);
   bench.drain();
   EXPECT_EQ(bench.outputs.size(), 0u);
   bench.send_frame();
   bench.send_flush(5 * C.width_px * C.row_groups());
   bench.drain();
   EXPECT_EQ(collect_frames(bench.outputs, core_shape<block_matching::Core<C>>()).size(), 1u);
}

}  // namespace
}  // namespace stereo::test
