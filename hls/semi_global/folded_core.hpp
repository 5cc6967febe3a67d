// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "semi_global/column_line.hpp"
#include "semi_global/core.hpp"
#include "semi_global/phase_costs.hpp"
#include "semi_global/phase_other.hpp"
#include "semi_global/phase_paths.hpp"
#include "semi_global/phase_relief.hpp"
#include "semi_global/phase_winners.hpp"

namespace stereo::semi_global {

/// The same core with C.clocks_per_pixel clocks a pixel pair: the same map, and as before one disparity for each pair,
/// always as many clocks behind it. A pair must not come sooner than clocks_per_pixel clocks after the one before it,
/// start of frame or not.
template <const Config& C>
   requires(C.is_folded())
struct Core<C> {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = semi_global::Matching;
   static constexpr const auto& kWindows = kWindowConfig<C>;

   using Refine = Refinement<kSumConfig<C>>;
   using Check = LeftRightCheck<kSumConfig<C>, Stages<C>::kWinnerLevels + Refine::kClocks>;
   using Line = ColumnLine<C, 1 - PhaseCosts<C>::kClocks>;
   using Settings = semi_global::Settings;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size = FixedSize<kWindowConfig<C>>;

   //            a pixel pair              once in F clocks
   //                 |
   //   clocks   transform                 7, 6, none  x-Sobel, census; census 7 with two front clocks
   //            raster, delay, rows       3 or 5
   //                 |                    from here on, D/F disparities a clock, F clocks one behind the other
   //            costs                     PhaseCosts::kClocks
   //            paths                     F + log2(D/F) + 4: of all three, and their sum
   //            winners                   log2(D/F) + F
   //                 |                    from here on, once in F clocks again
   //            refinement                0, 4, 12    uniqueness, subpixel
   //            leftright                 4 or none   also from the sums, ahead of the refinement
   //            turn                      3 or none   rows turned back
   //            map                       11, 1, none median or register
   //                 |
   //            a disparity
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                                                                            \
   PORTS(settings, SettingsBlock)                                                                                      \
   PORTS(size, Size)                                                                                                   \
   BLOCK(transform, Optional<kWindows.has_transform(), Transform<kWindowConfig<C>>>)                                   \
   BLOCK(raster, Raster<kWindowConfig<C>>)                                                                             \
   BLOCK(delay, PairDelay<kWindowConfig<C>>)                                                                           \
   BLOCK(rows, std::conditional_t<kWindows.window_px == 1, SingleRow<kWindowConfig<C>>, LineBuffer<kWindowConfig<C>>>) \
   BESIDE(line, Line)                                                                                                  \
   BLOCK(costs, PhaseCosts<C>)                                                                                         \
   BLOCK(paths, PhasePaths<C>)                                                                                         \
   BLOCK(winners, PhaseWinners<C>)                                                                                     \
   BESIDE(other, Optional<C.has_left_right_check(), PhaseOther<C>>)                                                    \
   BLOCK(refinement, Refine)                                                                                           \
   BLOCK(leftright, Optional<C.has_left_right_check(), Check>)                                                         \
   BLOCK(turn, Optional<C.path_right, WinnerTurn<C>>)                                                                  \
   BLOCK(map, MapBlock<C>)                                                                                             \
   BESIDE(relief, Optional<C.has_relief(), PhaseRelief<C>>)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = [] {
      Schedule schedule = window_schedule(C, kWindows, kBlocks.all());
      schedule.clocks_per_group = C.clocks_per_pixel;
      return schedule;
   }();
   static_assert(!C.run_time_settings || kBlocks.before(map_number).clocks < C.clocks_to_last_check(),
                 "the bound in Config is too low");
   static_assert(!C.run_time_settings ||
                     window_schedule(C, kWindows, kBlocks.before(turn_number)).groups_to_first_output <=
                         C.groups_to_last_check(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group<C>(*this)); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      clock_map<C>(*this, size);
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(winners, NoTexture(), settings);
      if constexpr (C.has_left_right_check()) other.clock(paths, line, winners.mask);
      winners.clock(paths, line, settings, size);
      paths.clock(costs, line, settings, relief);
      if constexpr (C.has_relief()) follow_relief(in);
      costs.clock(rows.search, rows.reference, rows.tag, line, settings, size);
      line.clock(rows.tag, size);
      rows.clock(delay);
      delay.clock(raster, size);
      if constexpr (kWindows.has_transform()) {
         raster.clock(transform.output(), size);
         transform.clock(in, size);
      } else {
         raster.clock(grey_values<kWindowConfig<C>>(in), size);
      }
   }

   /// The same where the configuration has run-time settings. `now`: what the ports show; it counts in the clock of a
   /// start of frame.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) settings.clock(in, now);
   }

  private:
   HLS_INLINE void follow_relief(const CoreInput<C>& in) {
      relief.clock(line, rows, delay, raster, settings);
      if constexpr (kWindows.has_transform()) relief.compare(transform);
      else relief.compare(in);
   }

   HLS_INLINE void check() {
      const uint8_t other_winner[1] = {other.leaving()};
      leftright.clock(refinement.output(winners, NoTexture()), other_winner, settings);
   }
};

}  // namespace stereo::semi_global
