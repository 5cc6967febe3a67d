// SPDX-License-Identifier: Apache-2.0
// BlockRanges and WindowTargets: from a coarse map to the targets of each band.
#include "dynamic_range/window_targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "definition/dynamic_range/search_windows.hpp"
#include "dynamic_range/config.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using dynamic_range::Config;

constexpr Config config(int width, int height, int disparities, int window_disparities) {
   Config c;
   c.width_px = width;
   c.height_px = height;
   c.disparities = disparities;
   c.window_disparities = window_disparities;
   return c;
}
constexpr Config kSmall = config(40, 32, 32, 16), kWide = config(152, 40, 128, 24), kLong = config(72, 136, 64, 16);

/// Patches of similar disparities, of which some do not count.
DisparityMap random_map(Random& random, const Config& c) {
   DisparityMap map(c.coarse_columns(), c.coarse_rows());
   const int empty_percent = random.percent(25) ? 90 : 20;
   int patch = 0;
   for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
         if (random.percent(15)) patch = random.below(c.coarse_disparities());
         map.at(x, y) = uint16_t(std::min(patch + random.below(2), c.coarse_disparities() - 1));
         map.valid_at(x, y) = random.percent(empty_percent) ? 0 : 1;
      }
   return map;
}

template <const Config& C>
void expect_targets() {
   Random random(test_seed());
   HeapMemories memories;
   dynamic_range::BlockRanges<C> ranges(memories, MemoryId<0>());
   dynamic_range::WindowTargets<C> targets(memories, MemoryId<ranges.kMemories>());
   using Targets = decltype(targets);
   for (int frame = 0; frame < 6; ++frame) {
      const DisparityMap map = random_map(random, C);
      std::map<int, std::pair<int, int>> written;
      dynamic_range::Targets found{dynamic_range::Blocks<int>(C.block_columns(), C.block_rows(), -1),
                                   dynamic_range::Blocks<int>(C.block_columns(), C.block_rows(), -1)};
      int band = 0;
      const auto clock = [&](const StereoOutput& out) {
         const int place = targets.place;
         targets.clock(ranges);
         ranges.clock(out);
         if (targets.place == place) return;
         const int column = targets.place & ((1 << Targets::kColumnBits) - 1);
         ASSERT_EQ(targets.place >> Targets::kColumnBits, band % Targets::kBands);
         ASSERT_LT(band, C.block_rows());
         found.low.at(column, band) = targets.low;
         found.high.at(column, band) = targets.high;
         band += column == 0 ? 1 : 0;
      };
      for (int y = 0; y < map.height; ++y) {
         for (int x = 0; x < map.width; ++x) {
            while (random.percent(20)) clock(StereoOutput());
            StereoOutput out;
            out.valid = true;
            out.start_of_frame = x == 0 && y == 0;
            out.end_of_line = x == map.width - 1;
            out.disparity[0] = map.at(x, y);
            out.pixel_valid[0] = map.valid_at(x, y);
            clock(out);
         }
         // As many clocks as the repeated pixels take, and the rows of pixels until the next coarse row.
         for (int i = 0; i < 3 * C.width_px; ++i) clock(StereoOutput());
      }
      ASSERT_EQ(band, C.block_rows()) << "frame " << frame;
      const dynamic_range::Targets wanted = dynamic_range::search_targets(dynamic_range::block_ranges(map), C);
      EXPECT_EQ(found.low.values, wanted.low.values) << "frame " << frame;
      EXPECT_EQ(found.high.values, wanted.high.values) << "frame " << frame;
   }
}

TEST(WindowTargets, AreThoseOfTheDefinition) {
   expect_targets<kSmall>();
   expect_targets<kWide>();
   expect_targets<kLong>();
}

}  // namespace
}  // namespace stereo::test
