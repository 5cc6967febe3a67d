// SPDX-License-Identifier: Apache-2.0
// The chain of slices from columns of pixels to the best disparity.
#include "disparity_slice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <vector>

#include "models/random.hpp"
#include "support/seed.hpp"
#include "support/test_configs.hpp"

namespace stereo::test {
namespace {

template <class Config>
class DisparitySliceTest : public ::testing::Test {};
TYPED_TEST_SUITE(DisparitySliceTest, SmallConfigs, ConfigNames);

template <const StereoConfig& C>
struct Column {
   uint8_t left[C.tap_rows()] = {}, right[C.tap_rows()] = {};
   PixelTag tag;
};

template <const StereoConfig& C>
struct Winner {
   PixelTag tag;
   std::array<int, C.pixels_per_clock> cost{}, disparity{};
};

/// All records so far. Column n holds R(x) and L(x+D-1), so L(x+d) came with column n-(D-1)+d.
template <const StereoConfig& C>
struct Matched {
   std::vector<Column<C>> columns = std::vector<Column<C>>(C.disparities + C.window_px);  // reset: zeros came before

   int window_sum(int p, int d) const {
      int sum = 0;
      for (std::size_t n = columns.size() - C.window_px; n < columns.size(); ++n) {
         if (columns[n].tag.border_column) continue;
         const Column<C>& left = columns[n - std::size_t(C.disparities - 1 - d)];
         for (int t = p; t < p + C.window_px; ++t) sum += std::abs(columns[n].right[t] - left.left[t]);
      }
      return sum;
   }

   Winner<C> winner() const {
      Winner<C> winner;
      winner.tag = columns[columns.size() - 1 - C.radius_px()].tag;
      winner.tag.valid = true;
      for (std::size_t p = 0; p < C.pixels_per_clock; ++p) {
         std::vector<int> sums;
         for (int d = 0; d < C.disparities; ++d) sums.push_back(window_sum(int(p), d));
         const auto smallest = std::min_element(sums.begin(), sums.end());
         winner.cost[p] = *smallest;
         winner.disparity[p] = int(smallest - sums.begin());
      }
      return winner;
   }
};

TYPED_TEST(DisparitySliceTest, FindsTheSmallestDisparityOfTheSmallestSum) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   using Slices = DisparitySlice<C, C.disparities>;
   Random random(test_seed());
   Slices slices;
   Matched<C> matched;
   std::deque<Winner<C>> pipeline(Slices::latency() - 1);
   for (int clock = 0; clock < 1000; ++clock) {
      Column<C> in;
      in.tag = {.valid = !random.percent(25),
                .border_column = random.percent(10),
                .output_column = random.percent(50),
                .start_of_frame = random.percent(50),
                .end_of_line = random.percent(50)};
      const int levels = clock % 200 < 40 ? 1 : clock % 200 < 120 ? 2 : 256;  // 1 and 2: ties
      for (uint8_t& pixel : in.left) pixel = uint8_t(random.below(levels));
      for (uint8_t& pixel : in.right) pixel = uint8_t(random.below(levels));
      if (in.tag.valid) matched.columns.push_back(in);
      pipeline.push_back(in.tag.valid ? matched.winner() : Winner<C>{});
      slices.clock(in.left, in.right, in.tag, NoRival<C.pixels_per_clock>());
      const Winner<C> expected = pipeline.front();
      pipeline.pop_front();
      const auto& last = slices.last();
      ASSERT_EQ(last.best_tag.valid, expected.tag.valid) << "clock " << clock;
      if (!expected.tag.valid) continue;
      ASSERT_EQ(last.best_tag.output_column, expected.tag.output_column) << "clock " << clock;
      ASSERT_EQ(last.best_tag.start_of_frame, expected.tag.start_of_frame) << "clock " << clock;
      ASSERT_EQ(last.best_tag.end_of_line, expected.tag.end_of_line) << "clock " << clock;
      for (std::size_t p = 0; p < C.pixels_per_clock; ++p) {
         ASSERT_EQ(last.best_cost[p], expected.cost[p]) << "clock " << clock << " lane " << p;
         ASSERT_EQ(last.best_disparity[p], expected.disparity[p]) << "clock " << clock << " lane " << p;
      }
   }
}

/// Adds the sizes of the slices, the highest disparities first.
template <const StereoConfig& C, int Disparities>
void add_sizes(std::vector<int>& sizes) {
   using Slice = DisparitySlice<C, Disparities>;
   EXPECT_EQ(Slice::kFirst + Slice::kCount, Disparities);
   sizes.push_back(Slice::kCount);
   if constexpr (!Slice::kIsLast) add_sizes<C, Slice::kFirst>(sizes);
}

TYPED_TEST(DisparitySliceTest, HoldEachDisparityOnce) {
   static constexpr StereoConfig C = TypeParam::kConfig;
   std::vector<int> sizes, expected(std::size_t(C.disparities / C.slice_disparities), C.slice_disparities);
   add_sizes<C, C.disparities>(sizes);
   const int rest = C.disparities % C.slice_disparities;
   if (expected.empty() || rest > 1) expected.push_back(rest);
   else expected.back() += rest;
   EXPECT_EQ(sizes, expected);
   EXPECT_EQ(*std::max_element(sizes.begin(), sizes.end()), C.largest_slice());
}

}  // namespace
}  // namespace stereo::test
