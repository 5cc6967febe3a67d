// SPDX-License-Identifier: Apache-2.0
// The chain of slices from columns of pixels to the best disparity.
#include "block_matching/disparity_slice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "block_matching/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/features.hpp"
#include "frontend/pixel_tag.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/expect_candidate.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class DisparitySliceTest : public ::testing::Test {};
/// Beside the small ones: all that the checks need, from slice to slice in both directions.
using SliceConfigs = ::testing::Types<
    Exactly<block_matching::Config{
        {.width_px = 20, .height_px = 6},
        {DisparityCount{9}, TieRule{Ties::largest}, UniquenessPercent{10}, SubpixelSteps{true}},
        {SliceSize{2}}}>,
    Exactly<block_matching::Config{{.width_px = 20, .height_px = 6, .pixels_per_clock = 2},
                                   {DisparityCount{8}, MatchingWindow{2}, ReferenceImage{Reference::left},
                                    UniquenessPercent{10}, SubpixelSteps{true}},
                                   {SliceSize{3}}}>>;
using Configs = Both<SmallConfigs, SliceConfigs>::Configs;
TYPED_TEST_SUITE(DisparitySliceTest, Configs, ConfigNames);

template <const block_matching::Config& C>
struct Column {
   Feature<C> search[C.tap_rows()] = {}, reference[C.tap_rows()] = {};
   PixelTag tag;
};

template <const block_matching::Config& C>
struct Winner {
   PixelTag tag;
   std::array<NaiveWinner, C.pixels_per_clock> lanes;
};

/// All records so far. With a right reference, column n holds R(x) and L(x+m+D-1), so L(x+m+d) came with column
/// n-(D-1)+d; with a left one L(x) and R(x-m), so R(x-m-d) came with column n-d.
template <const block_matching::Config& C>
struct Matched {
   static constexpr bool kRight = C.reference == Reference::right;
   static constexpr int kAfter = kRight ? (C.window_px - 1) / 2 : C.window_px / 2;        ///< columns behind the centre
   std::vector<Column<C>> columns = std::vector<Column<C>>(C.disparities + C.window_px);  // reset: zeros came before

   int window_sum(int p, int d) const {
      int sum = 0;
      for (std::size_t n = columns.size() - C.window_px; n < columns.size(); ++n) {
         if (columns[n].tag.border_column) continue;
         const Column<C>& other = columns[n - std::size_t(kRight ? C.disparities - 1 - d : d)];
         for (int t = p; t < p + C.window_px; ++t) sum += std::abs(columns[n].reference[t] - other.search[t]);
      }
      return sum;
   }

   Winner<C> winner() const {
      Winner<C> winner;
      winner.tag = columns[columns.size() - 1 - kAfter].tag;
      winner.tag.valid = true;
      for (std::size_t p = 0; p < C.pixels_per_clock; ++p) {
         std::vector<int> sums;
         for (int d = 0; d < C.disparities; ++d) sums.push_back(window_sum(int(p), d));
         winner.lanes[p] = NaiveWinner(sums, C.ties);
      }
      return winner;
   }
};

TYPED_TEST(DisparitySliceTest, FindTheWinnerOfAllDisparities) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   using Slices = block_matching::DisparitySlice<C>;
   Random random(test_seed());
   HeapMemories memories;
   Slices slices(memories, MemoryId<0>());
   Matched<C> matched;
   std::deque<Winner<C>> pipeline(Slices::kClocks - 1);
   Winner<C> before;  // whose losers are shown
   for (int clock = 0; clock < 1000; ++clock) {
      Column<C> in;
      in.tag = random_tag(random);
      in.tag.border_column = random.percent(10);
      const int levels = clock % 200 < 40 ? 1 : clock % 200 < 120 ? 2 : 256;  // 1 and 2: ties
      for (auto& pixel : in.search) pixel = Feature<C>(random.below(levels));
      for (auto& pixel : in.reference) pixel = Feature<C>(random.below(levels));
      if (in.tag.valid) matched.columns.push_back(in);
      pipeline.push_back(in.tag.valid ? matched.winner() : Winner<C>{});
      slices.clock(in.search, in.reference, in.tag, block_matching::NoRival<C>());
      const Winner<C> expected = pipeline.front();
      pipeline.pop_front();
      const auto& last = slices.last();
      ASSERT_EQ(last.best_tag.valid, expected.tag.valid) << "clock " << clock;
      for (std::size_t p = 0; p < C.pixels_per_clock && before.tag.valid; ++p)
         ASSERT_NO_FATAL_FAILURE(expect_losers<C>(before.lanes[p], last.best.losers(int(p), 0)))
             << "clock " << clock << " lane " << p;
      before = expected;
      if (!expected.tag.valid) continue;
      ASSERT_PRED2(same_centre, expected.tag, last.best_tag) << "clock " << clock;
      for (std::size_t p = 0; p < C.pixels_per_clock; ++p)
         ASSERT_NO_FATAL_FAILURE(expect_candidate<C>(expected.lanes[p], last.best.get(int(p), 0)))
             << "clock " << clock << " lane " << p;
   }
}

/// Adds the sizes of the slices, in the order in which the searched pixels meet them.
template <const block_matching::Config& C, int Disparities, int Number>
void add_sizes(std::vector<int>& sizes) {
   using Slice = block_matching::DisparitySlice<C, Disparities, Number>;
   EXPECT_EQ(Slice::kFirst,
             C.reference == Reference::right ? Disparities - Slice::kCount : C.disparities - Disparities);
   sizes.push_back(Slice::kCount);
   if constexpr (!Slice::kIsLast) add_sizes<C, Slice::kRest, Number + 1>(sizes);
}

TYPED_TEST(DisparitySliceTest, HoldEachDisparityOnce) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   std::vector<int> sizes, expected(std::size_t(C.disparities / C.slice_disparities), C.slice_disparities);
   add_sizes<C, C.disparities, 0>(sizes);
   const int rest = C.disparities % C.slice_disparities;
   if (expected.empty() || rest > 1) expected.push_back(rest);
   else expected.back() += rest;
   EXPECT_EQ(sizes, expected);
   EXPECT_EQ(*std::max_element(sizes.begin(), sizes.end()), C.largest_slice());
}

}  // namespace
}  // namespace stereo::test
