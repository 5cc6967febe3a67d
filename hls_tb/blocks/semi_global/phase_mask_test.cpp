// SPDX-License-Identifier: Apache-2.0
#include "semi_global/phase_mask.hpp"

#include <gtest/gtest.h>

#include "semi_global/settings.hpp"
#include "testing/phase_stream.hpp"
#include "testing/seed.hpp"

namespace stereo::test {
namespace {

using SgmConfig = semi_global::Config;

constexpr SgmConfig config(int disparities, int clocks, int min_disparity, Reference side, FullWidth searched,
                           bool run_time_settings = false) {
   return {{.width_px = 40, .height_px = 20},
           {DisparityCount{disparities}, MatchingWindow{2}, SmallestDisparity{min_disparity}, ReferenceImage{side},
            searched},
           {Folding{clocks}, RunTime{.run_time_settings = run_time_settings}}};
}
constexpr FullWidth kAll{.full_width = true}, kPart{.full_width = true, .first_disparity = 3, .last_disparity = 9};
constexpr SgmConfig kRight = config(12, 4, 0, Reference::right, kAll), kLeft = config(15, 5, 0, Reference::left, kAll),
                    kRightFar = config(16, 8, -9, Reference::right, kPart),
                    kLeftFar = config(12, 6, 4, Reference::left, kPart),
                    kRightPorts = config(12, 4, 2, Reference::right, kAll, true),
                    kLeftPorts = config(12, 4, -3, Reference::left, kPart, true);

/// docs/algorithm.md, 8.
template <const SgmConfig& C>
bool leads_into_map(int x, int d) {
   const int other = C.reference == Reference::right ? x + C.min_disparity + d : x - C.min_disparity - d;
   return other >= 0 && other < C.output_width_px();
}

/// Rows of two frames; with run-time settings each has others.
template <const SgmConfig& C, bool Turned, int Stage>
void expect_candidates(int bubbles_percent) {
   using At = semi_global::Stages<C>;
   constexpr int kWidth = C.output_width_px(), kStride = kWidth + 5, kRows = 4, kFrame = kRows * kStride;
   constexpr int kColumns = 2 * kFrame;
   constexpr bool kIsRight = C.reference == Reference::right;
   Random random(test_seed());
   semi_global::PhaseMask<C, Turned, Stage> mask;
   semi_global::Settings settings[2];
   for (semi_global::Settings& frame : settings) {
      frame.first_disparity = uint8_t(C.first_disparity);
      frame.last_disparity = uint8_t(C.last_disparity < 0 ? C.disparities - 1 : C.last_disparity);
      if constexpr (C.run_time_settings) {
         frame.first_disparity = uint8_t(random.below(C.disparities / 2));
         frame.last_disparity = uint8_t(frame.first_disparity + random.below(C.disparities / 2));
      }
   }
   PhaseStream<C> stream(random, bubbles_percent);
   int compared = 0, candidates = 0;
   for (int rest = 200; rest > 0;) {
      const auto shown = stream.centre_at(Stage);
      const int k = shown.column % kStride;
      // A turned row comes out beside the one behind it.
      const int row = shown.column / kStride - (Turned ? 1 : 0);
      if (shown.column >= 0 && k < kWidth && row >= 0)
         for (int l = 0; l < At::kLanes; ++l) {
            const int x = Turned ? kWidth - 1 - k : k, lane = shown.phase * At::kLanes + l;
            const int d = kIsRight ? C.disparities - 1 - lane : lane;
            const semi_global::Settings& now = settings[row / kRows];
            const bool searched = d >= now.first_disparity && d <= now.last_disparity;
            ASSERT_EQ(mask.is_searched(l), searched) << "row " << row << " d=" << d;
            ASSERT_EQ(mask.has_candidate(l), searched && leads_into_map<C>(x, d))
                << "row " << row << " x=" << x << " d=" << d;
            ++compared;
            candidates += mask.has_candidate(l);
         }
      // What the frame that arrives here has.
      const int arriving = stream.centre_at(Stage - 2).column / kStride - (Turned ? 1 : 0);
      mask.clock(stream.line, settings[arriving >= kRows ? 1 : 0], FixedSize<semi_global::kWindowConfig<C>>());
      PixelTag tag;
      const int x = stream.sent() % kStride;
      tag.valid = stream.sent() < kColumns;
      tag.map_column = tag.output_column = x < kWidth;
      tag.first_column = x == 0;
      tag.start_of_frame = stream.sent() % kFrame == 0;
      tag.end_of_line = x == kWidth - 1;
      stream.clock(tag);
      if (!tag.valid) --rest;
   }
   EXPECT_EQ(compared, (2 * kRows - (Turned ? 1 : 0)) * kWidth * C.disparities);
   EXPECT_GT(candidates, 0);
   EXPECT_LT(candidates, compared);
}

template <const SgmConfig& C>
void expect_both_ways() {
   for (const int bubbles : {0, 10, 70}) {
      expect_candidates<C, true, semi_global::Stages<C>::kSums>(bubbles);
      expect_candidates<C, false, semi_global::Stages<C>::kCosts>(bubbles);
   }
}

TEST(PhaseMask, IsThatOfTheDefinition) {
   expect_both_ways<kRight>();
   expect_both_ways<kLeft>();
   expect_both_ways<kRightFar>();
   expect_both_ways<kLeftFar>();
   expect_both_ways<kRightPorts>();
   expect_both_ways<kLeftPorts>();
}

}  // namespace
}  // namespace stereo::test
