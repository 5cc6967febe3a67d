// SPDX-License-Identifier: Apache-2.0
#include "postprocessing/post_processor.hpp"

#include "block_matching/config.hpp"
#include "block_matching/core.hpp"
#include "definition/mirror.hpp"
#include "definition/postprocessing.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/stimulus.hpp"
#include "testing/map_compare.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

constexpr PostProcessing kFilter{.support_threshold = 4};
constexpr PostProcessing kSure{.support_threshold = 3, .confidence = true, .margin_weight = 3, .support_weight = 5};
constexpr PostProcessing kFill{.fill_holes = true};
constexpr PostProcessing kAll{.support_threshold = 3, .confidence = true, .fill_holes = true};
constexpr PostProcessing kBoth{.support_threshold = 6, .fill_holes = true};

template <int W, int H, int D, int P, PostProcessing Post, Reference Side, bool Subpixel, bool Median, bool Full>
using PostConfig = Exactly<block_matching::Config{{.width_px = W, .height_px = H, .pixels_per_clock = P},
                                                  {DisparityCount{D}, ReferenceImage{Side}, SubpixelSteps{Subpixel},
                                                   MedianFilter{Median}, FullWidth{.full_width = Full}, Post},
                                                  {}}>;
constexpr Reference kLeft = Reference::left, kRight = Reference::right;

template <class Config>
class PostProcessorTest : public ::testing::Test {};
/// Each stage alone and with others, P 1, 2 and 4, both references, two columns between rows and many, the lowest and
/// the narrowest images, and the largest range of disparities.
using Few = ::testing::Types<PostConfig<30, 9, 8, 1, kFilter, kRight, false, false, false>,
                             PostConfig<41, 10, 12, 2, kAll, kRight, true, true, true>,
                             PostConfig<33, 12, 6, 4, kBoth, kLeft, true, true, true>>;
using More = ::testing::Types<
    PostConfig<30, 9, 8, 1, kSure, kLeft, true, false, true>, PostConfig<30, 8, 8, 1, kFill, kLeft, true, false, true>,
    PostConfig<30, 8, 8, 1, kFill, kRight, false, true, false>, PostConfig<40, 9, 12, 1, kAll, kLeft, true, true, true>,
    PostConfig<40, 12, 12, 4, kSure, kLeft, false, true, false>,
    PostConfig<33, 8, 6, 2, kSure, kRight, false, false, false>,
    PostConfig<33, 8, 6, 4, kFill, kRight, false, false, true>, PostConfig<13, 3, 4, 1, kAll, kRight, true, true, true>,
    PostConfig<270, 4, 256, 1, kAll, kRight, true, false, false>>;
using Configs = FewOrAll<Few, More>;
TYPED_TEST_SUITE(PostProcessorTest, Configs);

/// Sends maps as the winners of a core come: the map's columns of each row of groups between other columns.
template <const block_matching::Config& C>
struct PostBench {
   static constexpr int P = C.pixels_per_clock, W = C.width_px;
   static constexpr int kFirst = W - C.output_width_px() > 1 ? 1 : 0;  ///< where the map's columns stand in a row

   Random random{test_seed()};
   HeapMemories memories;
   PostProcessor<C> block{memories, MemoryId<0>()};
   FixedSize<C> size;
   OutputLocator locator{P};
   std::vector<CoreOutput> outputs;
   uint64_t clocks = 0;
   int valid_percent = 70;

   void clock(const Winners<C>& in) {
      block.clock(in, size);
      ++clocks;
      const auto out = shown(block.group());
      if (out.valid) outputs.push_back(locator.locate(clocks, out));
   }

   Winners<C> garbage() {
      Winners<C> in;
      for (int p = 0; p < P; ++p) {
         // Neighbours are often alike, and holes of any width.
         if (random.percent(20)) level = random.below(C.disparities);
         if (random.percent(15)) holds = random.percent(valid_percent);
         const int d = random.percent(10) ? random.below(C.disparities) : level;
         in.disparity[p] = uint8_t(d);
         const bool at_an_end = d == 0 || d == C.disparities - 1;
         in.fraction[p] = C.subpixel && !at_an_end ? uint8_t(random.below(17)) : uint8_t(8);
         in.passed[p] = holds && random.percent(95);
         if constexpr (kHasMargin<C>) in.margin.value[p] = uint8_t(random.below(64));
      }
      in.tag = random_tag(random);
      return in;
   }
   int level = 0;
   bool holds = true;

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

   /// What the stages make of the first `records` of a frame.
   DisparityMap send_records(int records) {
      DisparityMap map(C.output_width_px(), C.height_px, 0, C.subpixel);
      GrayImage margins(map.width, map.height);
      for (int n = 0; n < records; ++n) {
         bubbles();
         const int x = n % W, group = n / W;
         if (x == 0 && random.percent(15)) holds = false;
         const Winners<C> in = record(x, group);
         for (int p = 0; p < P && in.tag.map_column; ++p) {
            const int disparity = C.subpixel ? 16 * in.disparity[p] + in.fraction[p] - 8 : in.disparity[p];
            map.at(x - kFirst, group * P + p) = uint16_t(disparity);
            map.valid_at(x - kFirst, group * P + p) = in.passed[p] ? 1 : 0;
            if constexpr (kHasMargin<C>) margins.at(x - kFirst, group * P + p) = in.margin.value[p];
         }
         clock(in);
      }
      return expected(map, margins);
   }
   static DisparityMap expected(const DisparityMap& map, const GrayImage& margins) {
      if (C.reference == Reference::left) return mirrored(stages(mirrored(map), mirrored(margins)));
      return stages(map, margins);
   }
   static DisparityMap stages(const DisparityMap& map, const GrayImage& margins) {
      const DisparityMap result = post_processed(map, margins, C);
      return C.median ? median_filtered(result) : result;
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
   std::vector<DisparityMap> maps() const { return collect_frames(outputs, core_shape<block_matching::Core<C>>()); }
};

TYPED_TEST(PostProcessorTest, FramesBackToBackAndApart) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   for (const int valid_percent : {0, 3, 30, 70, 100}) {
      PostBench<C> bench;
      bench.valid_percent = valid_percent;
      std::vector<DisparityMap> sent;
      for (int frame = 0; frame < 9; ++frame) {
         sent.push_back(bench.send_frame());
         // Nothing, what the last rows wait for, or more.
         const int lengths[] = {0, bench.block.kLagGroups, 7 * C.width_px};
         bench.send_flush(lengths[frame % 3]);
      }
      bench.drain();
      const auto maps = bench.maps();
      ASSERT_EQ(maps.size(), sent.size());
      for (std::size_t i = 0; i < maps.size(); ++i)
         EXPECT_TRUE(same_map(sent[i], maps[i])) << "frame " << i << " of " << valid_percent << " % valid";
   }
}

TYPED_TEST(PostProcessorTest, AStartOfFrameRestartsAtAnyPlace) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   for (int round = 0; round < 40; ++round) {
      PostBench<C> bench;
      bench.random = Random(test_seed() + uint64_t(round));
      for (int broken = 0; broken < 1 + round % 3; ++broken)
         bench.send_records(1 + bench.random.below(C.width_px * C.row_groups() - 1));
      const DisparityMap sent = bench.send_frame();
      bench.send_flush(bench.block.kLagGroups);
      bench.drain();
      std::vector<CoreOutput> last;
      for (const CoreOutput& output : bench.outputs) {
         if (output.start_of_frame) last.clear();
         last.push_back(output);
         last.back().frame = 0;
      }
      const auto maps = collect_frames(last, core_shape<block_matching::Core<C>>());
      ASSERT_EQ(maps.size(), 1u);
      EXPECT_TRUE(same_map(sent, maps[0])) << "round " << round;
   }
}

TYPED_TEST(PostProcessorTest, IsSilentBeforeTheFirstFrameAndLongAfterIt) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   PostBench<C> bench;
   bench.send_flush(5 * C.width_px);
   bench.drain();
   EXPECT_EQ(bench.outputs.size(), 0u);
   bench.send_frame();
   bench.send_flush(3 * C.width_px * C.row_groups());
   bench.drain();
   EXPECT_EQ(bench.maps().size(), 1u);
}

TEST(PostProcessingLimits, EachHasASentence) {
   const block_matching::Config fits{{.width_px = 32, .height_px = 12}, {DisparityCount{8}, kAll}, {}};
   EXPECT_EQ(std::string(fits.problem().text), "");
   const auto problem = [&](auto change) {
      block_matching::Config config = fits;
      change(config);
      return std::string(config.problem().text);
   };
   EXPECT_EQ(problem([](auto& c) {
                c.height_px = 2;
                c.window_px = 2;
             }),
             "the image must be higher than the rows that the support filter waits for");
   EXPECT_EQ(problem([](auto& c) {
                c.support_threshold = 0;
                c.confidence = false;
                c.window_px = 2;
                c.height_px = 8;
                c.pixels_per_clock = 4;
                c.width_px = 12;
             }),
             "with post-processing the image must have 13 columns or more");
   EXPECT_EQ(problem([](auto& c) { c.support_threshold = 0; }), "confidence needs a support threshold of 1 or more");
   EXPECT_EQ(problem([](auto& c) { c.support_threshold = 36; }), "the support threshold is 36 but must be 0 ... 35");
   EXPECT_EQ(problem([](auto& c) {
                c.pixels_per_clock = 4;
                c.subpixel = true;
             }),
             "four pixels a clock have no room for a confidence beside filled or fractional disparities");
}

/// Rows of holes of one pixel and valid ones of one: as many ends of holes as the memory must hold.
TEST(HoleEnds, HoldsAsManyEndsAsRowsCanHave) {
   static constexpr block_matching::Config C = PostConfig<41, 12, 8, 1, kFill, kLeft, true, false, true>::kConfig;
   for (int round = 0; round < 60; ++round) {
      HeapMemories memories;
      PostProcessor<C> block{memories, MemoryId<0>()};
      const FixedSize<C> size;
      Random random(test_seed() + uint64_t(round));
      DisparityMap map(C.output_width_px(), C.height_px, 0, true);
      OutputLocator locator{1};
      std::vector<CoreOutput> outputs;
      for (int n = 0; n < C.width_px * (C.height_px + 1) + block.kClocks; ++n) {
         const int x = n % C.width_px, y = n / C.width_px;
         Winners<C> in;
         in.disparity[0] = uint8_t(random.below(C.disparities - 2) + 1);
         in.passed[0] = random.percent(3) ? random.percent(50) : (x + (round + y) / (1 + round % 3)) % 2 == 0;
         in.tag.valid = y <= C.height_px;
         in.tag.map_column = x < map.width;
         in.tag.output_column = in.tag.map_column && y < C.height_px;
         in.tag.start_of_frame = n == 0;
         in.tag.end_of_line = x == map.width - 1;
         if (in.tag.output_column) {
            map.at(x, y) = uint16_t(16 * in.disparity[0]);
            map.valid_at(x, y) = in.passed[0] ? 1 : 0;
         }
         block.clock(in, size);
         const auto out = shown(block.group());
         if (out.valid) outputs.push_back(locator.locate(uint64_t(n), out));
      }
      const auto maps = collect_frames(outputs, core_shape<block_matching::Core<C>>());
      ASSERT_EQ(maps.size(), 1u);
      ASSERT_TRUE(same_map(mirrored(holes_filled(mirrored(map))), maps[0])) << "round " << round;
   }
}

}  // namespace
}  // namespace stereo::test
