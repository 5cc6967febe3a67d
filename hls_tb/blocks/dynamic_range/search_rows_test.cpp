// SPDX-License-Identifier: Apache-2.0
// WindowBases, SearchRows and WindowChain with random targets: where the search windows stand, and what they compare.
#include "dynamic_range/search_rows.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "definition/dynamic_range/search_windows.hpp"
#include "dynamic_range/core.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using dynamic_range::Config;

constexpr Config config(int width, int disparities, int window_disparities, int window_px) {
   Config c;
   c.width_px = width;
   c.height_px = 40;
   c.disparities = disparities;
   c.window_disparities = window_disparities;
   c.window_px = window_px;
   return c;
}
constexpr Config kSmall = config(40, 32, 16, 3), kWide = config(120, 96, 24, 9);

/// What the clocked blocks see of a column: its place, or a bubble.
struct Column {
   uint16_t column = 0, group = 0;
   bool valid = false;
};

template <const Config& C>
void expect_codes(int bubbles_percent) {
   using Core = dynamic_range::Core<C>;
   using Targets = dynamic_range::WindowTargets<C>;
   constexpr int kLanes = C.window_disparities, kWindow = C.window_px, kAfter = (kWindow - 1) / 2;
   Random random(test_seed());
   HeapMemories memories;
   Targets targets(memories, MemoryId<0>());
   typename Core::Bases bases(memories, MemoryId<Targets::kMemories>());
   typename Core::Rows rows(memories, MemoryId<Targets::kMemories + Core::Bases::kMemories>());
   typename Core::Window::Chain chain[dynamic_range::kTracks];

   // The targets of all bands at once: the memory holds that many.
   constexpr int kBands = C.block_rows();
   static_assert(kBands <= Targets::kBands);
   std::vector<std::vector<int>> wanted[dynamic_range::kTracks];  // [band][column]
   dynamic_range::Blocks<int> goals[dynamic_range::kTracks];
   for (int track = 0; track < dynamic_range::kTracks; ++track) {
      goals[track] = dynamic_range::Blocks<int>(C.block_columns(), kBands);
      int goal = 0;
      for (int& value : goals[track].values) value = goal = random.percent(60) ? random.below(C.last_base() + 1) : goal;
      for (int band = 0; band < kBands; ++band)
         wanted[track].push_back(dynamic_range::window_bases(goals[track], 8 * band, C.width_px, C));
   }
   for (int band = 0; band < kBands; ++band)
      for (int column = 0; column < C.block_columns(); ++column) {
         targets.low = uint16_t(goals[dynamic_range::kLow].at(column, band));
         targets.high = uint16_t(goals[dynamic_range::kHigh].at(column, band));
         targets.place = uint16_t(band << Targets::kColumnBits | column);
         bases.clock(false, Column(), targets);
      }

   const uint64_t seed = test_seed();
   const auto code = [&](int x, int y) {
      return Feature<dynamic_range::kWindowConfig<C>>(
          mix_bits(seed + uint64_t(y) * 4096 + uint64_t(x)) &
          ((uint64_t(1) << dynamic_range::kWindowConfig<C>.feature_bits()) - 1));
   };
   const auto base = [&](int track, int x, int y) { return wanted[track][std::size_t(y / 8)][std::size_t(x)]; };

   std::deque<Column> places(2), standing(Core::Bases::kClocks),
       compared(Core::Bases::kClocks + Core::Rows::kClocks + 1);
   Column last;  // a bubble keeps the place of the column before it
   int checked = 0;
   const int groups = C.width_px * (C.height_px + 2);
   for (int sent = 0; sent < groups;) {
      const bool valid = !random.percent(bubbles_percent);
      FeatureGroup<dynamic_range::kWindowConfig<C>> newest;
      newest.valid = valid;
      newest.start_of_frame = sent == 0 || random.percent(valid ? 0 : 50);
      newest.search[0] = code(sent % C.width_px, sent / C.width_px);
      // The windows follow the codes.
      const int behind = sent - C.ahead_groups();
      if (valid && behind >= 0) last = {uint16_t(behind % C.width_px), uint16_t(behind / C.width_px), true};
      last.valid = valid && behind >= 0;
      sent += valid ? 1 : 0;
      places.push_back(last), standing.push_back(places.front()), compared.push_back(places.front());

      for (int track = 0; track < dynamic_range::kTracks; ++track) chain[track].clock(rows, track, compared[1].valid);
      rows.clock(newest, bases);
      bases.clock(places.front().valid, places.front(), targets);
      places.pop_front(), standing.pop_front(), compared.pop_front();

      const int x = compared.front().column - (kLanes - 1), y = compared.front().group;
      if (compared.front().valid && x >= 0 && y < C.height_px)
         for (int track = 0; track < dynamic_range::kTracks; ++track)
            for (int i = 0; i < kLanes; ++i) {
               ASSERT_EQ(chain[track].lane[dynamic_range::kEntering][i], code(x + base(track, x, y) + i, y))
                   << "track " << track << " lane " << i << " of " << x << ',' << y;
               if (y < kWindow) continue;
               const int left = y - kWindow;
               ASSERT_EQ(chain[track].lane[dynamic_range::kLeaving][i], code(x + base(track, x, left) + i, left))
                   << "track " << track << " lane " << i << " of " << x << ',' << left;
               ++checked;
            }
      const int stands_x = standing.front().column - (kLanes - 1), centre = standing.front().group - kAfter;
      if (standing.front().valid && stands_x >= 0 && centre >= 0 && centre < C.height_px) {
         for (int track = 0; track < dynamic_range::kTracks; ++track)
            ASSERT_EQ(bases.base[track][dynamic_range::kCentre], base(track, stands_x, centre))
                << stands_x << ',' << centre;
      }
   }
   EXPECT_GT(checked, C.width_px * kLanes);
}

TEST(SearchRows, GiveTheCodesOfTheDefinitionForAnyTargets) {
   for (const int bubbles_percent : {0, 40}) {
      expect_codes<kSmall>(bubbles_percent);
      expect_codes<kWide>(bubbles_percent);
   }
}

}  // namespace
}  // namespace stereo::test
