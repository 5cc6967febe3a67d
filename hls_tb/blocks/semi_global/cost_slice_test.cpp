// SPDX-License-Identifier: Apache-2.0
#include "semi_global/cost_slice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "engines/clocked/heap_memories.hpp"
#include "scene/random.hpp"
#include "testing/seed.hpp"
#include "testing/tags.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(Reference reference, int disparities, int slice, int window, int shift, int cap) {
   return {{.width_px = 40, .height_px = 12},
           {DisparityCount{disparities}, MatchingWindow{window}, ReferenceImage{reference}, Comparison{Cost::sad},
            CostScale{.cost_shift = shift, .cost_cap = cap}},
           {SliceSize{slice}}};
}

// One slice, whole ones, a rest, a rest of one.
constexpr SgmConfig kOne = config(Reference::right, 12, 25, 3, 4, 15),
                    kWhole = config(Reference::left, 12, 4, 2, 3, 31);
constexpr SgmConfig kRest = config(Reference::right, 14, 4, 3, 0, 4095),
                    kSingle = config(Reference::left, 13, 4, 3, 5, 9);

struct Column {
   std::vector<int> search, reference;
   PixelTag tag;
};

/// What the paths see when the column n has come, for every disparity: with a right reference the searched pixel of d
/// is D-1-d columns older than the reference, with a left one d columns.
template <const SgmConfig& C>
std::vector<int> costs(const std::vector<Column>& columns) {
   std::vector<int> all;
   for (int d = 0; d < C.disparities; ++d) {
      int sum = 0;
      for (std::size_t n = columns.size() - C.window_px; n < columns.size(); ++n) {
         if (columns[n].tag.border_column) continue;
         const Column& other = columns[n - std::size_t(C.reference == Reference::right ? C.disparities - 1 - d : d)];
         for (std::size_t t = 0; t < C.window_px; ++t) sum += std::abs(columns[n].reference[t] - other.search[t]);
      }
      all.push_back(std::min(sum >> C.cost_shift, C.cost_cap));
   }
   return all;
}

template <const SgmConfig& C>
void expect_costs() {
   using Slices = semi_global::CostSlice<C>;
   constexpr int kTaps = Slices::kTaps;
   constexpr int kAfter = C.reference == Reference::right ? (C.window_px - 1) / 2 : C.window_px / 2;
   Random random(test_seed());
   HeapMemories memories;
   Slices slices(memories, MemoryId<0>());
   const Column nothing{std::vector<int>(kTaps, 0), std::vector<int>(kTaps, 0), {}};
   std::vector<Column> columns(C.disparities + C.window_px, nothing);  // reset: zeros came before
   struct Expected {
      PixelTag tag;
      std::vector<int> costs;
   };
   std::deque<Expected> pipeline(Slices::kClocks - 1);
   for (int clock = 0; clock < 600; ++clock) {
      Column in = nothing;
      in.tag = random_tag(random);
      in.tag.border_column = random.percent(10);
      Feature<semi_global::kWindowConfig<C>> search[kTaps], reference[kTaps];
      const int levels = clock % 100 < 30 ? 2 : 256;
      for (std::size_t t = 0; t < kTaps; ++t) {
         in.search[t] = search[t] = uint8_t(random.below(levels) * (levels == 2 ? 255 : 1));
         in.reference[t] = reference[t] = uint8_t(random.below(levels) * (levels == 2 ? 255 : 1));
      }
      Expected wanted;
      if (in.tag.valid) {
         columns.push_back(in);
         wanted.tag = columns[columns.size() - 1 - kAfter].tag;
         wanted.tag.valid = true;
         wanted.costs = costs<C>(columns);
      }
      pipeline.push_back(wanted);
      slices.clock(search, reference, in.tag);
      const Expected now = pipeline.front();
      pipeline.pop_front();
      ASSERT_EQ(slices.shown_tag().valid, now.tag.valid) << "clock " << clock;
      if (!now.tag.valid) continue;
      ASSERT_PRED2(same_centre, now.tag, slices.shown_tag()) << "clock " << clock;
      semi_global::PathCost<C> got[C.disparities];
      slices.put(got);
      for (int d = 0; d < C.disparities; ++d)
         ASSERT_EQ(got[d], now.costs[std::size_t(d)]) << "clock " << clock << " d=" << d;
   }
}

TEST(CostSlice, GivesAllCostsOfAColumnAtOnce) {
   expect_costs<kOne>();
   expect_costs<kWhole>();
   expect_costs<kRest>();
   expect_costs<kSingle>();
}

}  // namespace
}  // namespace stereo::test
