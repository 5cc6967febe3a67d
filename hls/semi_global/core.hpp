// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/single_row.hpp"
#include "frontend/transform.hpp"
#include "semi_global/config.hpp"
#include "semi_global/cost_slice.hpp"
#include "semi_global/forward_paths.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/path_sums.hpp"
#include "semi_global/path_winners.hpp"
#include "semi_global/settings.hpp"
#include "semi_global/winner_turn.hpp"
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

   using TransformBlock = Optional<kWindows.has_transform(), Transform<kWindowConfig<C>>>;
   using Rows = std::conditional_t<kWindows.window_px == 1, SingleRow<kWindowConfig<C>>, LineBuffer<kWindowConfig<C>>>;
   using Slices = CostSlice<C>;
   using Forward = ForwardPaths<C>;
   using Sums = PathSums<C>;
   using Refine = Refinement<kSumConfig<C>>;
   using CheckBlock =
       Optional<C.has_left_right_check(), LeftRightCheck<kSumConfig<C>, PathWinners<C>::kLevels + Refine::kClocks>>;
   using TurnBlock = Optional<C.path_right, WinnerTurn<C>>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock =
       std::conditional_t<C.median, Median<kSumConfig<C>>, Optional<C.subpixel, MapRegister<kSumConfig<C>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel;
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
   //            left_right                4 or none   also from the winners, ahead of the refinement
   //            turn                      3 or none   rows turned back
   //            map_block                 11, 1, none median or register
   //                 |
   //            a disparity
   static constexpr int kLatency = TransformBlock::kClocks + Raster<kWindowConfig<C>>::kClocks +
                                   PairDelay<kWindowConfig<C>>::kClocks + Rows::kClocks + Slices::kClocks +
                                   PathEntry<C>::kClocks + Sums::kClocks + PathWinners<C>::kClocks + Refine::kClocks +
                                   CheckBlock::kClocks + TurnBlock::kClocks + MapBlock::kClocks;
   /// Valid groups that the blocks hold back, up to a row's first window centre and the columns after it.
   static constexpr int kGroupsToFirstOutput =
       TransformBlock::kLagGroups + Rows::kLagGroups + kWindows.first_map_column() + kWindows.columns_after() +
       Sums::kLagGroups + CheckBlock::kLagGroups + TurnBlock::kLagGroups + MapBlock::kLagGroups + 1;
   static constexpr Schedule kSchedule =
       raster_schedule(C, C.output_width_px(), kLatency, kGroupsToFirstOutput, kWindows.gap_groups());

   static_assert(!C.run_time_settings || kLatency < C.clocks_to_last_check(), "the bound in Config is too low");
   static_assert(!C.run_time_settings ||
                     kGroupsToFirstOutput - TurnBlock::kLagGroups - MapBlock::kLagGroups <= C.groups_to_last_check(),
                 "the bound in Config is too low");

   [[no_unique_address]] SettingsBlock settings;
   [[no_unique_address]] Size size;
   TransformBlock transform;
   Raster<kWindowConfig<C>> raster;
   PairDelay<kWindowConfig<C>> delay;
   Rows rows;
   Slices slices;
   PathEntry<C> entry;
   Forward forward;
   Sums sums;
   PathWinners<C> winners;
   Refine refinement;
   CheckBlock left_right;
   TurnBlock turn;
   MapBlock map_block;

   static constexpr int kDelayMemory = TransformBlock::kMemories;
   static constexpr int kRowsMemory = kDelayMemory + PairDelay<kWindowConfig<C>>::kMemories;
   static constexpr int kSlicesMemory = kRowsMemory + Rows::kMemories;
   static constexpr int kForwardMemory = kSlicesMemory + Slices::kMemories;
   static constexpr int kSumsMemory = kForwardMemory + Forward::kMemories;
   static constexpr int kCheckMemory = kSumsMemory + Sums::kMemories;
   static constexpr int kTurnMemory = kCheckMemory + CheckBlock::kMemories;
   static constexpr int kMapMemory = kTurnMemory + TurnBlock::kMemories;

   template <class Source>
   HLS_INLINE explicit Core(Source& memories)
       : transform(memories, MemoryId<0>()),
         delay(memories, MemoryId<kDelayMemory>()),
         rows(memories, MemoryId<kRowsMemory>()),
         slices(memories, MemoryId<kSlicesMemory>()),
         forward(memories, MemoryId<kForwardMemory>()),
         sums(memories, MemoryId<kSumsMemory>()),
         left_right(memories, MemoryId<kCheckMemory>()),
         turn(memories, MemoryId<kTurnMemory>()),
         map_block(memories, MemoryId<kMapMemory>()) {}

   /// In data-flow order. Registers of slice number s begin with "slice<s>".
   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      if constexpr (C.run_time_settings) visit.block("settings", settings);
      if constexpr (C.run_time_size) visit.block("size", size);
      visit.block("transform", transform);
      visit.block("raster", raster);
      visit.block("delay", delay);
      visit.block("rows", rows);
      slices.slices(visit);
      visit.block("entry", entry);
      visit.block("forward", forward);
      visit.block("sums", sums);
      visit.block("winners", winners);
      visit.block("refinement", refinement);
      visit.block("leftright", left_right);
      visit.block("turn", turn);
      visit.block("map", map_block);
   }

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const { return shown(map()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.median) map_block.clock(turned(), size);
      else if constexpr (kHasMapBlock) map_block.clock(turned());
      if constexpr (C.path_right) turn.clock(checked(), size);
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(winners, NoTexture(), settings);
      winners.clock(sums);
      sums.clock(entry, forward, settings);
      winners.follow(sums.tag, settings, size);
      forward.clock(entry, settings);
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
      left_right.clock(refinement.output(winners, NoTexture()), other_winner, settings);
   }

   HLS_INLINE Winners<kSumConfig<C>> checked() const {
      if constexpr (C.has_left_right_check()) return left_right.checked;
      else return refinement.output(winners, NoTexture());
   }

   /// In raster order.
   HLS_INLINE Winners<kSumConfig<C>> turned() const {
      if constexpr (C.path_right) return turn.output();
      else return checked();
   }

   HLS_INLINE MapGroup<kSumConfig<C>> map() const {
      if constexpr (kHasMapBlock) return map_block.out;
      else return map_group<kSumConfig<C>>(turned());
   }
};

}  // namespace stereo::semi_global
