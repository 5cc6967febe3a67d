// SPDX-License-Identifier: Apache-2.0
#include "frontend/pair_delay.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "block_matching/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "frontend/features.hpp"
#include "frontend/raster.hpp"
#include "scene/random.hpp"
#include "support/memory_bank.hpp"
#include "testing/seed.hpp"
#include "testing/test_configs.hpp"

namespace stereo::test {
namespace {

/// The definition, in columns of the images.
template <const block_matching::Config& C>
struct Meeting {
   static constexpr bool kRight = C.reference == Reference::right;
   /// The newest searched column that a reference column is compared with, seen from that one.
   static constexpr int kNewest = kRight ? C.min_disparity + C.disparities - 1 : -C.min_disparity;
   static constexpr int kReferenceWaits = kNewest > 0 ? kNewest : 0;
   static constexpr int kSearchWaits = kNewest < 0 ? -kNewest : 0;

   /// Whether the reference column that comes out beside column x of the image ahead, and all columns that it is
   /// compared with, lie in the row.
   static bool is_cost_column(int x) {
      const int reference = x - kReferenceWaits, newest = reference + kNewest, oldest = newest - (C.disparities - 1);
      return x >= 0 && x < C.width_px && reference >= 0 && oldest >= 0 && newest >= 0;
   }
   /// The map leaves out the rightmost cost column, or in the mirror image the leftmost.
   static bool is_map_column(int x) { return is_cost_column(x) && is_cost_column(kRight ? x + 1 : x - 1); }
};

template <class Config>
class PairDelayTest : public ::testing::Test {};
/// Beside the small ones: offsets of 0 and 1 for both references, and ranges that lie wholly on one side.
using Offsets = ::testing::Types<
    Exactly<block_matching::Config{{.width_px = 12, .height_px = 4}, {DisparityCount{5}, SmallestDisparity{-4}}, {}}>,
    Exactly<block_matching::Config{{.width_px = 12, .height_px = 4}, {DisparityCount{5}, SmallestDisparity{-5}}, {}}>,
    Exactly<block_matching::Config{{.width_px = 12, .height_px = 4}, {DisparityCount{5}, SmallestDisparity{6}}, {}}>,
    Exactly<block_matching::Config{{.width_px = 12, .height_px = 4},
                                   {DisparityCount{5}, SmallestDisparity{-1}, ReferenceImage{Reference::left}},
                                   {}}>,
    Exactly<block_matching::Config{{.width_px = 14, .height_px = 4},
                                   {DisparityCount{5}, SmallestDisparity{-8}, ReferenceImage{Reference::left}},
                                   {}}>,
    Exactly<block_matching::Config{
        {.width_px = 12, .height_px = 8, .pixels_per_clock = 2},
        {DisparityCount{5}, SmallestDisparity{1}, ReferenceImage{Reference::left}, Comparison{Cost::census},
         CensusWindow{.census_width_px = 9, .census_height_px = 7}},
        {}}>>;
using Configs = Both<AllSmallConfigs, Offsets>::Configs;
TYPED_TEST_SUITE(PairDelayTest, Configs, ConfigNames);

/// The newest record is column x of group g; the windows' centres are delay_groups above it.
template <const block_matching::Config& C>
void expect_tags(const PairDelay<C>& delay, int x, int g) {
   using Definition = Meeting<C>;
   constexpr int W = C.width_px, H = C.height_px, B = C.window_px;
   const int centre_y = (g - C.delay_groups()) * C.pixels_per_clock;
   const std::vector<int> taps = tap_offsets(C);
   for (std::size_t t = 0; t < taps.size(); ++t) {
      const int y = centre_y + taps[t];
      ASSERT_EQ(delay.row_inside[t], y >= 0 && y < H) << "group " << g << " t=" << t;
   }
   const auto is_cost = &Definition::is_cost_column;
   const bool map = Definition::is_map_column(x);
   ASSERT_EQ(delay.tag.row_start, x == 0) << "x=" << x;
   ASSERT_EQ(delay.tag.first_group, g == 0) << "x=" << x << " group " << g;
   ASSERT_EQ(delay.tag.border_column, !is_cost(x)) << "x=" << x;
   ASSERT_EQ(delay.tag.first_cost, is_cost(x) && !is_cost(x - 1)) << "x=" << x;
   ASSERT_EQ(delay.tag.map_column, map) << "x=" << x;
   ASSERT_EQ(delay.tag.first_column, map && !Definition::is_map_column(x - 1)) << "x=" << x;
   ASSERT_EQ(delay.tag.end_of_line, map && !Definition::is_map_column(x + 1)) << "x=" << x;
   const bool output = centre_y >= 0 && centre_y < H && map;
   ASSERT_EQ(delay.tag.output_column, output) << "x=" << x << " group " << g;
   ASSERT_EQ(delay.tag.start_of_frame, map && !Definition::is_map_column(x - 1) && centre_y == 0)
       << "x=" << x << " group " << g;
   // Columns of windows that have a centre in this row, or in the row before.
   if (is_cost(x)) {
      ASSERT_EQ(delay.tag.leaves_window, is_cost(x - B)) << "x=" << x;
   } else if (x < (Definition::kRight ? (B - 1) / 2 : B / 2)) {
      ASSERT_EQ(delay.tag.leaves_window, is_cost(W + x - B)) << "x=" << x;
   }
}

TYPED_TEST(PairDelayTest, HoldsOneImageBackAndTagsThePlace) {
   static constexpr block_matching::Config C = TypeParam::kConfig;
   constexpr int W = C.width_px, P = C.pixels_per_clock;
   using Definition = Meeting<C>;
   struct Group {
      Feature<C> search[P], reference[P];
   };
   const uint64_t mask = (uint64_t(1) << C.feature_bits()) - 1;
   Random random(test_seed());
   HeapMemories memories;
   PairDelay<C> delay(memories, MemoryId<0>());
   Raster<C> raster;
   std::vector<Group> groups;
   for (int n = 0; n < W * (C.row_groups() + C.delay_groups() + 1);) {
      const int x = n % W, g = n / W;
      Group now;
      for (int p = 0; p < P; ++p) {
         raster.features.search[p] = now.search[p] = Feature<C>(mix_bits(random.bits()) & mask);
         raster.features.reference[p] = now.reference[p] = Feature<C>(mix_bits(random.bits()) & mask);
      }
      raster.features.valid = !random.percent(25);
      raster.place.column = uint16_t(x);
      raster.place.group = uint16_t(g);
      delay.clock(raster);
      ASSERT_EQ(delay.tag.valid, raster.features.valid);
      if (!raster.features.valid) continue;
      groups.push_back(now);
      for (int p = 0; p < P; ++p) {
         if (n >= Definition::kSearchWaits) {
            ASSERT_EQ(delay.search(p), groups[std::size_t(n - Definition::kSearchWaits)].search[p])
                << "x=" << x << " group " << g << " lane " << p;
         }
         if (n >= Definition::kReferenceWaits) {
            ASSERT_EQ(delay.reference(p), groups[std::size_t(n - Definition::kReferenceWaits)].reference[p])
                << "x=" << x << " group " << g << " lane " << p;
         }
      }
      ASSERT_EQ(delay.column, x);
      ASSERT_NO_FATAL_FAILURE(expect_tags<C>(delay, x, g));
      ++n;
   }
}

}  // namespace
}  // namespace stereo::test
