// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "block_matching/disparity_slice.hpp"
#include "frontend/image_size.hpp"
#include "frontend/line_buffer.hpp"
#include "frontend/pair_delay.hpp"
#include "frontend/raster.hpp"
#include "phase_correlation/config.hpp"
#include "phase_correlation/phase_distance.hpp"
#include "phase_correlation/phase_transform.hpp"
#include "support/optional_block.hpp"
#include "support/pixel_bits.hpp"
#include "support/schedule.hpp"
#include "support/settings.hpp"
#include "winner/left_right_check.hpp"
#include "winner/map_group.hpp"
#include "winner/median.hpp"
#include "winner/refinement.hpp"

namespace stereo::phase_correlation {

/// Thresholds of the checks, and what is searched, as those of block matching.
#define STEREO_SETTINGS_phase_correlation(PORT) \
   PORT(uint8_t, uniqueness_percent)            \
   PORT(uint8_t, left_right_threshold)          \
   PORT(uint8_t, first_disparity)               \
   PORT(uint8_t, last_disparity)

/// What the ports bring. A frame is matched with those of its start of frame.
STEREO_SETTINGS_STRUCT(Settings, STEREO_SETTINGS_phase_correlation);

/// The phase-correlation core: one call of `clock` is one clock of the hardware. docs/algorithm.md defines the result.
///
/// Input: W*H records a frame, any number of bubbles between them. Output: map width * H records. A row leaves while
/// the rows below it come in; after the last row of a frame come the first rows of the next one, or
/// kSchedule.flush_groups pairs of any valid pixels without start of frame. There is no back-pressure: a record a clock
/// is always taken.
template <const Config& C>
struct Core {
   static_assert(kCanBeBuilt<C>);
   static constexpr const Config& kConfig = C;
   using Matching = phase_correlation::Matching;
   static constexpr const auto& kCodes = kCodeConfig<C>;

   using TransformBlock = PhaseTransform<kCodeConfig<C>>;
   using Slices = block_matching::DisparitySlice<kCodeConfig<C>>;
   /// Phase codes have no texture to check.
   using TextureBlock = Absent;
   using Refine = Refinement<kCodeConfig<C>>;
   using CheckBlock =
       Optional<C.has_left_right_check(), LeftRightCheck<kCodeConfig<C>, Slices::kLevels + Refine::kClocks>>;
   /// What makes the map of the winners. Whole disparities without a median are ready as they are.
   using MapBlock =
       std::conditional_t<C.median, Median<kCodeConfig<C>>, Optional<C.subpixel, MapRegister<kCodeConfig<C>>>>;
   static constexpr bool kHasMapBlock = C.median || C.subpixel;
   using Settings =
       std::conditional_t<C.run_time_size, SizedSettings<phase_correlation::Settings>, phase_correlation::Settings>;
   using SettingsBlock = std::conditional_t<C.run_time_settings, FrameSettings<kCodeConfig<C>>, NoSettings>;
   using Size = std::conditional_t<C.run_time_size, RunTimeSize<kCodeConfig<C>>, FixedSize<kCodeConfig<C>>>;

   //            a pixel pair
   //                 |
   //   clocks   transform                 PhaseTransform::kClocks: phase codes
   //            raster                    1           place in the frame
   //            delay                     1           the reference meets what it is compared with
   //            rows                      3           columns of all rows of the windows
   //            slices                    Slices::kClocks: phase differences, local weighting, peak
   //            refinement                0, 4, 12    uniqueness, subpixel
   //            left_right                4 or none   also from the slices, ahead of the refinement
   //            map_block                 11, 1, none median or register
   //                 |
   //            a disparity
   static constexpr int kLatency = TransformBlock::kClocks + Raster<kCodeConfig<C>>::kClocks +
                                   PairDelay<kCodeConfig<C>>::kClocks + LineBuffer<kCodeConfig<C>>::kClocks +
                                   Slices::kClocks + Refine::kClocks + CheckBlock::kClocks + MapBlock::kClocks;
   /// Valid groups that the blocks hold back, up to a row's first window centre and the columns after it.
   static constexpr int kGroupsToFirstOutput = TransformBlock::kLagGroups + LineBuffer<kCodeConfig<C>>::kLagGroups +
                                               kCodes.first_map_column() + kCodes.columns_after() +
                                               CheckBlock::kLagGroups + MapBlock::kLagGroups + 1;
   static constexpr Schedule kSchedule =
       raster_schedule(C, C.output_width_px(), kLatency, kGroupsToFirstOutput, kCodes.gap_groups());

   static_assert(!C.run_time_settings || kLatency < kCodes.clocks_to_last_check(), "the bound in Config is too low");

   // The first memory number of each block.
   static constexpr int kDelayMemory = TransformBlock::kMemories;
   static constexpr int kRowsMemory = kDelayMemory + PairDelay<kCodeConfig<C>>::kMemories;
   static constexpr int kSlicesMemory = kRowsMemory + LineBuffer<kCodeConfig<C>>::kMemories;
   static constexpr int kCheckMemory = kSlicesMemory + Slices::kMemories;
   static constexpr int kMapMemory = kCheckMemory + CheckBlock::kMemories;

   [[no_unique_address]] SettingsBlock settings;
   [[no_unique_address]] Size size;
   TransformBlock transform;
   Raster<kCodeConfig<C>> raster;
   PairDelay<kCodeConfig<C>> delay;
   LineBuffer<kCodeConfig<C>> rows;
   Slices slices;
   TextureBlock texture;
   Refine refinement;
   CheckBlock left_right;
   MapBlock map_block;

   /// `memories`: see MemoryBank.
   template <class Source>
   HLS_INLINE explicit Core(Source& memories)
       : transform(memories, MemoryId<0>()),
         delay(memories, MemoryId<kDelayMemory>()),
         rows(memories, MemoryId<kRowsMemory>()),
         slices(memories, MemoryId<kSlicesMemory>()),
         texture(memories, MemoryId<0>()),
         left_right(memories, MemoryId<kCheckMemory>()),
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
      visit.block("refinement", refinement);
      visit.block("leftright", left_right);
      visit.block("map", map_block);
   }

   /// What the registers show in this clock. Does not depend on this clock's input.
   HLS_INLINE StereoOutput output() const { return shown(map()); }

   /// The clock edge. Last block first: each reads what the block before it held until now.
   HLS_INLINE void clock(const CoreInput<C>& in) {
      if constexpr (C.median) map_block.clock(checked(), size);
      else if constexpr (kHasMapBlock) map_block.clock(checked());
      if constexpr (C.has_left_right_check()) check();
      refinement.clock(slices.last(), texture, settings);
      slices.clock(rows.search, rows.reference, rows.tag, block_matching::NoRival<kCodeConfig<C>>(), settings, size);
      rows.clock(delay);
      delay.clock(raster, size);
      raster.clock(transform.output(), size);
      transform.clock(in, size);
   }

   /// The same where the configuration has run-time settings or a run-time size. `now`: what the ports show. Thresholds
   /// count in the clock of a start of frame; the size is that of all frames from one reset to the next.
   HLS_INLINE void clock(const CoreInput<C>& in, const Settings& now) {
      clock(in);
      if constexpr (C.run_time_settings) {
         CheckSettings checks;
         checks.uniqueness_percent = now.uniqueness_percent;
         checks.left_right_threshold = now.left_right_threshold;
         checks.first_disparity = now.first_disparity;
         checks.last_disparity = now.last_disparity;
         settings.clock(in, checks);
      }
      if constexpr (C.run_time_size) size.clock(now.image_width, now.image_height);
   }

  private:
   HLS_INLINE void check() {
      const auto& other = slices.last().other;
      const uint8_t other_winner[1] = {other.winner[0][other.kOldest]};
      left_right.clock(refinement.output(slices.last(), texture), other_winner, settings);
   }

   HLS_INLINE Winners<kCodeConfig<C>> checked() const {
      if constexpr (C.has_left_right_check()) return left_right.checked;
      else return refinement.output(slices.last(), texture);
   }

   HLS_INLINE MapGroup<kCodeConfig<C>> map() const {
      if constexpr (kHasMapBlock) return map_block.out;
      else return map_group<kCodeConfig<C>>(checked());
   }
};

}  // namespace stereo::phase_correlation
