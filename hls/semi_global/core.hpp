// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/single_row.hpp"
#include "frontend/transform.hpp"
#include "postprocessing/post_processor.hpp"
#include "semi_global/config.hpp"
#include "semi_global/cost_slice.hpp"
#include "semi_global/forward_paths.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/path_sums.hpp"
#include "semi_global/path_winners.hpp"
#include "semi_global/relief.hpp"
#include "semi_global/settings.hpp"
#include "semi_global/winner_turn.hpp"
#include "support/blocks.hpp"
#include "support/optional_block.hpp"
#include "support/schedule.hpp"
#include "winner/left_right_check.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/refinement.hpp"

namespace stereo::semi_global {

/// The semi-global core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H records a frame, any number of bubbles between them. Output: map width * H records. With a path from the
/// right a row leaves while the second row behind it comes in; after the last row of a frame come the first rows of the
/// next one, or kSchedule.flush_groups pairs of any valid pixels without start of frame. There is no back-pressure: a
/// record a clock is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = semi_global::Matching;
   static constexpr const auto& kWindows = kWindowConfig<C>;

   using Refine = Refinement<kSumConfig<C>>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock = std::conditional_t<
       C.has_post_processing(), PostProcessor<C>,
       std::conditional_t<C.median, Median<kSumConfig<C>>, Optional<C.subpixel, MapRegister<kSumConfig<C>>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel || C.has_post_processing();
   static constexpr bool kTurnsRows = C.path_right;
   using Settings = std::conditional_t<C.run_time_size, SizedSettings<semi_global::Settings>, semi_global::Settings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size = std::conditional_t<C.run_time_size, RunTimeSize<kWindowConfig<C>>, FixedSize<kWindowConfig<C>>>;

   //            a pixel pair
   //                 |
   //   clocks   transform                 7, 6, none  x-Sobel, census
   //            raster                    1           place in the frame
   //            delay                     1           the reference meets what it is compared with
   //            rows                      3 or 1      columns of all rows of the windows, if these have more than one
   //            slices                    Slices::kClocks: window costs, scaled, of all disparities at once
   //            entry                     2           addresses of the rows that are kept
   //                 |                    from here on, moves with valid columns only
   //            forward                   paths from the left and from above
   //            sums                      rows turned round, path from the right
   //                 |                    from here on, clocks again
   //            winners                   PathWinners::kClocks
   //            refinement                0, 4, 12    uniqueness, subpixel
   //            leftright                 4 or none   also from the winners, ahead of the refinement
   //            turn                      3 or none   rows turned back
   //            map                       11, 1, none median or register; or PostProcessor::kClocks
   //                 |
   //            a disparity
#define STEREO_BLOCKS(BLOCK, BESIDE, PORTS)                                                                            \
   PORTS(settings, SettingsBlock)                                                                                      \
   PORTS(size, Size)                                                                                                   \
   BLOCK(transform, Optional<kWindows.has_transform(), Transform<kWindowConfig<C>>>)                                   \
   BLOCK(raster, Raster<kWindowConfig<C>>)                                                                             \
   BLOCK(delay, PairDelay<kWindowConfig<C>>)                                                                           \
   BLOCK(rows, std::conditional_t<kWindows.window_px == 1, SingleRow<kWindowConfig<C>>, LineBuffer<kWindowConfig<C>>>) \
   BLOCK(slices, CostSlice<C>)                                                                                         \
   BLOCK(entry, PathEntry<C>)                                                                                          \
   BLOCK(forward, ForwardPaths<C>)                                                                                     \
   BLOCK(sums, PathSums<C>)                                                                                            \
   BLOCK(winners, PathWinners<C>)                                                                                      \
   BLOCK(refinement, Refine)                                                                                           \
   BLOCK(leftright,                                                                                                    \
         Optional<C.has_left_right_check(), LeftRightCheck<kSumConfig<C>, PathWinners<C>::kLevels + Refine::kClocks>>) \
   BLOCK(turn, Optional<C.path_right, WinnerTurn<C>>)                                                                  \
   BLOCK(map, MapBlock)                                                                                                \
   BESIDE(relief, Optional<C.has_relief(), ReliefStream<C>>)
   STEREO_CORE(STEREO_BLOCKS);
#undef STEREO_BLOCKS

   static constexpr Schedule kSchedule = window_schedule(C, kWindows, kBlocks.all());
   static_assert(!C.run_time_settings || kBlocks.before(map_number).clocks < C.clocks_to_last_check(),
                 "the bound in Config is too low");
   static_assert(!C.run_time_settings ||
                     window_schedule(C, kWindows, kBlocks.before(turn_number)).groups_to_first_output <=
                         C.groups_to_last_check(),
                 "the bound in Config is too low");

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE auto output() const { return shown(shown_group()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.median || C.has_post_processing()) map.clock(turned(), size);
      else if constexpr (kHasMapBlock) map.clock(turned());
      if constexpr (C.path_right) turn.clock(checked(), size);
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(winners, NoTexture(), settings);
      winners.clock(sums);
      sums.clock(entry, forward, settings);
      winners.follow(sums.tag, settings, size);
      if constexpr (C.has_relief()) {
         forward.clock(entry, settings, relief.entered);
         relief.clock(slices.shown_tag(), rows, delay, raster, settings);
         if constexpr (kWindows.has_transform()) relief.compare(transform);
         else relief.compare(in);
      } else {
         forward.clock(entry, settings);
      }
      entry.clock(slices, size);
      slices.clock(rows.search, rows.reference, rows.tag, settings, size);
      rows.clock(delay);
      delay.clock(raster, size);
      if constexpr (kWindows.has_transform()) {
         raster.clock(transform.output(), size);
         transform.clock(in, size);
      } else {
         raster.clock(grey_values<kWindowConfig<C>>(in), size);
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
   struct NoTexture {};

   HLS_INLINE void check() {
      uint8_t other_winner[1] = {winners.other.winner[0][PathWinners<C>::Other::kOldest]};
      leftright.clock(refinement.output(winners, NoTexture()), other_winner, settings);
   }

   HLS_INLINE Winners<kSumConfig<C>> checked() const {
      if constexpr (C.has_left_right_check()) return leftright.checked;
      else return refinement.output(winners, NoTexture());
   }

   /// In raster order.
   HLS_INLINE Winners<kSumConfig<C>> turned() const {
      if constexpr (C.path_right) return turn.output();
      else return checked();
   }

   HLS_INLINE auto shown_group() const {
      if constexpr (C.has_post_processing()) return map.group();
      else if constexpr (kHasMapBlock) return map.out;
      else return map_group<kSumConfig<C>>(turned());
   }
};

}  // namespace stereo::semi_global
