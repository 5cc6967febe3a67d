// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "frontend/single_row.hpp"
#include "frontend/transform.hpp"
#include "semi_global/cost_slice.hpp"
#include "semi_global/path_entry.hpp"
#include "semi_global/winner_turn.hpp"
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

   using TransformBlock = Optional<kWindows.has_transform(), Transform<kWindowConfig<kCosts>>>;
   using Rows =
       std::conditional_t<kWindows.window_px == 1, SingleRow<kWindowConfig<kCosts>>, LineBuffer<kWindowConfig<kCosts>>>;
   using Slices = semi_global::CostSlice<kCosts>;
   using Entry = semi_global::PathEntry<kCosts>;
   using Turn = semi_global::WinnerTurn<kCosts>;
   using MapBlock = Optional<C.median, Median<semi_global::kSumConfig<kCosts>>>;
   static constexpr bool kTurnsRows = true;
   using Settings = std::conditional_t<C.run_time_size, SizedSettings<trellis::Settings>, trellis::Settings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<C>, NoSettings>;
   using Size =
       std::conditional_t<C.run_time_size, RunTimeSize<kWindowConfig<kCosts>>, FixedSize<kWindowConfig<kCosts>>>;

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
   //            map_block                 7 or none   median
   //                 |
   //            a disparity
   static constexpr int kClocksToForward = TransformBlock::kClocks + Raster<kWindowConfig<kCosts>>::kClocks +
                                           PairDelay<kWindowConfig<kCosts>>::kClocks + Rows::kClocks + Slices::kClocks +
                                           Entry::kClocks;
   static constexpr int kLatency =
       kClocksToForward + Traceback<C>::kClocks + Turn::kClocks + OcclusionFill<C>::kClocks + MapBlock::kClocks;
   /// Valid groups that the blocks hold back, up to a row's first window centre and the columns after it.
   static constexpr int kGroupsToFirstOutput = TransformBlock::kLagGroups + Rows::kLagGroups +
                                               kWindows.first_map_column() + kWindows.columns_after() +
                                               Traceback<C>::kLagGroups + Turn::kLagGroups + MapBlock::kLagGroups + 1;
   static constexpr Schedule kSchedule =
       raster_schedule(C, C.output_width_px(), kLatency, kGroupsToFirstOutput, kWindows.gap_groups());

   static_assert(!C.run_time_settings || kClocksToForward < C.clocks_to_forward(), "the bound in Config is too low");

   [[no_unique_address]] SettingsBlock settings;
   [[no_unique_address]] Size size;
   TransformBlock transform;
   Raster<kWindowConfig<kCosts>> raster;
   PairDelay<kWindowConfig<kCosts>> delay;
   Rows rows;
   Slices slices;
   Entry entry;
   Forward<C> forward;
   DecisionTurn<C> decisions;
   LastState<C> last;
   Traceback<C> traceback;
   Turn turn;
   OcclusionFill<C> fill;
   MapBlock map_block;

   static constexpr int kDelayMemory = TransformBlock::kMemories;
   static constexpr int kRowsMemory = kDelayMemory + PairDelay<kWindowConfig<kCosts>>::kMemories;
   static constexpr int kSlicesMemory = kRowsMemory + Rows::kMemories;
   static constexpr int kDecisionsMemory = kSlicesMemory + Slices::kMemories;
   static constexpr int kTurnMemory = kDecisionsMemory + DecisionTurn<C>::kMemories;
   static constexpr int kMapMemory = kTurnMemory + Turn::kMemories;

   template <class Source>
   HLS_INLINE explicit Core(Source& memories)
       : transform(memories, MemoryId<0>()),
         delay(memories, MemoryId<kDelayMemory>()),
         rows(memories, MemoryId<kRowsMemory>()),
         slices(memories, MemoryId<kSlicesMemory>()),
         decisions(memories, MemoryId<kDecisionsMemory>()),
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
      visit.block("decisions", decisions);
      visit.block("last", last);
      visit.block("traceback", traceback);
      visit.block("turn", turn);
      visit.block("fill", fill);
      visit.block("map", map_block);
   }

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const { return shown(map()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.median) map_block.clock(fill.out, size);
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
   HLS_INLINE MapGroup<semi_global::kSumConfig<kCosts>> map() const {
      if constexpr (C.median) return map_block.out;
      else return map_group<semi_global::kSumConfig<kCosts>>(fill.out);
   }
};

}  // namespace stereo::trellis
