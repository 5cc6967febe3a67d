// SPDX-License-Identifier: Apache-2.0
#include "winner/left_right_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "block_matching/disparity_slice.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"
#include "winner/refinement.hpp"
#include "winner/winners.hpp"

namespace stereo::test {
namespace {

template <int D, int P, int Threshold, Reference Side, bool Subpixel = false, int Group = 2>
using CheckConfig = Exactly<block_matching::Config{
    {.width_px = 300, .height_px = 12, .pixels_per_clock = P},
    {DisparityCount{D}, ReferenceImage{Side}, LeftRightThreshold{Threshold}, SubpixelSteps{Subpixel}},
    {SliceSize{100}, WinnerGroup{Group}}}>;

template <class Config>
class LeftRightCheckTest : public ::testing::Test {};
using Configs =
    ::testing::Types<CheckConfig<8, 1, 1, Reference::right>, CheckConfig<8, 2, 0, Reference::left>,
                     CheckConfig<13, 4, 2, Reference::right, true>, CheckConfig<29, 1, 3, Reference::left, true, 16>,
                     CheckConfig<2, 1, 0, Reference::right, false, 3>, CheckConfig<256, 2, 255, Reference::right>,
                     CheckConfig<256, 1, 4, Reference::left>>;
TYPED_TEST_SUITE(LeftRightCheckTest, Configs, ConfigNames);

/// One column of winners, and the winners of the other image that leave their diagonals with it.
template <const block_matching::Config& C>
struct Record {
   Winners<C> winners;
   int other[C.pixels_per_clock] = {};
};

/// Clocks by which the other image's winners are ahead in a core.
template <const block_matching::Config& C>
constexpr int kAhead = block_matching::DisparitySlice<C>::kLevels + Refinement<C>::kClocks;

template <const block_matching::Config& C>
struct CheckBench {
   static constexpr int P = C.pixels_per_clock, D = C.disparities;

   Random random{test_seed()};
   HeapMemories memories;
   LeftRightCheck<C, kAhead<C>> block{memories, MemoryId<0>()};
   std::deque<Record<C>> on_their_way = std::deque<Record<C>>(kAhead<C>);
   std::vector<Record<C>> records;                                     ///< valid ones that have gone in
   std::deque<int> pipeline = std::deque<int>(block.kClocks - 1, -1);  ///< number of the record, -1: a bubble
   int consistent = 0, inconsistent = 0;

   Record<C> random_record() {
      Record<C> record;
      record.winners.tag = random_tag(random);
      for (int p = 0; p < P; ++p) {
         const bool near = random.percent(70);  // around the middle: about as far apart as the threshold
         const int reach = std::min(D, 2 * C.left_right_threshold + 3), low = near ? (D - reach) / 2 : 0;
         record.winners.disparity[p] = uint8_t(low + random.below(near ? reach : D));
         record.winners.fraction[p] = C.subpixel ? uint8_t(random.below(17)) : uint8_t(8);
         record.winners.passed[p] = random.percent(80);
         record.other[p] = low + random.below(near ? reach : D);
      }
      return record;
   }

   /// R(x) points at L(x+d), whose winner comes with column x+d; L(x) at R(x-d), whose winner comes D-1 columns later.
   bool passes(std::size_t n, int p) const {
      const int d = records[n].winners.disparity[p];
      const std::size_t with = n + std::size_t(C.reference == Reference::right ? d : D - 1 - d);
      return records[n].winners.passed[p] && std::abs(records.at(with).other[p] - d) <= C.left_right_threshold;
   }

   void clock() {
      const Record<C> newest = random_record();
      uint8_t other_winner[P];
      for (int p = 0; p < P; ++p) other_winner[p] = uint8_t(newest.other[p]);
      const Record<C> now = on_their_way.front();  // its winners were longer under way
      on_their_way.pop_front();
      on_their_way.push_back(newest);
      if (now.winners.tag.valid) records.push_back(now);
      pipeline.push_back(now.winners.tag.valid ? int(records.size()) - 1 : -1);
      block.clock(now.winners, other_winner);
      const int shown = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(block.checked.tag.valid, shown >= D - 1) << "the first D-1 places hold nothing yet";
      if (shown >= D - 1) compare(std::size_t(shown - (D - 1)));
   }

   void compare(std::size_t n) {
      const Winners<C>& expected = records[n].winners;
      const PixelTag &tag = expected.tag, &got = block.checked.tag;
      ASSERT_EQ(got.map_column, tag.map_column) << "record " << n;
      ASSERT_EQ(got.output_column, tag.output_column) << "record " << n;
      ASSERT_EQ(got.start_of_frame, tag.start_of_frame) << "record " << n;
      ASSERT_EQ(got.end_of_line, tag.end_of_line) << "record " << n;
      for (int p = 0; p < P; ++p) {
         ASSERT_EQ(block.checked.disparity[p], expected.disparity[p]) << "record " << n << " lane " << p;
         ASSERT_EQ(block.checked.fraction[p], expected.fraction[p]) << "record " << n << " lane " << p;
         ASSERT_EQ(block.checked.passed[p], passes(n, p)) << "record " << n << " lane " << p;
         if (!expected.passed[p]) continue;
         (passes(n, p) ? consistent : inconsistent) += 1;
      }
   }
};

TYPED_TEST(LeftRightCheckTest, ComparesWithThePixelThatIsPointedAt) {
   constexpr const block_matching::Config& C = TypeParam::kConfig;
   CheckBench<TypeParam::kConfig> bench;
   for (int clock = 0; clock < 4000 && !::testing::Test::HasFatalFailure(); ++clock) bench.clock();
   EXPECT_GT(bench.consistent, 200);
   if (C.left_right_threshold < C.disparities - 1) {
      EXPECT_GT(bench.inconsistent, 200);
   }
}

}  // namespace
}  // namespace stereo::test
