// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/single_row.hpp"
#include "frontend/transform.hpp"
#include "postprocessing/post_processor.hpp"
#include "semi_global/cost_slice.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/winner_turn.hpp"
#include "support/blocks.hpp"
#include "support/optional_block.hpp"
#include "support/schedule.hpp"
#include "trellis/config.hpp"
#include "trellis/decision_turn.hpp"
#include "trellis/forward.hpp"
#include "trellis/last_state.hpp"
#include "trellis/occlusion_fill.hpp"
#include "trellis/settings.hpp"
#include "trellis/traceback.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"

namespace stereo::trellis {

/// The trellis core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H records a frame, any number of bubbles between them. Output: map width * H records, two rows later. After
/// the last row of a frame come the first rows of the next one, or kSchedule.flush_groups pairs of any valid pixels
/// without start of frame. There is no back-pressure: a record a clock is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = trellis::Matching;
   static constexpr const auto& kCosts = kCostConfig<C>;
   static constexpr const auto& kWindows = kWindowConfig<kCosts>;

   static constexpr bool kTurnsRows = true;
   using Settings = std::conditional_t<C.run_time_size, SizedSettings<trellis::Settings>, trellis::Settings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size =
       std::conditional_t<C.run_time_size, RunTimeSize<kWindowConfig<kCosts>>, FixedSize<kWindowConfig<kCosts>>>;

   /// What makes the map of the traced paths.
   using MapBlock = std::conditional_t<C.has_post_processing(), PostProcessor<kMapConfig<C>>,
                                       Optional<C.median, Median<semi_global::kSumConfig<kCosts>>>>;

   //            a pixel pair
   //                 |
   //   clocks   transform                 6 or none   x-Sobel or census
   //            raster                    1           place in the frame
   //            delay                     1           the reference meets what it is compared with
   //            rows                      3 or 1      columns of all rows of the windows, if these have more than one
   //            slices                    Slices::kClocks: window costs, scaled, of all disparities at once
   //            entry                     2           addresses of the rows that are kept
   //                 |                    from here on, moves with valid columns only
   //            forward                   path costs and decisions
   //            decisions                 a row of them, turned round     last   where the row ends
   //            traceback                 from the last column to the first
   //                 |                    from here on, clocks again
   //            turn                      3           rows turned back
   //            fill                      1           occluded pixels
   //            map                       11 or none  median; or PostProcessor::kClocks
   //                 |
   //            a disparity
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                                                  \
   PORTS(settings, SettingsBlock)                                                            \
   PORTS(size, Size)                                                                         \
   BLOCK(transform, Optional<kWindows.has_transform(), Transform<kWindowConfig<kCosts>>>)    \
   BLOCK(raster, Raster<kWindowConfig<kCosts>>)                                              \
   BLOCK(delay, PairDelay<kWindowConfig<kCosts>>)                                            \
   BLOCK(rows, std::conditional_t<kWindows.window_px == 1, SingleRow<kWindowConfig<kCosts>>, \
                                  LineBuffer<kWindowConfig<kCosts>>>)                        \
   BLOCK(slices, semi_global::CostSlice<kCosts>)                                             \
   BLOCK(entry, semi_global::PathEntry<kCosts>)                                              \
   BLOCK(forward, Forward<C>)                                                                \
   BESIDE(decisions, DecisionTurn<C>)                                                        \
   BESIDE(last, LastState<C>)                                                                \
   BLOCK(traceback, Traceback<C>)                                                            \
   BLOCK(turn, semi_global::WinnerTurn<kCosts>)                                              \
   BLOCK(fill, OcclusionFill<C>)                                                             \
   BLOCK(map, MapBlock)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = window_schedule(C, kWindows, kBlocks.all());
   static_assert(!C.run_time_settings || kBlocks.before(forward_number).clocks < C.clocks_to_forward(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.has_post_processing()) map.clock(fill.out, size, settings);
      else if constexpr (C.median) map.clock(fill.out, size);
      fill.clock(turn.output());
      turn.clock(traceback.out, size);
      traceback.clock(entry, decisions, last);
      last.clock(entry, forward);
      decisions.clock(entry, forward);
      forward.clock(entry, settings);
      entry.clock(slices, size);
      slices.clock(rows.search, rows.reference, rows.tag, NoSettings(), size);
      rows.clock(delay);
      delay.clock(raster, size);
      if constexpr (kWindows.has_transform()) {
         raster.clock(transform.output(), size);
         transform.clock(in, size);
      } else {
         raster.clock(grey_values<kWindowConfig<kCosts>>(in), size);
      }
   }

   /// The same where the configuration has run-time settings or a run-time size. `now`: what the ports show. Settings
   /// count in the clock of a start of frame; the size is that of all frames from one reset to the next.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) settings.clock(in, now);
      if constexpr (C.run_time_size) size.clock(now.image_width, now.image_height);
   }

  private:
   HLS_INLINE auto shown_group() const {
      if constexpr (C.has_post_processing()) return map.group();
      else if constexpr (C.median) return map.out;
      else return map_group<semi_global::kSumConfig<kCosts>>(fill.out);
   }
};

}  // namespace stereo::trellis
